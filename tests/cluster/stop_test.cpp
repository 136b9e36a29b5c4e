// Proves, with real processes, how a busy worker handles SIGTERM: it returns work it has not begun,
// finishes running scenarios and ends; it returns scenarios that run too long, too; a second signal
// ends it at once. Other workers do its work, and none of it counts as lost.
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <regex>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Uses a master that soon notices lost workers.
class StopSignal : public MortalCluster {
  protected:
    StopSignal() : MortalCluster({"--heartbeat", "0.05", "--return-within", "0.3"}) {}

    std::unique_ptr<Connection> connection_ = connect();
};

TEST_F(StopSignal, ABusyWorkerHandsBackWhatItHasNotBegunAndEnds) {
    const Job job = make_job(4000);
    Process& leaving = start_worker(1, {"--drain-timeout", "600"});
    const JobId id = submit(*connection_, job, Query{});
    ASSERT_EQ(watch_until(*connection_, id, 500).state, JobState::Running);
    leaving.signal(SIGTERM);
    EXPECT_EQ(leaving.wait(), 0) << leaving.errors();
    const std::string log = leaving.errors();
    EXPECT_THAT(log, Not(HasSubstr("not drained in time")));
    std::smatch found;
    ASSERT_TRUE(
        std::regex_search(log, found, std::regex("draining: running=(\\d+) unanswered=(\\d+)")))
        << log;
    EXPECT_GT(std::stoul(found[2]), std::stoul(found[1])) << "then it had nothing to hand back";

    const auto left = connection_->status();
    ASSERT_TRUE(left);
    EXPECT_TRUE(left.value().workers.empty());
    const JobStatus then = left.value().jobs.at(0);
    EXPECT_EQ(then.state, JobState::Running);
    start_worker();
    const JobStatus status = finish(*connection_, id);
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
    EXPECT_EQ(status.summary.failed, 0u);
    const auto cluster = connection_->status();
    ASSERT_TRUE(cluster);
    EXPECT_EQ(cluster.value().losses.workers_lost, 0u);
    EXPECT_EQ(cluster.value().losses.scenarios_given_back, 0u);
    // The first worker's finished scenarios do not run again, and the rest runs once.
    ASSERT_EQ(cluster.value().workers.size(), 1u);
    EXPECT_EQ(cluster.value().workers[0].scenarios +
                  (status.answered_by_master - then.answered_by_master),
              4000 - then.summary.merged());
}

/// One scenario outlasts any test, and nine take no time.
class StopSignalInALongScenario : public StopSignal {
  protected:
    /// Starts a worker with these options and returns once it runs the long scenario.
    Process& start_worker_inside(const std::vector<std::string>& options) {
        Query query;
        query.level = Level::Count;
        ClusterOptions one_block;
        one_block.depths = {0, 0};
        Process& worker = start_worker(1, options);
        id_ = submit(*connection_, make_long_job(1, 9), query, one_block);
        wait_until_it_is_inside("worker" + std::to_string(workers_.size() - 1));
        return worker;
    }

    void wait_until_it_is_inside(const std::string& name) {
        EXPECT_TRUE(comes_true([&] {
            const auto status = connection_->status();
            return status && std::any_of(status.value().workers.begin(),
                                         status.value().workers.end(),
                                         [&](const WorkerStatus& worker) {
                                             return worker.name == name && worker.longest &&
                                                    worker.longest->scenario == 0;
                                         });
        })) << master_.log();
    }

    /// Expects that another worker takes the long scenario; then drops it and expects all else to
    /// be right.
    void expect_that_another_goes_on() {
        start_worker(1, {"--drain-timeout", "0"});
        wait_until_it_is_inside("worker" + std::to_string(workers_.size() - 1));
        ASSERT_TRUE(connection_->cancel_scenario(id_, 0));
        const JobStatus status = finish(*connection_, id_);
        EXPECT_EQ(status.state, JobState::Done) << status.failure;
        EXPECT_EQ(status.summary.failed, 1u);
        EXPECT_EQ(status.summary.merged(), 10u);
    }

    JobId id_;
};

TEST_F(StopSignalInALongScenario, WhatRunsLongerThanTheDrainTimeoutIsHandedBackToo) {
    Process& leaving = start_worker_inside({"--drain-timeout", "10"});
    leaving.signal(SIGTERM);
    EXPECT_EQ(leaving.wait(), 0) << leaving.errors();
    EXPECT_THAT(leaving.errors(), HasSubstr("not drained in time: running=1"));
    expect_that_another_goes_on();
    const auto cluster = connection_->status();
    ASSERT_TRUE(cluster);
    EXPECT_EQ(cluster.value().losses.workers_lost, 0u);
    EXPECT_EQ(cluster.value().losses.scenarios_given_back, 0u);
}

TEST_F(StopSignalInALongScenario, ASecondSignalEndsItNow) {
    Process& leaving = start_worker_inside({"--drain-timeout", "600000"});
    leaving.signal(SIGTERM);
    ASSERT_TRUE(comes_true(
        [&] { return leaving.errors().find("draining: running=1") != std::string::npos; }));
    EXPECT_TRUE(leaving.is_running());
    leaving.signal(SIGTERM);
    EXPECT_EQ(leaving.wait(), 130) << leaving.errors();
    EXPECT_THAT(leaving.errors(), HasSubstr("ended at once by a second signal"));
    expect_that_another_goes_on();
}

} // namespace
} // namespace cd::tests
