// Proves that results arriving after the end of their job are compared with the stored ones, that a
// wrong worker is exposed, and that the master remembers it.
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

namespace cd::tests {
namespace {

constexpr FailureTimes no_return{.return_within = std::chrono::milliseconds(0)};
constexpr std::uint64_t liars_process = 7;
constexpr std::uint64_t good_process = 8;

JobId run_job(Master& master, const FakeWorker::Habits& habits) {
    const FakeWorker worker(master, habits);
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.done; });
    EXPECT_EQ(client.statuses.back().state, JobState::Done);
    return client.job.value();
}

ScenarioResult wrong_result(std::uint64_t index) {
    ScenarioResult result = right_result(index);
    result.kind = ScenarioClass::Separate;
    result.pair_count = 0;
    result.pairs.clear();
    return result;
}

bool has_alarm(Master& master, const std::string& text) {
    return std::ranges::any_of(
        master.coordinator.cluster_status().alarms,
        [&](const std::string& alarm) { return alarm.find(text) != std::string::npos; });
}

TEST(LateServer, AnEqualLateResultIsAcknowledged) {
    Master master;
    const JobId job = run_job(master, {});
    for (const Scenario& scenario : reference().scenarios) {
        const FakeWorker late(master, {.comes_with = {right_results(job, scenario.index)}});
        master.run_until([&] { return late.kept == 1; });
    }
    EXPECT_EQ(master.coordinator.alarm_count(), 0u);
}

TEST(LateServer, ADifferingLateResultQuarantinesItsWorker) {
    const TemporaryFolder state;
    {
        Master master(no_return, state.path());
        const JobId job = run_job(master, {.instance = good_process});
        const FakeWorker liar(
            master,
            {.instance = liars_process,
             .comes_with = {late_results(job, wrong_result(scenario_with_contact()))}});
        master.run_until([&] { return liar.kept == 1; });
        EXPECT_TRUE(has_alarm(master, "the master's own says that fake"));
        EXPECT_EQ(master.coordinator.quarantined(), std::set{liars_process});
        master.end();
    }
    const Master master(no_return, state.path());
    EXPECT_EQ(master.coordinator.quarantined(), std::set{liars_process});
}

TEST(LateServer, AWrongResultThatWasKeptIsItsAuthorsFault) {
    Master master(no_return);
    const JobId job = run_job(master, {.lies_alone = 1000, .instance = liars_process});
    const FakeWorker good(
        master,
        {.instance = good_process, .comes_with = {right_results(job, scenario_with_contact())}});
    master.run_until([&] { return good.kept == 1; });
    EXPECT_TRUE(has_alarm(master, "is wrong; submit the job again"));
    EXPECT_TRUE(has_alarm(master, "submit them again: " + std::to_string(job.value)));
    EXPECT_EQ(master.coordinator.quarantined(), std::set{liars_process});
}

/// Wrong results of an ended job raise one alarm, which asks to submit the job again.
TEST(LateServer, AJobThatIsWrongIsNamedOnce) {
    Master master(no_return);
    const JobId job = run_job(master, {.lies_alone = 1000, .instance = liars_process});
    std::vector<Results> all;
    for (const Scenario& scenario : reference().scenarios) {
        all.push_back(right_results(job, scenario.index));
    }
    const FakeWorker good(master, {.instance = good_process, .comes_with = all});
    master.run_until([&] { return good.kept == all.size(); });
    const auto alarms = master.coordinator.cluster_status().alarms;
    EXPECT_EQ(std::ranges::count_if(alarms,
                                    [](const std::string& alarm) {
                                        return alarm.ends_with("is wrong; submit the job again");
                                    }),
              1);
}

/// The only result of a job arrives twice, with different content.
TEST(LateServer, AResultDuringTheEndsCommitIsCompared) {
    Master master;
    run_job(master, {.instance = good_process}); // Stores the meshes.
    Grid grid;
    grid.position = {GridAxis{1, 1, 1}, GridAxis{0, 0, 1}, GridAxis{0, 0, 1}};
    Submit submit = reference().submission();
    submit.scenarios = grid.count();
    submit.grid = encode_grid(grid);
    submit.poses.kind = PosesKind::Grid;
    submit.cluster.analysis = AnalysisMode::Never;
    Client client(master);
    client.start_asking({submit});
    const FakeWorker liar(master, {.lies_second = true, .instance = liars_process});
    master.run_until([&] { return liar.kept == 2; });
    ASSERT_TRUE(client.answer && client.answer->has_value());
    const JobId job = std::get<Accepted>(client.answer->value()).job;
    EXPECT_EQ(master.coordinator.job_status(job).value().state, JobState::Done);
    EXPECT_EQ(master.coordinator.quarantined(), std::set{liars_process});
}

} // namespace
} // namespace cd::tests
