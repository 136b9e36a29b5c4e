// Proves what the estimate of more workers counts: the workers' threads, their geometry, and what
// the master does itself. bench/cluster compares it with simulated clusters.
#include "master/dispatch/view/growth.hpp"

#include "common/core/limits/master.hpp"
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {
namespace {

/// Ten workers of four threads, with an hour of work for one thread each.
constexpr WorkersNow ten_workers{10, 40, 4, 0};
constexpr WorkLeft an_hour{1e6, 40 * 3600., 0, 0, 0};

TEST(MoreWorkers, EachHelpsAsMuchAsAPresentOne) {
    EXPECT_NEAR(seconds_left(ten_workers, an_hour, 0), 3600, 0.1);
    EXPECT_NEAR(seconds_left(ten_workers, an_hour, 10), 1800, 0.1);
    const Growth growth = estimate_growth(ten_workers, an_hour);
    EXPECT_NEAR(growth.seconds, 3600, 0.1);
    ASSERT_EQ(growth.more.size(), 11u);
    EXPECT_EQ(growth.more.front().workers, 1u);
    EXPECT_EQ(growth.more.back().workers, 1024u);
    EXPECT_NEAR(growth.more.back().seconds, 3600 * 10 / 1034., 0.1);
    EXPECT_EQ(growth.worth.workers, limits::growth_workers_max);
}

TEST(MoreWorkers, AMasterThatIsBusyMakesThemUseless) {
    WorkLeft work = an_hour;
    work.master_seconds = 1200;
    EXPECT_NEAR(seconds_left(ten_workers, work, 100), 1200, 0.1);
    const Growth growth = estimate_growth(ten_workers, work);
    // 20 more make three times the speed. More than that do not, so 25 add 80 % of their share.
    EXPECT_NEAR(growth.worth.workers, 25, 1);
    EXPECT_NEAR(growth.seconds / growth.worth.seconds, 3, 0.01);
    work.master_seconds = 3600;
    EXPECT_EQ(estimate_growth(ten_workers, work).worth.workers, 0u);
    EXPECT_NEAR(estimate_growth(ten_workers, work).worth.seconds, 3600, 0.1);
    work.master_seconds = 0;
    work.pool_seconds = 1800;
    EXPECT_NEAR(seconds_left(ten_workers, work, 100), 1800, 0.1);
}

TEST(MoreWorkers, NewOnesFetchTheirGeometryFirst) {
    WorkersNow workers = ten_workers;
    workers.fetch_seconds = 60;
    EXPECT_NEAR(seconds_left(workers, an_hour, 10), (3600 + 60 * 0.5) / 2, 0.1);
    EXPECT_NEAR(seconds_left(workers, an_hour, 70), (3600 + 7 * 60 * 1.0) / 8, 0.1);
    // Who would have the geometry after the end does not help.
    WorkLeft work = an_hour;
    work.worker_seconds = 40 * 30.;
    EXPECT_NEAR(seconds_left(workers, work, 1000), seconds_left(workers, work, 0), 1e-9);
}

TEST(MoreWorkers, AScenarioOccupiesOneThread) {
    const WorkLeft few{60, 600, 5, 0, 0};
    EXPECT_NEAR(seconds_left(ten_workers, few, 0), 15 + 5, 1e-9);
    EXPECT_NEAR(seconds_left(ten_workers, few, 5), 10 + 5, 1e-9);
    EXPECT_NEAR(seconds_left(ten_workers, few, 500), 10 + 5, 1e-9);
}

TEST(MoreWorkers, TheNewOnesHaveTheMedianPowerAndThePresentOnesHold) {
    DispatchStage stage;
    const auto join = [&](std::uint64_t id, std::uint32_t threads, double weight) {
        WorkerFacts facts{"w", threads};
        facts.weight = weight;
        return &stage.join(id, facts);
    };
    WorkerProxy* one = join(1, 4, 1);
    join(2, 4, 1);
    join(3, 16, 0.5);
    join(4, 100, 1)->set_draining(); // Takes no work.
    const DispatchJob& job = stage.open("earliest-finish");
    const WorkersNow now = workers_now(stage);
    EXPECT_EQ(now.workers, 3);
    EXPECT_EQ(now.threads, 24);
    EXPECT_NEAR(now.threads_more, 4 * 24 / 16., 1e-9); // 4 of power 16 / 24 on average.
    EXPECT_EQ(now.fetch_seconds, 0);
    const std::vector<RootIndex> roots{0, 1};
    stage.plan.hold(one->slot(), TreeId{1}, roots);
    EXPECT_NEAR(workers_now(stage).fetch_seconds,
                (12'800 / limits::link_bytes_per_second_start + 2 * 20e-6) / 3,
                1e-9);
    EXPECT_EQ(job.id, JobId{1});
    EXPECT_EQ(workers_now(DispatchStage()).threads, 0);
}

} // namespace
} // namespace cd::tests
