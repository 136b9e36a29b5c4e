// Proves that results arriving after the end of their job are acknowledged and change nothing.
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

namespace cd::tests {
namespace {

JobId run_job(Master& master, const FakeWorker::Habits& habits) {
    const FakeWorker worker(master, habits);
    Client client(master, reference().submission());
    client.run_until_done();
    EXPECT_EQ(client.statuses.back().state, JobState::Done);
    return client.job.value();
}

TEST(LateServer, AnEqualLateResultIsAcknowledged) {
    Master master;
    const JobId job = run_job(master, {});
    for (const Scenario& scenario : reference().scenarios) {
        const FakeWorker late(master, {.comes_with = {right_results(job, scenario.index)}});
        master.run_until([&] { return late.kept == 1; });
    }
    EXPECT_EQ(master.alarms(), 0u);
}

TEST(LateServer, ADifferingResultOfAnEndedJobIsOnlyAcknowledged) {
    Master master;
    const JobId job = run_job(master, {});
    const FakeWorker late(
        master, {.comes_with = {late_results(job, wrong_result(scenario_with_contact()))}});
    master.run_until([&] { return late.kept == 1; });
    EXPECT_EQ(master.alarms(), 0u);
    EXPECT_TRUE(master.coordinator.alarms().quarantined().empty());
    EXPECT_EQ(master.status(job).digest, reference().digest);
}

/// The only result of a job arrives twice; the second one differs, and arrives while the job's end
/// is being written.
TEST(LateServer, AResultDuringTheEndsCommitIsOnlyAcknowledged) {
    Master master;
    run_job(master, {}); // Stores the meshes.
    Grid grid;
    grid.position = {GridAxis{1, 1, 1}, GridAxis{0, 0, 1}, GridAxis{0, 0, 1}};
    Submit submit = submission(grid);
    submit.cluster.analysis = AnalysisMode::Never;
    Client client(master);
    client.start_asking({submit});
    const FakeWorker liar(master, {.lies_second = true});
    master.run_until([&] { return liar.kept == 2; });
    ASSERT_TRUE(client.answer && client.answer->has_value());
    const JobId job = std::get<Accepted>(client.answer->value()).job;
    EXPECT_EQ(master.status(job).state, JobState::Done);
    EXPECT_EQ(master.alarms(), 0u);
}

} // namespace
} // namespace cd::tests
