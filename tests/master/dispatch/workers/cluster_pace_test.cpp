// Proves that a worker counts as fast as measured or, unmeasured, as fast as the others.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(ClusterPace, AnUnmeasuredWorkerIsTakenToBeAsFastAsTheOthers) {
    DispatchStage stage;
    WorkerProxy& one = stage.join(1, 4);
    const WorkerProxy& other = stage.join(2, 2);
    EXPECT_EQ(stage.pace.speed_of(one), 1);
    EXPECT_EQ(stage.pace.link_of(one), limits::link_bytes_per_second_start);
    stage.pace.add_work(one, 3'000'000'000, 1);
    stage.pace.add_transfer(one, 1000, 2);
    EXPECT_DOUBLE_EQ(stage.pace.power_of(one), 12);
    EXPECT_DOUBLE_EQ(stage.pace.power_of(other), 6);
    EXPECT_DOUBLE_EQ(stage.pace.link_of(other), 500);
}

TEST(ClusterPace, ARangeGoesAsFastAsMeasuredOrAsScenariosArePredicted) {
    DispatchStage stage;
    const WorkerProxy& one = stage.join(1, 4);
    DispatchJob& job = stage.open("earliest-finish");
    stage.pace.add_scenario(2'000'000);
    EXPECT_DOUBLE_EQ(stage.pace.positions_per_second(one, job), 4 * 500);
    job.range_pace.add(one.id(), 30, 3);
    EXPECT_DOUBLE_EQ(stage.pace.positions_per_second(one, job), 4 * 10);
}

TEST(ClusterPace, PowersHaveWhatIsLeftOfTransfersAndCache) {
    DispatchStage stage;
    const DispatchJob& job = stage.open("earliest-finish");
    WorkerProxy& one = stage.join(1, {"w", 1, 1, 1000 * limits::wide_bytes_per_triangle});
    stage.plan.hold(one.slot(), job.trees.of(0).tree, std::vector<RootIndex>{0, 1, 2, 3});
    one.add_transfer(0, 3);
    stage.pace.time_is(1);
    EXPECT_EQ(stage.pace.powers_of(one, stage.plan).room_bytes,
              600 * limits::wide_bytes_per_triangle);
    EXPECT_EQ(stage.pace.powers_of(one, stage.plan).transfers_seconds, 2);
    stage.pace.time_is(4);
    EXPECT_EQ(stage.pace.powers_of(one, stage.plan).transfers_seconds, 0);
}

} // namespace
} // namespace cd::tests
