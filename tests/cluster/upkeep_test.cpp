// Proves, with real processes, the upkeep of a cluster: a removed job leaves nothing; a mesh goes
// when no job names it; drained workers end well and lose nothing; and a cancelled job keeps the
// results that arrived.
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

class Upkeep : public Cluster {
  protected:
    [[nodiscard]] Ran cdctl(std::vector<std::string> words) const {
        words.insert(words.begin(), tests::cdctl());
        words.insert(words.end(), {"--master", master_->address()});
        return tests::run(words);
    }
    [[nodiscard]] std::size_t files_in(const char* folder) const {
        std::size_t files = 0;
        for (const auto& file : std::filesystem::directory_iterator(folder_ / "state" / folder)) {
            files += file.is_regular_file() ? 1 : 0;
        }
        return files;
    }
    [[nodiscard]] ClusterStatus status() const { return connection_->status().value(); }
    /// Only the first scenario has B inside A; it occupies a worker for longer than any test.
    JobId submit_endless() {
        Query query;
        query.level = Level::Count;
        ClusterOptions one_block;
        one_block.depths = {0, 0};
        return submit(make_long_job(1, 9), query, one_block);
    }
};

TEST_F(Upkeep, AJobThatIsRemovedLeavesNothing) {
    start_worker();
    const JobStatus done = run(make_job(200), Query{});
    ASSERT_EQ(done.state, JobState::Done);
    const std::string id = std::to_string(done.job.value);
    const StateSizes before = status().sizes;
    EXPECT_GT(before.results, 0u);
    EXPECT_GT(before.poses, 0u);
    EXPECT_GT(before.meshes, 0u);
    EXPECT_GT(before.trees, 0u);
    EXPECT_GT(before.free, 0u);

    EXPECT_THAT(cdctl({"status"}).output,
                testing::ContainsRegex("on the master's disk: results [1-9].* poses [1-9].* meshes "
                                       "[1-9].* trees [1-9].* journal [1-9].* free [1-9]"));
    const auto told = nlohmann::json::parse(cdctl({"status", "-o", "json"}).output)["state_bytes"];
    for (const char* part : {"results", "poses", "meshes", "trees", "journal", "free"}) {
        EXPECT_GT(told[part], 0) << part;
    }

    const Ran asked = cdctl({"rm", id});
    EXPECT_EQ(asked.exit_code, 2);
    EXPECT_THAT(asked.errors, HasSubstr("add --yes"));
    ASSERT_EQ(status().jobs.size(), 1u);

    const Ran removed = cdctl({"rm", "last", "--yes"});
    EXPECT_EQ(removed.exit_code, 0) << removed.errors;
    EXPECT_TRUE(status().jobs.empty());
    EXPECT_TRUE(status().meshes.empty());
    EXPECT_TRUE(comes_true([&] { return files_in("jobs") == 1; })) << "`clients`, of the master";
    for (const char* folder : {"meshes", "trees", "blocks"}) {
        EXPECT_EQ(files_in(folder), 0u) << folder;
    }
    const Ran again = cdctl({"rm", id, "--yes"});
    EXPECT_EQ(again.exit_code, 2) << "there is no such job any more";
}

TEST_F(Upkeep, AMeshStaysAsLongAsAJobNamesIt) {
    start_worker();
    const Job job = make_job(100);
    const JobId first = run(job, Query{}).job;
    const JobId second = run(job, Query{}).job;
    const std::string mesh = to_short_hex(job.a->mesh().hash());
    EXPECT_THAT(cdctl({"get", "meshes"}).output, HasSubstr("yes")) << "the job needs them";
    const Ran refused = cdctl({"rm", mesh, "--yes"});
    EXPECT_EQ(refused.exit_code, 5);
    EXPECT_THAT(refused.errors, HasSubstr("needed by a job"));

    EXPECT_EQ(cdctl({"rm", std::to_string(first.value), "--yes"}).exit_code, 0);
    EXPECT_EQ(status().meshes.size(), 2u);
    EXPECT_EQ(cdctl({"results", std::to_string(second.value), "-o", "csv"}).exit_code, 0);
    EXPECT_EQ(cdctl({"rm", std::to_string(second.value), "--yes"}).exit_code, 0);
    EXPECT_TRUE(status().meshes.empty());
}

TEST_F(Upkeep, AMeshThatNoJobNamesIsRemovedWithItsFiles) {
    const auto mesh = share(make_sphere(2));
    // While connected, the client that uploaded a mesh may submit a job that names it.
    ASSERT_TRUE(connect()->upload(std::vector{NamedMesh{"ball", mesh}}, [](auto&&...) {}));
    EXPECT_GT(files_in("meshes"), 0u);
    Ran removed;
    EXPECT_TRUE(comes_true([&] {
        removed = cdctl({"rm", to_short_hex(mesh->hash()), "--yes"});
        return removed.exit_code != 5;
    }));
    EXPECT_EQ(removed.exit_code, 0) << removed.errors;
    EXPECT_THAT(removed.output,
                HasSubstr("mesh " + to_short_hex(mesh->hash()) + " ball removed, "));
    EXPECT_TRUE(status().meshes.empty());
    EXPECT_EQ(files_in("meshes"), 0u);
}

/// Its master keeps one ended job.
class OneJobKept : public Upkeep {
  protected:
    void prepare() override { ::setenv("CDMASTER_KEEP_JOBS", "1", 1); }
    void TearDown() override {
        ::unsetenv("CDMASTER_KEEP_JOBS");
        Upkeep::TearDown();
    }
};

TEST_F(OneJobKept, TheJobThatEndedFirstIsForgotten) {
    start_worker();
    const Job job = make_job(20);
    const JobId first = run(job, Query{}).job;
    const JobId second = run(job, Query{}).job;
    EXPECT_TRUE(comes_true([&] { return status().jobs.size() == 1; }));
    EXPECT_EQ(status().jobs.at(0).job, second);
    EXPECT_EQ(cdctl({"results", std::to_string(first.value), "-o", "csv"}).exit_code, 2);
    EXPECT_EQ(cdctl({"results", std::to_string(second.value), "-o", "csv"}).exit_code, 0);
    const std::string files = folder_ / ("state/jobs/" + std::to_string(first.value));
    for (const char* kind : {".results", ".poses"}) {
        EXPECT_TRUE(comes_true([&] { return !std::filesystem::exists(files + kind); })) << kind;
    }
}

TEST_F(Upkeep, RemovalOfSeveralJobsStopsAtTheFirstError) {
    start_worker();
    const Job job = make_job(20);
    const std::string first = std::to_string(run(job, Query{}).job.value);
    const std::string second = std::to_string(run(job, Query{}).job.value);
    const std::string third = std::to_string(run(job, Query{}).job.value);
    EXPECT_EQ(cdctl({"rm", first, "j-none", "--yes"}).exit_code, 2);
    EXPECT_EQ(status().jobs.size(), 3u) << "each is looked up before one is removed";
    const JobId endless = submit_endless();
    const Ran some = cdctl({"rm", first, std::to_string(endless.value), second, "--yes"});
    EXPECT_EQ(some.exit_code, 5);
    EXPECT_THAT(some.output, testing::MatchesRegex("job j-[0-9a-f]+ removed, .* freed\n"));
    EXPECT_THAT(some.errors,
                testing::MatchesRegex("cdctl: job j-[0-9a-f]+: it is running; with --cancel it is "
                                      "ended first\n"));
    EXPECT_EQ(status().jobs.size(), 3u);
    EXPECT_EQ(cdctl({"rm", second, third, "--yes"}).exit_code, 0);
    EXPECT_EQ(status().jobs.size(), 1u);
    ASSERT_TRUE(connection_->cancel(endless));
}

TEST_F(Upkeep, AJobThatRunsIsRemovedOnlyWhenItIsToBeCancelled) {
    start_worker();
    const std::string id = std::to_string(submit_endless().value);
    const Ran refused = cdctl({"rm", id, "--yes"});
    EXPECT_EQ(refused.exit_code, 5);
    EXPECT_THAT(refused.errors, HasSubstr("--cancel"));
    EXPECT_EQ(status().jobs.size(), 1u);
    const Ran removed = cdctl({"rm", id, "--cancel", "--yes"});
    EXPECT_EQ(removed.exit_code, 0) << removed.errors;
    EXPECT_TRUE(status().jobs.empty());
}

TEST_F(Upkeep, ResultsOfACancelledJobAreFetched) {
    start_worker();
    const JobId id = submit_endless();
    ASSERT_TRUE(comes_true([&] { return status().jobs.at(0).summary.merged() == 9; }));
    const Ran running = cdctl({"results", "last", "-o", "csv"});
    EXPECT_EQ(running.exit_code, 3);
    EXPECT_THAT(running.errors, HasSubstr("incomplete: 9 of 10 scenarios"));
    EXPECT_EQ(std::ranges::count(running.output, '\n'), 10) << "a heading, and nine";

    ASSERT_TRUE(connection_->cancel(id));
    const Ran cancelled =
        cdctl({"results", "last", "--out", (folder_ / "out").string(), "--formats", "csv"});
    EXPECT_EQ(cancelled.exit_code, 3);
    EXPECT_THAT(cancelled.output + cancelled.errors,
                HasSubstr("incomplete: 9 of 10 scenarios have a result; the job is cancelled"));
    std::vector<std::uint64_t> came;
    ASSERT_TRUE(connection_->fetch(id, 0, 10, [&](const ScenarioResult& result) {
        came.push_back(result.index);
        return Status(Done{});
    }));
    EXPECT_EQ(came, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST_F(Upkeep, AWorkerThatIsDrainedEndsWellAndLosesNothing) {
    const Job job = make_job(4000);
    Process& leaving = start_worker();
    const JobId id = submit(job, Query{}, many_blocks());
    ASSERT_TRUE(comes_true([&] { return status().jobs.at(0).summary.merged() > 300; }));
    const Ran told = cdctl({"drain", "worker0"});
    EXPECT_EQ(told.exit_code, 0) << told.errors;
    EXPECT_EQ(leaving.wait(), 0) << leaving.errors();
    EXPECT_THAT(leaving.errors(), HasSubstr("draining: "));
    EXPECT_EQ(status().jobs.at(0).state, JobState::Running);
    EXPECT_EQ(cdctl({"drain", "worker0"}).exit_code, 2) << "it is not here any more";

    start_worker();
    const JobStatus done = finish(id, [](const JobStatus&) {});
    EXPECT_EQ(done.state, JobState::Done) << done.failure;
    EXPECT_EQ(done.digest, job.digest_in_one_process(Query{}));
    EXPECT_EQ(status().losses.workers_lost, 0u);
    EXPECT_EQ(status().losses.scenarios_given_back, 0u);
}

TEST_F(Upkeep, WorkersDrainedAtOnceEndAndOthersTakeTheirWork) {
    Process& leaving = start_worker();
    const JobId id = submit_endless();
    ASSERT_TRUE(comes_true([&] {
        const ClusterStatus now = status();
        return !now.workers.empty() && now.workers[0].longest.has_value();
    }));
    const Ran told = cdctl({"drain", "--all", "--now"});
    EXPECT_EQ(told.exit_code, 0) << told.errors;
    EXPECT_EQ(leaving.wait(), 0) << leaving.errors();
    EXPECT_TRUE(comes_true([&] { return status().workers.empty(); }));

    start_worker();
    EXPECT_TRUE(comes_true([&] {
        const ClusterStatus now = status();
        return !now.workers.empty() && now.workers[0].longest.has_value();
    })) << "another has the scenario now";
    EXPECT_EQ(status().losses.workers_lost, 0u);
    ASSERT_TRUE(connection_->cancel(id));
}

TEST_F(Upkeep, AllWorkersAreDrained) {
    Process& first = start_worker();
    Process& second = start_worker();
    ASSERT_TRUE(comes_true([&] { return status().workers.size() == 2; }));
    const Ran told = cdctl({"drain", "--all"});
    EXPECT_EQ(told.exit_code, 0) << told.errors;
    EXPECT_THAT(told.output, testing::MatchesRegex("w-[0-9]+ drains\nw-[0-9]+ drains\n"));
    EXPECT_EQ(first.wait(), 0) << first.errors();
    EXPECT_EQ(second.wait(), 0) << second.errors();
    EXPECT_EQ(cdctl({"drain"}).exit_code, 2) << "which, is not said";
}

TEST_F(Upkeep, AWorkerDrainedAtOnceByItsIdLosesNothing) {
    const Job job = make_job(4000);
    Process& leaving = start_worker();
    ASSERT_TRUE(comes_true([&] { return status().workers.size() == 1; }));
    const std::string id = "w-" + std::to_string(status().workers[0].worker.value);
    Process& staying = start_worker();
    const JobId running = submit(job, Query{}, many_blocks());
    ASSERT_TRUE(comes_true([&] { return status().jobs.at(0).summary.merged() > 300; }));
    const Ran told = cdctl({"drain", id, "--now"});
    EXPECT_EQ(told.exit_code, 0) << told.errors;
    EXPECT_EQ(told.output, id + " ends\n");
    EXPECT_EQ(leaving.wait(), 0) << leaving.errors();
    const JobStatus done = finish(running, [](const JobStatus&) {});
    EXPECT_EQ(done.state, JobState::Done) << done.failure;
    EXPECT_EQ(done.digest, job.digest_in_one_process(Query{}));
    EXPECT_EQ(status().losses.workers_lost, 0u);
    EXPECT_TRUE(staying.is_running());
}

TEST_F(Upkeep, AJobIsFetchedAsItWasSubmitted) {
    start_worker();
    const Job job = make_job(5000);
    const JobId id = submit(job, Query{}, many_blocks());
    ASSERT_TRUE(connection_->cancel(id));
    const auto described = connection_->job_description(id);
    ASSERT_TRUE(described) << described.error().detail;
    const Submit& submitted = described.value().submit;
    EXPECT_EQ(submitted.owner, connection_->owner());
    EXPECT_THAT(submitted.owner, HasSubstr("@"));
    EXPECT_EQ(submitted.scenarios, 5000u);
    EXPECT_GT(described.value().began, 1'700'000'000u);
    ASSERT_EQ(submitted.bodies.size(), 2u);
    const auto mesh = connection_->fetch_mesh(submitted.bodies[0].mesh);
    ASSERT_TRUE(mesh) << mesh.error().detail;
    EXPECT_EQ(mesh.value().canonical_bytes(), job.a->mesh().canonical_bytes());
    const auto poses = connection_->fetch_poses(id, 0, 5000);
    ASSERT_TRUE(poses) << poses.error().detail;
    EXPECT_EQ(poses.value().scenarios, job.scenarios);
    EXPECT_TRUE(poses.value().labels.is_empty());
    EXPECT_EQ(connection_->fetch_poses(id, 4999, 2).error().code, ErrorCode::BadInput);
    EXPECT_EQ(connection_->job_description(JobId{77}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(connection_->fetch_mesh(Sha256{}).error().code, ErrorCode::NotFound);
}

} // namespace
} // namespace cd::tests
