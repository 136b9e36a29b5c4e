// Proves, with real processes, that a worker leaves by itself if it is told to: drained after some
// time without work, and with exit code 4 after some time without a master.
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>

namespace cd::tests {
namespace {

using testing::HasSubstr;

class Leaving : public MortalCluster {
  protected:
    /// Whether the job's geometry is prepared, so that a worker gets work at once.
    bool is_prepared(JobId id) {
        const auto status = connection_->status();
        return status && std::any_of(status.value().jobs.begin(),
                                     status.value().jobs.end(),
                                     [&](const JobStatus& job) {
                                         return job.job == id && !job.depths.empty();
                                     });
    }

    /// Whether some worker has computed one scenario for longer than `time`.
    bool runs_one_for(std::chrono::milliseconds time) {
        const auto status = connection_->status();
        return status && std::any_of(status.value().workers.begin(),
                                     status.value().workers.end(),
                                     [&](const WorkerStatus& worker) {
                                         return worker.longest &&
                                                worker.longest->seconds * 1000 > time.count();
                                     });
    }

    std::unique_ptr<Connection> connection_ = connect();
};

TEST_F(Leaving, AnIdleWorkerStaysWhileItWorksAndThenDrains) {
    Query query;
    query.level = Level::Count;
    ClusterOptions one_block;
    one_block.depths = {0, 0};
    const JobId id = submit(*connection_, make_long_job(1, 9), query, one_block);
    ASSERT_TRUE(comes_true([&] { return is_prepared(id); })) << master_.log();
    Process& worker = start_worker(1, {"--idle-exit", "3"});
    ASSERT_TRUE(comes_true([&] { return runs_one_for(std::chrono::seconds(7)); })) << master_.log();
    EXPECT_TRUE(worker.is_running()) << worker.errors();
    ASSERT_TRUE(connection_->cancel_scenario(id, 0));
    EXPECT_EQ(finish(*connection_, id).summary.merged(), 10u);

    EXPECT_EQ(worker.wait(), 0) << worker.errors();
    EXPECT_THAT(worker.errors(), HasSubstr("leaving, there was no work: seconds=3"));
    EXPECT_THAT(worker.errors(), HasSubstr("ended: exit_code=0"));
    const auto cluster = connection_->status();
    ASSERT_TRUE(cluster);
    EXPECT_TRUE(cluster.value().workers.empty());
    EXPECT_EQ(cluster.value().losses.workers_lost, 0u);
}

TEST_F(Leaving, AnOrphanEndsAndNamesWhatNoMasterTook) {
    const Job job = make_job(4000);
    const JobId id = submit(*connection_, job, Query{});
    ASSERT_TRUE(comes_true([&] { return is_prepared(id); })) << master_.log();
    Process& orphan = start_worker(1, {"--orphan-exit", "7", "--idle-exit", "5"});
    ASSERT_EQ(watch_until(*connection_, id, 500).state, JobState::Running);
    connection_.reset();
    master_.kill();
    EXPECT_EQ(orphan.wait(), 4) << orphan.errors();
    EXPECT_THAT(orphan.errors(), HasSubstr("leaving, there was no master: seconds=7"));
    EXPECT_THAT(orphan.errors(),
                testing::ContainsRegex("results that no master took: job=" +
                                       std::to_string(id.value) + " scenarios=[1-9]"));

    master_.start();
    connection_ = connect();
    start_worker();
    const JobStatus status = finish(*connection_, id);
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.digest, job.digest_in_one_process(Query{}));
}

TEST_F(Leaving, AMasterThatComesBackInTimeKeepsItsWorker) {
    const Job job = make_job(2000);
    Process& worker = start_worker(1, {"--orphan-exit", "60"});
    const JobId id = submit(*connection_, job, Query{});
    ASSERT_EQ(watch_until(*connection_, id, 200).state, JobState::Running);
    restart_master(connection_);
    EXPECT_EQ(finish(*connection_, id).digest, job.digest_in_one_process(Query{}));
    EXPECT_TRUE(worker.is_running()) << worker.errors();
}

} // namespace
} // namespace cd::tests
