// Proves that trust survives a restart: the master still knows quarantined workers, each result's
// author, withdrawn results, disputes and alarms; no job ends with an exposed worker's answers; and
// losses caused by a scenario keep counting.
#include "common/core/limits/master.hpp"
#include "master/geometry/mesh_file.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/journal_writer.hpp"
#include "tests/master/master_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

constexpr std::uint64_t liars_process = 7;
constexpr std::uint64_t good_process = 8;

/// Waits until the master has noticed that its workers are gone.
void wait_until_gone(Master& master) {
    master.run_until([&] {
        return std::ranges::all_of(master.cluster().workers, [](const WorkerStatus& worker) {
            return worker.state == WorkerState::Lost;
        });
    });
}

/// The worker returns and behaves well.
void expect_in_quarantine(Master& master, std::uint64_t process) {
    const FakeWorker again(master, {.instance = process});
    master.run_until_quarantined();
    master.run_until([&] {
        const auto running = master.cluster().jobs;
        return std::ranges::count(running, JobState::Running, &JobStatus::state) == 0;
    });
    EXPECT_EQ(again.batches + again.ranges, 0u);
}

/// Exposes a wrong worker. Its other answers are withdrawn when the master ends.
ClusterStatus run_to_the_alarm(Master& master, AnalysisMode mode) {
    submit_to(master, submission(mode));
    const FakeWorker liar(master, {.lies_first = true, .lies_alone = 3, .instance = liars_process});
    master.run_until_quarantined();
    master.end();
    return master.cluster();
}

/// A state folder with a job that no worker has done.
struct AcceptedJob {
    AcceptedJob() {
        Master master(no_return, state.path());
        job = submit_to(master, submission(AnalysisMode::Always));
    }

    TemporaryFolder state;
    JobId job;
    std::filesystem::path mesh = mesh_path(state.path(), reference().a.hash());
};

/// One worker dies of the scenario in each incarnation of the master.
TEST(ServerRestart, AScenarioThatTakesItsWorkersDownFailsAfterAsManyAsWithoutARestart) {
    const std::uint64_t deadly = scenario_with_contact();
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        const TemporaryFolder state;
        JobId job;
        for (std::uint64_t life = 0; life < limits::scenario_losses_max; ++life) {
            Master master(no_return, state.path());
            if (life == 0) {
                job = submit_to(master, submission(mode));
            }
            EXPECT_EQ(master.status(job).summary.failed, 0u);
            const FakeWorker mortal(master, {.dies_of = deadly, .instance = 100 + life});
            master.run_until([&] { return mortal.ended; });
            wait_until_gone(master);
            master.end();
        }
        Master master(no_return, state.path());
        EXPECT_EQ(master.status(job).summary.failed, 1u);
        const FakeWorker last(master, {.dies_of = deadly, .instance = 200});
        master.run_until([&] { return master.status(job).state != JobState::Running; });
        const JobStatus status = master.status(job);
        EXPECT_EQ(status.state, JobState::Done) << status.failure;
        EXPECT_EQ(status.summary.failed, 1u);
        EXPECT_EQ(status.summary.merged(), reference().scenarios.size());
        EXPECT_FALSE(last.ended);
    }
}

/// The mesh is damaged and mended, or missing and returns by hand or with another job.
TEST(ServerRestart, AJobWhoseMeshIsDamagedOrMissingWaitsUntilThatIsMended) {
    enum class Way { Mended, BroughtBack, Resubmitted };
    for (const Way way : {Way::Mended, Way::BroughtBack, Way::Resubmitted}) {
        const AcceptedJob accepted;
        const std::string whole = read_text(accepted.mesh);
        std::string damaged = whole;
        damaged[50] = static_cast<char>(damaged[50] ^ 1);
        if (way == Way::Mended) {
            write_text(accepted.mesh, damaged);
        } else {
            std::filesystem::remove(accepted.mesh);
        }
        Master master(no_return, accepted.state.path());
        const FakeWorker worker(master, {});
        master.run_until([&] { return !master.status(accepted.job).paused.empty(); });
        const JobStatus status = master.status(accepted.job);
        EXPECT_THAT(status.paused, HasSubstr(accepted.mesh.filename().string()));
        EXPECT_EQ(status.state, JobState::Running);
        if (way == Way::Resubmitted) {
            submit_to(master, submission(AnalysisMode::Always));
        } else {
            write_text(accepted.mesh, whole);
        }
        expect_right_end(master, accepted.job);
    }
}

/// Another build of cdmaster has accepted it.
TEST(ServerRestart, AJobOfAnUnknownStrategyFailsAndNamesTheKnownOnes) {
    const TemporaryFolder state;
    const JobId job{1};
    {
        JobRecord record = job_record(job, 1);
        record.submit.cluster.strategy = "of-tomorrow";
        record.submit.poses.kind = PosesKind::Grid;
        record.submit.grid = encode_grid(Grid());
        Writer writer(state.path());
        ASSERT_NE(ResultStore::create(writer.journal->results_path(job), job, 1), nullptr);
        writer.wait_for(writer.journal->add(AcceptJob{record}));
    }
    Master master(no_return, state.path());
    master.run_until([&] { return master.status(job).state != JobState::Running; });
    EXPECT_EQ(master.status(job).state, JobState::Failed);
    EXPECT_THAT(master.status(job).failure, HasSubstr("this master has best-match, "));
}

/// Follows the advice of the message about a damaged mesh.
TEST(ServerRestart, ADamagedMeshMayBeMovedAwayAndSubmittedAgain) {
    const AcceptedJob accepted;
    write_text(accepted.mesh, "rubbish");
    Master master(no_return, accepted.state.path());
    const FakeWorker worker(master, {});
    const auto paused = [&] { return master.status(accepted.job).paused; };
    master.run_until([&] { return paused().find("move it away") != std::string::npos; });
    std::filesystem::rename(accepted.mesh, accepted.state / "away");
    master.run_until([&] { return paused().find("is missing") != std::string::npos; });
    submit_to(master, submission(AnalysisMode::Always));
    expect_right_end(master, accepted.job);
}

TEST(ServerRestart, QuarantineAlarmsAndWithdrawalsOutlastARestart) {
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        const TemporaryFolder state;
        ClusterStatus before;
        {
            Master master(no_return, state.path());
            before = run_to_the_alarm(master, mode);
        }
        ASSERT_GT(before.alarm_count, 0u);
        ASSERT_GT(before.jobs.at(0).withdrawn, 1u);
        Master master(no_return, state.path());
        const ClusterStatus after = master.cluster();
        EXPECT_EQ(after.alarms, before.alarms);
        EXPECT_EQ(after.alarm_count, before.alarm_count);
        EXPECT_EQ(after.jobs.at(0).withdrawn, before.jobs.at(0).withdrawn);
        EXPECT_EQ(after.jobs.at(0).summary.merged(), before.jobs.at(0).summary.merged());
        FakeWorker good(master, {.instance = good_process});
        expect_in_quarantine(master, liars_process);
        expect_right_end(master, after.jobs.at(0).job);
    }
}

/// The job's analysis in the next incarnation starts with all scenarios. Before, one worker has
/// answered some, and another was lost with all the others.
JobId job_to_be_analysed(const std::filesystem::path& state) {
    JobId job;
    {
        Master master(no_return, state);
        job = submit_to(master, submission(AnalysisMode::Never));
        const FakeWorker worker(master, {.instance = good_process, .batches_max = 1});
        master.run_until([&] { return worker.kept == 1; });
    }
    Writer writer(state);
    const RecoveredJob& known = writer.recovered.jobs.at(0);
    AddResults add{job, known.results, {}, known.progress, {}};
    add.losses = {{{0, reference().scenarios.size()}, liars_process}};
    writer.wait_for(writer.journal->add(std::move(add)));
    return job;
}

TEST(ServerRestart, ReturnedResultsSkipAnalysis) {
    const TemporaryFolder state;
    const JobId job = job_to_be_analysed(state.path());
    Master master({}, state.path());
    master.run_until_prepared(job);
    const AnalysisInput input = master.coordinator.jobs().explainer().input(job).value();
    const auto results = master.coordinator.jobs().find(job)->results;
    std::optional<Analysis> separate; // The only scenario missing from the worker's results.
    std::vector<Results> brought;
    for (const Scenario& scenario : reference().scenarios) {
        Analysis analysis = analyse(input, scenario);
        if (results->has(scenario.index)) {
            continue;
        }
        if (!separate && analysis.finished) {
            separate = std::move(analysis);
        } else {
            brought.push_back(right_results(job, scenario.index));
        }
    }
    ASSERT_TRUE(separate);
    ASSERT_GT(brought.size(), reference().scenarios.size() / 3) << "then this shows little";
    const JobStatus before = master.status(job);
    ASSERT_EQ(before.answered_by_master, 0u);

    const FakeWorker worker(master, {.instance = good_process, .comes_with = brought});
    expect_right_end(master, job);
    EXPECT_EQ(master.status(job).answered_by_master, 1u);
    EXPECT_EQ(master.status(job).statistics.search.box_tests - before.statistics.search.box_tests,
              separate->cost.search.box_tests);
}

/// The master died after it had recorded a quarantine and before the withdrawal from another job.
TEST(ServerRestart, AnUnfinishedWithdrawalIsFinished) {
    const TemporaryFolder state;
    JobId job;
    {
        Master master(no_return, state.path());
        job = submit_to(master, submission(AnalysisMode::Never));
        const FakeWorker liar(master,
                              {.lies_alone = 3, .instance = liars_process, .batches_max = 3});
        master.run_until([&] { return liar.kept == 3; });
    }
    {
        Writer writer(state.path());
        const RecoveredJob& known = writer.recovered.jobs.at(0);
        AddResults add{job, known.results, {}, known.progress, {}};
        add.alarms.emplace().quarantine(liars_process);
        writer.wait_for(writer.journal->add(std::move(add)));
    }
    Master master(no_return, state.path());
    EXPECT_GT(master.status(job).withdrawn, 0u);
    const FakeWorker good(master, {.instance = good_process});
    expect_right_end(master, job);
}

TEST(ServerRestart, AnOldWrongResultWithdrawsItsAuthorsResults) {
    const TemporaryFolder state;
    JobId ended;
    JobId job;
    std::optional<std::uint64_t> wrong;
    {
        Master master(no_return, state.path());
        ended = submit_to(master, submission(AnalysisMode::Never));
        {
            const FakeWorker still_good(master, {.instance = liars_process});
            expect_right_end(master, ended);
        }
        job = submit_to(master, submission(AnalysisMode::Never));
        {
            const FakeWorker liar(master,
                                  {.lies_alone = 3, .instance = liars_process, .batches_max = 3});
            master.run_until([&] { return liar.kept == 3; });
        }
        wait_until_gone(master);
        wrong =
            wrong_scenario(*master.coordinator.jobs().find(job)->results); // All results so far.
    }
    ASSERT_TRUE(wrong);
    Master master(no_return, state.path());
    EXPECT_EQ(master.alarms(), 0u);
    // No earlier worker is here. A new one brings a contradicting result, as after a speculative
    // copy.
    std::uint64_t missing = 0; // The job waits for it.
    while (master.has_result(job, missing)) {
        ++missing;
    }
    FakeWorker good(
        master,
        {.instance = good_process, .comes_with = {right_results(job, *wrong)}, .holds = missing});
    master.run_until([&] { return master.alarms() != 0; });
    good.go_on();
    expect_right_end(master, job);
    const ClusterStatus status = master.cluster();
    ASSERT_FALSE(status.alarms.empty());
    const std::string named = "check them with cdctl verify: " + std::to_string(ended.value);
    EXPECT_TRUE(std::ranges::any_of(status.alarms, [&](const std::string& alarm) {
        return alarm.ends_with(named);
    })) << status.alarms.back();
    expect_in_quarantine(master, liars_process);
}

/// The master ends after it has recorded two differing results and before its verdict.
TEST(ServerRestart, ADisputeThatWasOpenIsSettled) {
    for (const FakeWorker::Habits& habits :
         {FakeWorker::Habits{.lies_first = true, .instance = liars_process, .batches_max = 1},
          FakeWorker::Habits{.lies_second = true, .instance = liars_process, .batches_max = 1}}) {
        const TemporaryFolder state;
        JobId job;
        {
            Master master({}, state.path());
            job = submit_to(master, submission(AnalysisMode::Never));
            master.run_until_prepared(job);
            const auto runs = occupy(master.blocking);
            {
                const FakeWorker liar(master, habits);
                master.run_until([&] { return liar.kept == 2; });
            }
            EXPECT_EQ(master.alarms(), 0u);
            master.end();
            runs->count_down();
        }
        Master master(no_return, state.path());
        EXPECT_EQ(master.alarms(), 0u);
        master.run_until([&] { return master.alarms() != 0; });
        FakeWorker good(master, {.instance = good_process});
        expect_in_quarantine(master, liars_process);
        expect_right_end(master, job);
    }
}

} // namespace
} // namespace cd::tests
