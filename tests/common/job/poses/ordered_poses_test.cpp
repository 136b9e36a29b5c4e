// Proves that the order of scenarios is a permutation within each window and depends on the window
// alone; and that a grid keeps its order.
#include "common/job/poses/ordered_poses.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/poses/pose_order.hpp"
#include "tests/support/scenarios.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace cd::tests {
namespace {

/// Counts reads, and fails on demand.
class CountingSource final : public PoseSource {
  public:
    explicit CountingSource(std::vector<Scenario> scenarios) : scenarios_(std::move(scenarios)) {}
    [[nodiscard]] std::uint64_t count() const override { return scenarios_.size(); }
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override {
        ++reads;
        if (fails) {
            return Error{ErrorCode::Io, "the disk is gone"};
        }
        const auto begin = scenarios_.begin() + static_cast<std::ptrdiff_t>(first);
        return std::vector<Scenario>(begin, begin + static_cast<std::ptrdiff_t>(count));
    }
    int reads = 0;
    bool fails = false;

  private:
    std::vector<Scenario> scenarios_;
};

TEST(OrderedPoses, EachWindowHasItsScenariosOnceInCoherentOrder) {
    const std::uint64_t window = limits::order_window_scenarios;
    const auto submitted = numbered_scenarios(window + 1000);
    OrderedPoses ordered(std::make_shared<CountingSource>(submitted));
    const auto handed_out = ordered.read(0, submitted.size()).value();
    ASSERT_EQ(handed_out.size(), submitted.size());
    std::set<std::uint64_t> seen;
    for (std::size_t place = 0; place < handed_out.size(); ++place) {
        const Scenario& scenario = handed_out[place];
        ASSERT_EQ(scenario, submitted[scenario.index]);
        ASSERT_EQ(scenario.index / window, place / window);
        seen.insert(scenario.index);
    }
    EXPECT_EQ(seen.size(), submitted.size());
    const auto last = std::span(submitted).subspan(window);
    const auto order = coherent_order(last);
    for (std::size_t i = 0; i < order.size(); ++i) {
        ASSERT_EQ(handed_out[window + i].index, window + order[i]);
    }
}

TEST(OrderedPoses, PlacesAndIndicesAreInverse) {
    const auto submitted = numbered_scenarios(500);
    OrderedPoses ordered(std::make_shared<CountingSource>(submitted));
    const auto window = ordered.window_of(17).value();
    for (std::uint64_t index = 0; index < 500; ++index) {
        ASSERT_TRUE(window->has(index));
        EXPECT_EQ(window->at({window->position_of(index), 1})[0].index, index);
    }
    EXPECT_FALSE(window->has(500));
}

TEST(OrderedPoses, AWindowIsReadOnceWhileItIsInUse) {
    auto source = std::make_shared<CountingSource>(numbered_scenarios(2000));
    OrderedPoses ordered(source);
    for (std::uint64_t first = 0; first < 2000; first += 250) {
        ASSERT_TRUE(ordered.read(first, 250));
    }
    EXPECT_EQ(source->reads, 1);
}

TEST(OrderedPoses, AReadErrorIsReturnedAndNotCached) {
    auto source = std::make_shared<CountingSource>(numbered_scenarios(10));
    source->fails = true;
    OrderedPoses ordered(source);
    EXPECT_EQ(ordered.read(2, 3).error().detail, "the disk is gone");
    source->fails = false;
    EXPECT_TRUE(ordered.read(2, 3));
}

TEST(OrderedPoses, AGridStaysAsItIs) {
    Grid grid;
    grid.position[0] = {0, 1, 7};
    grid.position[2] = {-1, 1, 5};
    OrderedPoses ordered(make_grid_source(grid));
    ASSERT_NE(ordered.grid(), nullptr);
    EXPECT_EQ(*ordered.grid(), grid);
    const auto scenarios = ordered.read(3, 20).value();
    for (std::uint64_t i = 0; i < 20; ++i) {
        EXPECT_EQ(scenarios[i], scenario_on(grid, 3 + i));
    }
}

} // namespace
} // namespace cd::tests
