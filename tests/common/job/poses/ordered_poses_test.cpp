// Proves that a window has each of its scenarios once, by position and by index, that a range is
// packed as its scenarios are, and that a grid keeps its order.
#include "common/job/poses/ordered_poses.hpp"

#include "common/job/packed_scenarios.hpp"
#include "common/job/poses/pose_order.hpp"
#include "tests/support/packed_poses.hpp"
#include "tests/support/scenarios.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace cd::tests {
namespace {

PackedScenarios opened(const std::vector<Scenario>& scenarios) {
    return PackedScenarios::open(pack_scenarios(scenarios), scenarios.size()).value();
}

TEST(OrderedPoses, EachWindowHasItsScenariosOnceInCoherentOrder) {
    const std::uint64_t window = limits::order_window_scenarios;
    const auto submitted = numbered_scenarios(window + 1000);
    const auto poses = ordered(submitted);
    const auto handed_out = poses->read(0, submitted.size()).value();
    ASSERT_EQ(handed_out.size(), submitted.size());
    std::set<std::uint64_t> seen;
    for (std::size_t position = 0; position < handed_out.size(); ++position) {
        const Scenario& scenario = handed_out[position];
        ASSERT_EQ(scenario, submitted[scenario.index]);
        ASSERT_EQ(scenario.index / window, position / window);
        seen.insert(scenario.index);
    }
    EXPECT_EQ(seen.size(), submitted.size());
    const auto last = std::span(submitted).subspan(window);
    const auto order = coherent_order(last);
    for (std::size_t i = 0; i < order.size(); ++i) {
        ASSERT_EQ(handed_out[window + i].index, window + order[i]);
    }
    const auto across = poses->read_submitted(window - 10, 20).value();
    EXPECT_TRUE(std::ranges::equal(across, std::span(submitted).subspan(window - 10, 20)));
}

TEST(OrderedPoses, PositionsAndIndicesAreInverse) {
    const auto submitted = numbered_scenarios(5000);
    const auto window = ordered(submitted)->window_of(17).value();
    ASSERT_EQ(window->count(), 5000u);
    for (std::uint64_t index = 0; index < 5000; ++index) {
        ASSERT_TRUE(window->has(index));
        const std::uint64_t position = window->position_of(index);
        ASSERT_EQ(window->index_at(position), index);
        ASSERT_EQ(window->bodies_at(position), ScenarioBodies{});
        ASSERT_EQ(window->at(position).value(), submitted[index]);
    }
    EXPECT_FALSE(window->has(5000));
}

TEST(OrderedPoses, ARangeIsPackedAsItsScenariosAre) {
    const auto poses = ordered(numbered_scenarios(3 * limits::pose_run_scenarios));
    const auto window = poses->window_of(0).value();
    std::mt19937_64 random(4);
    for (int round = 0; round < 100; ++round) {
        const std::uint64_t first = random() % poses->count();
        const std::uint64_t count = 1 + random() % (poses->count() - first);
        ASSERT_EQ(unpack_scenarios(window->packed({first, count}), count).value(),
                  poses->read(first, count).value());
    }
}

TEST(OrderedPoses, AWindowWithoutEachIndexOnceIsRefused) {
    auto scenarios = numbered_scenarios(3);
    EXPECT_TRUE(PoseWindow::open(0, {opened(scenarios)}));
    EXPECT_FALSE(PoseWindow::open(1, {opened(scenarios)}));
    EXPECT_FALSE(PoseWindow::open(0, {opened(scenarios), opened(scenarios)})) << "a short run";
    scenarios[1].index = 2;
    EXPECT_FALSE(PoseWindow::open(0, {opened(scenarios)}));
}

TEST(OrderedPoses, AWindowIsReadOnceWhileItIsInUse) {
    const auto runs = std::make_shared<PackedPoses>(numbered_scenarios(2000));
    OrderedPoses poses(runs);
    for (std::uint64_t first = 0; first < 2000; first += 250) {
        ASSERT_TRUE(poses.read(first, 250));
    }
    EXPECT_EQ(runs->reads, 1);
}

TEST(OrderedPoses, AReadErrorIsReturnedAndNotCached) {
    const auto runs = std::make_shared<PackedPoses>(numbered_scenarios(10));
    runs->failures = 1;
    OrderedPoses poses(runs);
    EXPECT_EQ(poses.read(2, 3).error().detail, "the disk is gone");
    EXPECT_TRUE(poses.read(2, 3));
}

TEST(OrderedPoses, AGridStaysAsItIs) {
    Grid grid;
    grid.position[0] = {0, 1, 7};
    grid.position[2] = {-1, 1, 5};
    OrderedPoses poses(grid);
    ASSERT_NE(poses.grid(), nullptr);
    EXPECT_EQ(*poses.grid(), grid);
    const auto scenarios = poses.read(3, 20).value();
    for (std::uint64_t i = 0; i < 20; ++i) {
        EXPECT_EQ(scenarios[i], scenario_on(grid, 3 + i));
    }
}

} // namespace
} // namespace cd::tests
