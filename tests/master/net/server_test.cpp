// Proves that a master in this process completes jobs over loopback with the digest of the same
// scenarios without a cluster, and refuses invalid client messages.
#include "common/core/host/boot_id.hpp"
#include "common/core/timing/master.hpp"
#include "common/job/packed_scenarios.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace cd::tests {
namespace {

TEST(Server, RecordsArePackedUnlessTheClientRunsOnThisHost) {
    Master master;
    FakeWorker worker(master, {});
    Client owner(master);
    owner.start(reference().submission());
    owner.expect_right();
    std::vector<Bytes> records;
    for (const std::uint64_t id_of_client : {boot_id() + 1, boot_id()}) {
        Client client(master);
        client.boot_id = id_of_client;
        client.start_asking({ResultsQuery{*owner.job, 0, 1000}});
        client.run_until_done();
        const auto part = std::get<ResultsPart>(client.answer->value());
        EXPECT_EQ(part.count, reference().scenarios.size());
        EXPECT_EQ(part.are_packed, id_of_client != boot_id());
        Bytes unpacked;
        const auto plain = received_records(part.records, part.are_packed, unpacked).value();
        records.emplace_back(plain.begin(), plain.end());
    }
    EXPECT_EQ(records[0], records[1]);
}

TEST(Server, AJobHasTheDigestOfTheSameScenariosWithoutACluster) {
    // Every class must occur, or agreement proves little.
    ASSERT_GT(reference().summary.cross, 10u);
    ASSERT_GT(reference().summary.separate, 10u);
    for (const std::string_view strategy : strategy_names()) {
        Master master;
        FakeWorker one(master, {});
        FakeWorker two(master, {});
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.strategy = strategy;
        submit.cluster.claim = strategy != "best-match";
        client.start(submit);
        client.expect_right();
        EXPECT_EQ(client.meshes_sent, 2u);
        EXPECT_GT(client.statuses.back().answered_by_master, 0u);
        EXPECT_GT(client.statuses.back().statistics.search.box_tests, 0u);
        // No job uses the trees any more.
        master.run_until([&] { return one.trees_removed + two.trees_removed >= 2; });
    }
}

TEST(Server, TheDigestIsEqualWithAndWithoutAnalysis) {
    for (const AnalysisMode mode :
         {AnalysisMode::Auto, AnalysisMode::Always, AnalysisMode::Never}) {
        Master master;
        FakeWorker one(master, {});
        FakeWorker two(master, {.answers_twice = true});
        Client(master, submission(mode)).expect_right();
        EXPECT_EQ(one.ranges + two.ranges != 0, mode == AnalysisMode::Never) << to_text(mode);
        EXPECT_EQ(one.batches + two.batches == 0, mode == AnalysisMode::Never) << to_text(mode);
    }
}

TEST(Server, AWorkerMayComeAfterTheJob) {
    Master master;
    Client client(master, reference().submission());
    master.run_until([&] { return client.job.has_value(); });
    FakeWorker late(master, {});
    client.expect_right();
}

/// Returns the link seconds a worker must expect for the first blocks of a job after it has done
/// one.
double expected_transfer(bool says_what_it_holds) {
    Master master;
    FakeWorker worker(master, {.says_what_it_holds = says_what_it_holds});
    for (const bool is_first : {true, false}) {
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.strategy = "earliest-finish";
        client.start(submit);
        if (is_first) {
            client.run_until_done();
            continue;
        }
        // The job has no task yet when its geometry is there, even before its client hears of it.
        const auto job = [&] {
            const std::vector<JobStatus> jobs = master.cluster().jobs;
            const auto running = std::ranges::find(jobs, JobState::Running, &JobStatus::state);
            return running == jobs.end() ? JobId{} : running->job;
        };
        master.run_until(
            [&] { return master.coordinator.jobs().explainer().input(job()).has_value(); });
        Analysis analysis;
        analysis.roots_a = {0};
        analysis.roots_b = {0};
        const auto explained = master.coordinator.jobs().explainer().explain(job(), 0, analysis);
        return explained.value().workers.at(0).transfer;
    }
    return 0;
}

TEST(Server, TransfersToAWorkerAreMeasured) {
    const double assumed = expected_transfer(false);
    const double measured = expected_transfer(true);
    EXPECT_GT(assumed, 0);
    EXPECT_GT(measured, 0);
    EXPECT_NE(measured, assumed);
}

TEST(Server, JobsOfSeveralClientsRunSideBySideAndMeshesAreSentOnce) {
    Master master;
    FakeWorker worker(master, {});
    Client first(master, reference().submission());
    master.run_until([&] { return first.job.has_value(); });
    Submit other = reference().submission();
    other.cluster.set_depth(0, 6);
    Client second(master, other);
    first.expect_right();
    second.expect_right();
    EXPECT_NE(first.job, second.job);
    EXPECT_EQ(second.meshes_sent, 0u);
}

TEST(Server, AGridNeedsNoPoses) {
    Master master;
    FakeWorker worker(master, {});
    Client(master, reference().submission()).run_until_done();

    Grid grid;
    grid.position = {GridAxis{-1.5, 1.5, 7}, GridAxis{-1, 1, 3}, GridAxis{0, 0, 1}};
    for (int axis = 0; axis < 3; ++axis) {
        grid.rotation[static_cast<std::size_t>(axis)] = rotation_axis({0, 0, 1}, axis);
    }
    const JobId job = std::get<Accepted>(answer_to(master, {submission(grid)})).job;
    master.run_until([&] { return master.status(job).state == JobState::Done; });
    EXPECT_EQ(master.status(job).summary.merged(), 21u);
}

TEST(Server, ACancelledJobEndsAndItsStatusSaysSo) {
    Master master;
    Client client(master, reference().submission()); // Without workers, the job never ends.
    master.run_until([&] { return !client.statuses.empty(); });
    const auto begin = std::chrono::steady_clock::now();
    const Message answer = answer_to(master, {Cancel{*client.job}});
    client.run_until_done();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, timing::cancel_wait_max / 2);
    EXPECT_EQ(client.statuses.back().state, JobState::Cancelled);
    EXPECT_EQ(std::get<JobStatus>(answer).state, JobState::Cancelled);
}

TEST(Server, AJobGetsAnotherPriority) {
    Master master;
    Client client(master, reference().submission()); // Without workers, the job never ends.
    master.run_until([&] { return !client.statuses.empty(); });
    const Message answer = answer_to(master, {SetPriority{*client.job, 6}});
    EXPECT_EQ(std::get<JobStatus>(answer).turn.priority, 6);
    master.run_until([&] { return client.statuses.back().turn.priority == 6; });
    EXPECT_THAT(refusal_of(master, {SetPriority{*client.job, 11}}),
                testing::HasSubstr("the priority is 11 and may be -10 to 10"));
    EXPECT_THAT(refusal_of(master, {SetPriority{JobId{99}, 1}}), testing::HasSubstr("no such job"));
    (void)answer_to(master, {Cancel{*client.job}});
    EXPECT_THAT(refusal_of(master, {SetPriority{*client.job, 1}}),
                testing::HasSubstr("the job has ended"));
}

TEST(Server, InvalidSubmissionsAreRefusedWithAReason) {
    Master master;
    submit_to(master, reference().submission());

    const auto expect_failure = [&](const std::vector<Message>& messages, const char* words) {
        EXPECT_THAT(refusal_of(master, messages), testing::HasSubstr(words));
    };
    const Submit good = reference().submission();
    const auto with = [&](auto change) {
        Submit submit = good;
        change(submit);
        return std::vector<Message>{submit};
    };
    expect_failure(with([](Submit& s) { s.bodies.pop_back(); }), "two bodies");
    expect_failure(with([](Submit& s) { s.bodies[1].mesh = Sha256{}; }), "not stored");
    expect_failure(with([](Submit& s) { s.name = "a\nb"; }), "job's name is not printable");
    expect_failure({MeshPart{Sha256{}, "x\x1b[2J", 100, 0, Bytes(100)}},
                   "mesh's name is not printable");
    expect_failure(with([](Submit& s) { s.cluster.set_depth(0, 21); }), "depth of body a");
    expect_failure(with([](Submit& s) { s.cluster.q = 0; }), "q is 0");
    expect_failure(with([](Submit& s) { s.cluster.strategy = "fastest"; }), "has best-match, ");
    expect_failure(with([](Submit& s) { s.cluster.v_kb = 0; }), "v_kb");
    expect_failure(with([](Submit& s) { s.scenarios = ~0ull; }), "number of scenarios");
    expect_failure(with([](Submit& s) { s.query.ignored = {{0, 1u << 30, 0, 1}}; }), "outside");
    expect_failure(with([](Submit& s) { s.poses.axes.resize(5); }), "six axes");
    expect_failure(with([](Submit& s) { s.ignore = {{"wheel", "a\nb"}}; }), "ignored parts");
    expect_failure(with([](Submit& s) {
                       s.grid = Bytes(3);
                       s.poses.kind = PosesKind::Grid;
                   }),
                   "");
    // Fewer poses than announced; then more.
    const std::span<const Scenario> all(reference().scenarios);
    expect_failure({good, PosesEnd{}}, "announced");
    expect_failure({good, PosesPart{pack_scenarios(all.first(10))}, PosesEnd{}}, "come together");
    Submit one = good;
    one.scenarios = 1;
    expect_failure({one, PosesPart{pack_scenarios(all.first(2))}, PosesEnd{}}, "");
    expect_failure({PosesEnd{}}, "without a job");
    expect_failure({Cancel{JobId{99}}}, "no such job");
    expect_failure({Watch{JobId{99}}}, "no such job");
    expect_failure({ResultsQuery{JobId{99}, 0, 1}}, "no such job");
    expect_failure({EndOfTask{}}, "does not send");
    // One mesh whose bytes do not match its hash, and one whose upload starts in the middle.
    const Bytes bytes(100);
    expect_failure({MeshPart{Sha256{}, "x", 100, 0, bytes}}, "");
}

TEST(Server, TheStatusOfTheClusterTellsOfWorkersJobsAndMeshes) {
    Master master;
    FakeWorker worker(master, {});
    Client(master, reference().submission()).run_until_done();
    const auto status = std::get<ClusterStatus>(answer_to(master, {StatusQuery{}}));
    ASSERT_EQ(status.workers.size(), 1u);
    EXPECT_EQ(status.workers[0].name, "fake");
    EXPECT_EQ(status.workers[0].scenarios + status.jobs.at(0).answered_by_master,
              reference().scenarios.size());
    EXPECT_GE(status.workers[0].tasks, 1u);
    EXPECT_EQ(status.workers[0].subtrees_sent, worker.blocks);
    EXPECT_GT(status.workers[0].subtree_bytes_sent, 0u);
    EXPECT_GT(status.workers[0].bytes_sent, status.workers[0].subtree_bytes_sent);
    EXPECT_GT(status.workers[0].bytes_received, 0u);
    EXPECT_GT(status.workers[0].scenarios_per_second, 0);
    EXPECT_EQ(status.meshes.size(), 2u);
    EXPECT_GT(status.cpu_seconds, 0);
}

} // namespace
} // namespace cd::tests
