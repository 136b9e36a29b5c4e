// Proves what a run keeps in its folder: its inputs if they fit, with one hash whether kept or not;
// and that a signal ends the work before and after the scenarios, too.
#include "client/folder/folder_run.hpp"

#include "client/base/interrupt.hpp"
#include "client/folder/extracted_case.hpp"
#include "client/folder/folder_exports.hpp"
#include "client/folder/opened_run.hpp"
#include "client/folder/run_recorder.hpp"
#include "client/local/local_run.hpp"
#include "client/poses/nearness.hpp"
#include "client/remote/mesh_cache.hpp"
#include "client/spec/job_options.hpp"
#include "tests/support/obj_file.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class FolderRunTest : public testing::Test {
  protected:
    FolderRunTest() {
        write_obj(folder_ / "a.obj", make_torus(1.0, 0.4, 24, 12));
        write_obj(folder_ / "b.obj", make_sphere(1));
    }

    /// Prepares a job of random poses, or of a pose file for both bodies.
    [[nodiscard]] PreparedJob prepare(std::uint64_t count, const std::string& out) {
        JobOptions options;
        options.a = folder_ / "a.obj";
        options.b = folder_ / "b.obj";
        options.poses.file = poses_;
        options.poses.of_both = !poses_.empty();
        options.poses.random = poses_.empty() ? std::optional(count) : std::nullopt;
        options.output.dir = folder_ / out;
        auto spec = make_job_spec(options);
        EXPECT_TRUE(spec);
        auto job = prepare_job(std::move(spec.value()), Trees::Always, cache_, pool_);
        EXPECT_TRUE(job);
        return std::move(job.value());
    }

    /// Runs to the end, or up to so many results.
    [[nodiscard]] static Result<RunReport>
    run(PreparedJob& job, FolderRun& run, std::uint64_t results_max = UINT64_MAX) {
        auto done = run.done();
        if (!done) {
            return done.error();
        }
        LocalRunOptions options;
        options.done = std::move(done.value());
        std::uint64_t taken = 0;
        const auto add = [&](const DoneScenario& result) {
            return taken++ < results_max ? run.add(result) : Status(interrupted());
        };
        const RunObserver observer{[&](const DoneBlock& results) {
                                       return results_max == UINT64_MAX ? run.add(results)
                                                                        : results.for_each(add);
                                   },
                                   [](const Summary&, double) {},
                                   [] { return false; }};
        ThreadPool pool(1);
        const auto outcome =
            run_locally(TreesByBody(job.trees), *job.poses, job.query, pool, observer, options);
        if (!outcome) {
            const Status kept = run.keep();
            return kept ? outcome.error() : kept.error();
        }
        RunReport report;
        report.summary = outcome.value().summary;
        report.digest = outcome.value().digest;
        const Status finished = run.finish(report, "text", std::nullopt);
        return finished ? Result<RunReport>(std::move(report)) : finished.error();
    }

    /// Runs a job of 300 poses to its end.
    RunReport run_into(const std::string& out, FolderRunOptions options = {}) {
        PreparedJob job = prepare(300, out);
        auto begun = FolderRun::begin(job, std::move(options));
        EXPECT_TRUE(begun);
        auto report = run(job, begun.value());
        EXPECT_TRUE(report) << report.error().detail;
        return std::move(report.value());
    }

    [[nodiscard]] RunManifest manifest(const std::string& out) {
        auto read = read_run_json(folder_ / out / "run.json");
        EXPECT_TRUE(read);
        return read.value();
    }

    const TemporaryFolder folder_;
    std::string poses_; ///< A file; empty: random.
    ThreadPool pool_{1};
    TreeCache cache_{fs::path()};
};

} // namespace

TEST_F(FolderRunTest, InputsThatAreTooLargeAreNotKeptAndThatIsTold) {
    // Scenarios have more bytes than estimated, which only writing them reveals.
    std::string rows = "scenario,body,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n";
    for (int i = 0; i < 300; ++i) {
        const std::string number = std::to_string(i);
        rows += number + ",a,1,0,0,0.5,0,1,0,0,0,0,1,0\n";
        rows += number + ",b,0,-1,0," + std::to_string(0.01 * i) + ",1,0,0,0,0,0,1,0\n";
    }
    write_text(folder_ / "poses.csv", rows);
    poses_ = folder_ / "poses.csv";
    const RunReport kept = run_into("kept");
    EXPECT_THAT(summary_text(kept), Not(HasSubstr("inputs")));
    const std::uint64_t poses = fs::file_size(folder_ / "kept" / "inputs" / "scenarios");
    ASSERT_GT(poses, 25'000);
    const std::uint64_t meshes = bytes_beside_poses(prepare(300, "x"));

    for (const std::uint64_t bytes_max : {meshes - 1, meshes + 19'300, meshes + poses - 500}) {
        SCOPED_TRACE(bytes_max);
        FolderRunOptions options;
        options.inputs_bytes_max = bytes_max;
        const std::string out = std::to_string(bytes_max);
        const RunReport report = run_into(out, options);
        EXPECT_THAT(summary_text(report),
                    HasSubstr("  inputs        not kept, since they are too large"));
        EXPECT_FALSE(fs::exists(folder_ / out / "inputs"));
        EXPECT_EQ(manifest(out).poses.hash, manifest("kept").poses.hash);
        EXPECT_EQ(manifest(out).outcome.digest, manifest("kept").outcome.digest);
    }
}

TEST_F(FolderRunTest, AUsersFileUnderTheNameOfAResultIsNeverReplacedUnasked) {
    for (const char* name :
         {"records", "maps", "inputs/scenarios", "inputs/ids", "groups.csv", "contacts.vtp"}) {
        SCOPED_TRACE(name);
        const std::string out = "of-user-" + fs::path(name).filename().string();
        fs::create_directories((folder_ / out / name).parent_path());
        write_text(folder_ / out / name, "of the user");
        PreparedJob job = prepare(3, out);
        const auto begun = FolderRun::begin(job, {});
        ASSERT_FALSE(begun);
        EXPECT_THAT(begun.error().detail, HasSubstr(" without a run.json"));
        EXPECT_EQ(read_text(folder_ / out / name), "of the user");
    }
}

TEST_F(FolderRunTest, AFolderThatCannotBeLockedIsNotSaidToBeInUse) {
    fs::create_directories(folder_ / "out" / ".part" / "lock");
    PreparedJob job = prepare(3, "out");
    const auto begun = FolderRun::begin(job, {});
    ASSERT_FALSE(begun);
    EXPECT_THAT(begun.error().detail, HasSubstr("lock: Is a directory"));
}

TEST_F(FolderRunTest, WhatAnotherProcessIsWritingIsNotRead) {
    run_into("out");
    const RunManifest finished = manifest("out");
    fs::create_directories(folder_ / "out" / ".part");
    const auto writer = DiskFile::lock(folder_ / "out" / ".part" / "lock");
    ASSERT_TRUE(writer);
    write_text(folder_ / "out" / "run.json", "half of a run.json");
    PreparedJob job = prepare(3, "out");
    EXPECT_THAT(FolderRun::begin(job, {}).error().detail, HasSubstr("in use by another process"));
    EXPECT_THAT(RunFolder::open_finished(folder_ / "out", finished).error().detail,
                HasSubstr("in use by another process"));
}

TEST_F(FolderRunTest, FilesAreNotAddedToARunThatReplacedTheirs) {
    run_into("out");
    const RunManifest before = manifest("out");
    FolderRunOptions options;
    options.folder.fresh = true;
    options.command = "another";
    run_into("out", options);
    const auto folder = RunFolder::open_finished(folder_ / "out", before);
    ASSERT_FALSE(folder);
    EXPECT_THAT(folder.error().detail, HasSubstr("out was changed by another process"));
    EXPECT_FALSE(fs::exists(folder_ / "out" / ".part"));
    EXPECT_TRUE(RunFolder::open_finished(folder_ / "out", manifest("out")));
}

TEST_F(FolderRunTest, ADamagedMeshIsImportedAgainOnceItIsRemovedOrWrittenByAFreshRun) {
    run_into("out");
    const auto meshes = [&] { return OpenedRun::open(folder_ / "out").value().meshes(); };
    const fs::path copy =
        mesh_file_path(folder_ / "out" / "inputs" / "meshes", manifest("out").bodies[0].mesh);
    write_text(copy, "damaged");
    const std::string refusal =
        copy.string() + " is damaged: it has another SHA-256; remove it to import " +
        (folder_ / "a.obj").string() + " again, or run the job again with --fresh";
    EXPECT_EQ(meshes().error().detail, refusal);
    FolderRunOptions options;
    options.folder.fresh = true;
    run_into("out", options);
    EXPECT_TRUE(meshes());

    write_text(copy, "damaged");
    EXPECT_EQ(meshes().error().detail, refusal);
    fs::remove(copy);
    EXPECT_TRUE(meshes());
}

TEST_F(FolderRunTest, TheRateOfAResumedRunCountsWhatWasRunThen) {
    Result<RunReport> report{RunReport()};
    {
        PreparedJob job = prepare(300, "out");
        auto begun = FolderRun::begin(job, {});
        ASSERT_TRUE(begun);
        report = run(job, begun.value());
        ASSERT_TRUE(report);
    }
    report.value().execution.seconds = 2;
    report.value().execution.resumed_at = 100;
    const auto opened = OpenedRun::open(folder_ / "out");
    ASSERT_TRUE(opened);
    const auto context = export_context(opened.value());
    ASSERT_TRUE(context);
    ASSERT_TRUE(write_summary(folder_ / "out", context.value(), report.value()));
    const auto again = add_exports(opened.value(), nullptr, context.value(), {});
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value().execution.resumed_at, 100u);
    EXPECT_THAT(summary_text(again.value()), HasSubstr(" 100 scenarios/s"));
}

TEST_F(FolderRunTest, WithoutInputsNoPosesAreWritten) {
    PreparedJob job = prepare(300, "out");
    FolderRunOptions options;
    options.keep_inputs = false;
    auto begun = FolderRun::begin(job, options);
    ASSERT_TRUE(begun);
    EXPECT_FALSE(run(job, begun.value(), 100));
    EXPECT_TRUE(fs::exists(folder_ / "out" / ".part" / "records"));
    EXPECT_FALSE(fs::exists(folder_ / "out" / ".part" / "scenarios"));
}

TEST_F(FolderRunTest, ARunOfRandomPosesGoesOnUnderTheSameHash) {
    run_into("whole");
    for (const bool keeps_inputs : {true, false}) {
        const std::string out = keeps_inputs ? "with" : "without";
        FolderRunOptions options;
        options.keep_inputs = keeps_inputs;
        {
            PreparedJob job = prepare(300, out);
            auto begun = FolderRun::begin(job, options);
            ASSERT_TRUE(begun);
            EXPECT_FALSE(run(job, begun.value(), 100));
        }
        run_into(out, options);
        EXPECT_EQ(manifest(out).poses.hash, manifest("whole").poses.hash);
        EXPECT_EQ(manifest(out).outcome.digest, manifest("whole").outcome.digest);
        EXPECT_EQ(fs::exists(folder_ / out / "inputs"), keeps_inputs);
    }
    EXPECT_EQ(read_text(folder_ / "with" / "inputs" / "scenarios").size(),
              read_text(folder_ / "whole" / "inputs" / "scenarios").size());
}

TEST_F(FolderRunTest, ASignalEndsTheWorkBeforeAndAfterTheScenarios) {
    run_into("whole");
    PreparedJob job = prepare(300, "out");
    {
        auto begun = FolderRun::begin(job, {});
        ASSERT_TRUE(begun);
        ASSERT_FALSE(run(job, begun.value(), 299));
        const InterruptGuard guard;
        ASSERT_EQ(std::raise(SIGINT), 0);
        const auto is_interrupted = [](const auto& result) {
            return !result && result.error().code == ErrorCode::Interrupted;
        };
        EXPECT_TRUE(is_interrupted(begun.value().done()));
        RunReport report;
        EXPECT_TRUE(is_interrupted(begun.value().finish(report, "text", std::nullopt)));
        EXPECT_TRUE(is_interrupted(hash_of(*job.poses, &InterruptGuard::has_come)));
        EXPECT_TRUE(is_interrupted(nearness_hint(
            *job.meshes[0], *job.meshes[1], *job.poses, "m", "pose", &InterruptGuard::has_come)));
    }
    EXPECT_FALSE(fs::exists(folder_ / "out" / "run.json"));
    const InterruptGuard no_signal_yet;
    run_into("out");
    EXPECT_EQ(manifest("out").outcome.digest, manifest("whole").outcome.digest);
}

TEST_F(FolderRunTest, ASignalEndsExportsAndCases) {
    run_into("out");
    auto run = OpenedRun::open(folder_ / "out");
    ASSERT_TRUE(run);
    auto folder = RunFolder::open_finished(folder_ / "out", run.value().manifest());
    ASSERT_TRUE(folder);
    const auto context = export_context(run.value());
    ASSERT_TRUE(context);
    const PreparedJob job = prepare(300, "x");
    CaseScenarios scenarios;
    scenarios.scenarios = job.poses->read(0, 1).value();
    scenarios.results = {run.value().records().find(0).value()->result};
    ASSERT_TRUE(write_case(job, scenarios, {false, {}}, folder_ / "case", pool_));

    const InterruptGuard guard;
    ASSERT_EQ(std::raise(SIGINT), 0);
    const auto exported =
        add_exports(run.value(), &folder.value(), context.value(), {{"csv-pairs"}, "text", true});
    ASSERT_FALSE(exported);
    EXPECT_EQ(exported.error().code, ErrorCode::Interrupted);
    EXPECT_FALSE(fs::exists(folder_ / "out" / ".part"));
    for (const bool minimal : {false, true}) {
        const Status written = write_case(
            job, scenarios, {minimal, &InterruptGuard::has_come}, folder_ / "case", pool_);
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code, ErrorCode::Interrupted);
        EXPECT_FALSE(fs::exists(folder_ / "case" / "job.toml"));
    }
}

TEST_F(FolderRunTest, AKeptMapThatIsCutShortIsRefused) {
    const fs::path path = folder_ / "maps";
    ASSERT_TRUE(write_maps(path, ContactMap(), 5));
    EXPECT_TRUE(read_maps(path));
    fs::resize_file(path, fs::file_size(path) - 1);
    const auto cut = read_maps(path);
    ASSERT_FALSE(cut);
    EXPECT_THAT(cut.error().detail, HasSubstr(path.string() + " is damaged"));
}

TEST_F(FolderRunTest, ResultsAreOnTheDiskWhenThePeriodIsOverOrABlockIsFull) {
    DoneScenario done;
    done.record = encode_result(done.result);
    const auto add = [&](RunRecorder& recorder, std::uint64_t index) {
        done.result.index = index;
        done.record = encode_result(done.result);
        EXPECT_TRUE(recorder.add(done));
    };
    fs::create_directories(folder_ / "short");
    auto at_once = RunRecorder::open(folder_ / "short", nullptr, std::chrono::milliseconds(0));
    ASSERT_TRUE(at_once);
    add(at_once.value(), 0);
    EXPECT_EQ(at_once.value().kept(), 1u);

    fs::create_directories(folder_ / "long");
    auto later = RunRecorder::open(folder_ / "long", nullptr, std::chrono::hours(1));
    ASSERT_TRUE(later);
    for (std::uint64_t i = 0; i < 4095; ++i) {
        add(later.value(), i);
    }
    ASSERT_TRUE(later.value().flush_if_due());
    EXPECT_EQ(later.value().kept(), 0u);
    add(later.value(), 4095);
    EXPECT_EQ(later.value().kept(), 4096u);

    DoneBlock block;
    for (std::uint64_t i = 4096; i < 4096 + 3000; ++i) {
        done.result.index = i;
        block.add(done.result);
    }
    ASSERT_TRUE(later.value().add(block));
    EXPECT_EQ(later.value().kept(), 4096u);
    DoneBlock next;
    for (std::uint64_t i = 7096; i < 9000; ++i) {
        done.result.index = i;
        next.add(done.result);
    }
    ASSERT_TRUE(later.value().add(next));
    EXPECT_EQ(later.value().kept(), 7096u);
    ASSERT_TRUE(later.value().finish());
    const auto records = RecordFile::open(folder_ / "long" / "records");
    ASSERT_TRUE(records);
    std::uint64_t seen = 0;
    ASSERT_TRUE(records.value().for_each([&](const RecordView& record) {
        EXPECT_EQ(record.result.index, seen++);
        return Status(Done{});
    }));
    EXPECT_EQ(seen, 9000u);
}

TEST_F(FolderRunTest, EachFormatIsTakenOnce) {
    JobOptions options;
    options.a = options.b = folder_ / "a.obj";
    options.poses.random = 1;
    options.output.formats = {"csv", "npz", "csv"};
    EXPECT_THAT(make_job_spec(options).value().output.formats, testing::ElementsAre("csv", "npz"));
    write_text(folder_ / "job.toml",
               "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nrandom = { n = 1 }\n"
               "[output]\nformats = [\"csv\", \"csv\"]\n");
    JobOptions of_file;
    of_file.file = folder_ / "job.toml";
    EXPECT_THAT(make_job_spec(of_file).value().output.formats, testing::ElementsAre("csv"));
}

} // namespace cd::tests
