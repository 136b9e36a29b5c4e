// Proves when a scenario is suspect or lost, and the order of unsent positions.
#include "master/dispatch/job/dispatch_job.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(DispatchScenario, IsSuspectBeforeTheLossThatIsItsLast) {
    DispatchScenario scenario;
    for (std::uint32_t lost = 1; lost < limits::scenario_losses_max; ++lost) {
        EXPECT_FALSE(scenario.is_suspect());
        scenario.losses.add(lost);
    }
    EXPECT_TRUE(scenario.is_suspect());
    EXPECT_FALSE(scenario.is_lost_for_good());
    scenario.losses.add(99);
    EXPECT_TRUE(scenario.is_lost_for_good());
}

TEST(UnsentPositions, GoOutInOrderAndRangeByRange) {
    UnsentPositions unsent;
    unsent.add({{10, 5}}, 7);
    unsent.add({{30, 2}}, 4);
    EXPECT_EQ(unsent.count(), 7u);
    EXPECT_EQ(unsent.rest(), 11u);
    EXPECT_EQ(unsent.take_first(3).positions, (PositionRange{10, 3}));
    EXPECT_EQ(unsent.take_first(9).positions, (PositionRange{13, 2}));
    unsent.nothing_follows();
    EXPECT_EQ(unsent.rest(), 2u);
    EXPECT_EQ(unsent.take_all(), (std::vector<PositionRange>{{30, 2}}));
    EXPECT_TRUE(unsent.is_empty());
    EXPECT_EQ(unsent.count(), 0u);
}

TEST(UnsentPositions, ReturnedOnesComeFirstWithTheirPosesAndAnsweredOnesLeave) {
    const auto window = std::make_shared<const PoseWindow>(PoseWindow::open(0, {}).value());
    UnsentPositions unsent;
    unsent.add({{20, 5}}, 0);
    unsent.put_back(PositionSet::of({3, 7, 8}), window);
    EXPECT_EQ(unsent.all(), (std::vector<PositionRange>{{3, 1}, {7, 2}, {20, 5}}));
    EXPECT_TRUE(unsent.remove(PositionSet::of({3, 8, 22, 99})));
    EXPECT_FALSE(unsent.remove(PositionSet::of({3, 99})));
    EXPECT_EQ(unsent.all(), (std::vector<PositionRange>{{7, 1}, {20, 2}, {23, 2}}));
    EXPECT_EQ(unsent.count(), 5u);
    EXPECT_EQ(unsent.take_first(2), (GivenRange{{7, 1}, window}));
    EXPECT_EQ(unsent.take_first(2).window, nullptr);
}

} // namespace
} // namespace cd::tests
