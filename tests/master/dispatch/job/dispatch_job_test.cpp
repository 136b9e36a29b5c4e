// Proves when a scenario is suspect or lost, how it leaves a task, and the order of unsent
// positions.
#include "master/dispatch/job/dispatch_job.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(DispatchScenario, IsSuspectBeforeTheLossThatIsItsLast) {
    DispatchScenario scenario;
    for (std::uint32_t lost = 1; lost < limits::scenario_losses_max; ++lost) {
        EXPECT_FALSE(scenario.is_suspect());
        scenario.losses.add(lost);
        EXPECT_FALSE(scenario.may_be_copied());
    }
    EXPECT_TRUE(scenario.is_suspect());
    EXPECT_FALSE(scenario.is_lost_for_good());
    scenario.losses.add(99);
    EXPECT_TRUE(scenario.is_lost_for_good());
}

TEST(DispatchScenario, LeavingATaskLeavesItsCopyInTheOther) {
    DispatchScenario scenario;
    scenario.where = Whereabouts::Sent;
    scenario.worker = WorkerId{1};
    scenario.task = TaskId{1};
    scenario.copy = Assignment{WorkerId{2}, TaskId{2}};
    EXPECT_TRUE(scenario.is_in(TaskId{1}) && scenario.is_in(TaskId{2}));
    EXPECT_TRUE(scenario.leave_task(TaskId{1}));
    EXPECT_EQ(scenario.worker, WorkerId{2});
    EXPECT_EQ(scenario.task, TaskId{2});
    EXPECT_FALSE(scenario.leave_task(TaskId{2}));
}

TEST(UnsentPlaces, GoOutInOrderAndRangeByRange) {
    UnsentPlaces places;
    places.add({10, 5}, 7);
    places.add({30, 2}, 4);
    EXPECT_EQ(places.count(), 7u);
    EXPECT_EQ(places.rest(), 11u);
    EXPECT_EQ(places.take_first(3), (PlaceRange{10, 3}));
    EXPECT_EQ(places.take_first(9), (PlaceRange{13, 2}));
    places.nothing_follows();
    EXPECT_EQ(places.rest(), 2u);
    EXPECT_EQ(places.take_all(), (std::vector<PlaceRange>{{30, 2}}));
    EXPECT_TRUE(places.is_empty());
    EXPECT_EQ(places.count(), 0u);
}

} // namespace
} // namespace cd::tests
