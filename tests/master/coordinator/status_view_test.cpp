// Proves what clients are told of jobs that wait, and of the cluster.
#include "master/coordinator/status_view.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

constexpr JobId job{1};

/// Takes no notice of the workers.
class NoEvents : public WorkerEvents {
  public:
    void worker_joined(WorkerId /*worker*/, const Hello& /*hello*/) override {}
    void worker_replaced(WorkerId /*worker*/) override {}
    void worker_resumed(WorkerId /*worker*/) override {}
    void worker_detached(WorkerId /*worker*/) override {}
    void worker_silent(WorkerId /*worker*/) override {}
    void worker_heard_again(WorkerId /*worker*/) override {}
    void worker_left(WorkerId /*worker*/) override {}
    [[nodiscard]] WorkerStatus work_of(WorkerId /*worker*/) const override { return {}; }
};

class Statuses : public testing::Test {
  protected:
    Statuses() { board_.add(MasterJob(job, {}, nullptr, now_)); }
    /// A worker joins whose longest scenario of the job has run for so long.
    void join(double seconds) {
        Hello hello;
        hello.name = "sim";
        hello.instance = ++instance_;
        const Reception reception = workers_.receive(hello, "");
        workers_.join(reception,
                      hello,
                      Channel::make(std::make_unique<Stream>(asio::ip::tcp::socket(context_))));
        Heartbeat heartbeat;
        heartbeat.longest = RunningScenario{job, instance_, seconds};
        workers_.heartbeat_came(reception.worker, heartbeat);
    }
    [[nodiscard]] StatusView view() const { return {board_, workers_, alarms_, paused_, now_}; }
    [[nodiscard]] JobStatus status() const { return view().job(job).value(); }

    asio::io_context context_;
    NoEvents events_;
    Clock::time_point now_{};
    JobTable board_;
    WorkerDirectory workers_{{}, 1, events_, [this] { return now_; }};
    Alarms alarms_;
    std::string paused_;
    std::uint64_t instance_ = 0;
};

TEST_F(Statuses, AJobThatIsNotThereIsNotFound) {
    EXPECT_EQ(view().job(JobId{2}).error().code, ErrorCode::NotFound);
}

TEST_F(Statuses, ARunningJobTellsWhyTheJournalDoesNotWrite) {
    board_.find(job)->run->paused = "its poses cannot be read";
    EXPECT_EQ(status().paused, "its poses cannot be read");
    paused_ = "the disk is full";
    EXPECT_EQ(status().paused, "the disk is full");
    EXPECT_EQ(view().cluster().jobs.at(0).paused, "the disk is full");
    board_.end(*board_.find(job), JobState::Cancelled, "", now_);
    (void)board_.announce(*board_.find(job));
    EXPECT_EQ(status().paused, "");
}

TEST_F(Statuses, OnlyLongScenariosAreNamedAndNotTooMany) {
    join(timing::scenario_seconds_shown - 1);
    EXPECT_TRUE(status().long_scenarios.empty());
    join(timing::scenario_seconds_shown);
    ASSERT_EQ(status().long_scenarios.size(), 1u);
    EXPECT_EQ(status().long_scenarios[0].scenario, 2u);
    EXPECT_EQ(status().long_scenarios[0].worker, WorkerId{2});
    EXPECT_EQ(status().long_scenarios[0].name, "sim");
    for (std::size_t i = 0; i < limits::long_scenarios_shown; ++i) {
        join(timing::scenario_seconds_shown);
    }
    EXPECT_EQ(status().long_scenarios.size(), limits::long_scenarios_shown);
}

TEST_F(Statuses, TheClusterHasItsWorkersAndAlarms) {
    join(0);
    alarms_.raise("two results differ");
    const ClusterStatus cluster = view().cluster();
    EXPECT_EQ(cluster.workers.at(0).name, "sim");
    EXPECT_EQ(cluster.alarm_count, 1u);
    EXPECT_EQ(cluster.alarms.size(), 1u);
    now_ += 1s;
    EXPECT_DOUBLE_EQ(view().job(job).value().seconds, 1);
}

} // namespace
} // namespace cd::tests
