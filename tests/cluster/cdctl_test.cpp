// Proves the README's promises about cdctl: one digest with and without a cluster on real models,
// the exit codes, and one-line errors that name a remedy.
#include "client/formats/npz.hpp"
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/npz_arrays.hpp"

#include <gmock/gmock.h>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Writes closed boxes of 1 m as OBJ files.
void write_boxes(const TemporaryFolder& folder) {
    write_obj(folder / "box.obj", make_box({1, 1, 1}));
}

} // namespace

class CdctlOnModels : public Cluster {
  protected:
    /// Expects one digest from one thread, two threads and a cluster.
    void expect_one_digest(const std::filesystem::path& a, const std::filesystem::path& b);
};

void CdctlOnModels::expect_one_digest(const std::filesystem::path& a,
                                      const std::filesystem::path& b) {
    write_text(folder_ / "job.toml",
               "[a]\nmesh = \"" + a.string() + "\"\n[b]\nmesh = \"" + b.string() +
                   "\"\n[poses]\nrandom = { n = 200, seed = 3, penetration = [0.01, 0.05] }\n"
                   "[query]\nlevel = \"contacts\"\n[output]\ndir = \"" +
                   (folder_ / "out").string() +
                   "\"\nformats = [\"csv\", \"npz\", \"json\", \"text\"]\n");
    const std::string job = folder_ / "job.toml";
    const Ran one = tests::run({cdctl(), "run", job, "--threads", "1"});
    const Ran two = tests::run({cdctl(), "run", job, "--threads", "2", "--fresh"});
    start_worker();
    start_worker();
    const Ran cluster =
        tests::run({cdctl(), "run", job, "--fresh", "--master", master_->address()});

    EXPECT_EQ(one.exit_code, 0) << one.errors;
    EXPECT_EQ(cluster.exit_code, 0) << cluster.errors;
    EXPECT_EQ(digest_of(one).size(), 16u) << digest_of(one);
    EXPECT_EQ(digest_of(two), digest_of(one));
    EXPECT_EQ(digest_of(cluster), digest_of(one));
    EXPECT_THAT(one.output, HasSubstr("tested 200 of 200"));

    const auto arrays = read_npz(folder_ / "out" / "results.npz");
    ASSERT_TRUE(arrays) << arrays.error().detail;
    EXPECT_EQ(arrays.value().at("offsets").shape[0], 201u);
    EXPECT_EQ(arrays.value().at("pairs").shape[1], 2u);
    EXPECT_GT(std::filesystem::file_size(folder_ / "out" / "results.jsonl"), 1000u);
}

TEST_F(CdctlOnModels, FindsTheSameWithAndWithoutAMasterOnRealModels) {
    CD_NEEDS_MODEL(sedan, "sedan.obj");
    CD_NEEDS_MODEL(wheel, "lugged_wheel.obj");
    expect_one_digest(sedan, wheel);
}

TEST_F(CdctlOnModels, FindsTheSameWithAndWithoutAMasterOnTori) {
    write_obj(folder_ / "large.obj", make_torus(1, 0.4, 96, 48));
    write_obj(folder_ / "small.obj", make_torus(0.5, 0.1, 48, 24));
    expect_one_digest(folder_ / "large.obj", folder_ / "small.obj");
}

TEST_F(Cluster, SubmitWaitResultsAndGetSpeakOfTheSameJob) {
    write_boxes(folder_);
    write_text(folder_ / "poses.csv",
               "x,y,z,qx,qy,qz,qw\n3,0,0,0,0,0,1\n1,0,0,0,0,0,1\n0.5,0.2,0.1,0,0,0,1\n");
    write_text(folder_ / "job.toml",
               "name = \"boxes\"\n[a]\nmesh = \"box.obj\"\n[b]\nmesh = \"box.obj\"\n"
               "[poses]\nfile = \"poses.csv\"\n");
    start_worker();
    const std::string at = master_->address();
    const Ran submitted = tests::run({cdctl(), "submit", folder_ / "job.toml", "--master", at});
    ASSERT_EQ(submitted.exit_code, 0) << submitted.errors;
    const std::string id = submitted.output.substr(0, submitted.output.find_first_of(" \n"));

    const Ran waited = tests::run({cdctl(), "wait", id, "--master", at});
    EXPECT_EQ(waited.exit_code, 0) << waited.errors;
    const Ran watched = tests::run({cdctl(), "watch", id, "--master", at});
    EXPECT_EQ(watched.exit_code, 0) << watched.errors;
    const Ran results = tests::run({cdctl(), "results", id, "--master", at, "-o", "json"});
    EXPECT_EQ(results.exit_code, 0) << results.errors;
    EXPECT_THAT(results.output, HasSubstr("\"class\":\"separate\""));
    EXPECT_THAT(results.output, HasSubstr("\"class\":\"touch\""));
    EXPECT_THAT(results.output, HasSubstr("\"class\":\"cross\""));
    for (const char* what : {"jobs", "workers", "meshes"}) {
        for (const char* format : {"json", "wide", "csv", "name"}) {
            const Ran got = tests::run({cdctl(), "get", what, "--master", at, "-o", format});
            EXPECT_EQ(got.exit_code, 0) << got.errors;
            EXPECT_FALSE(got.output.empty()) << what << format;
        }
    }
    EXPECT_EQ(tests::run({cdctl(), "get", "jobs", "--master", at, "-o", "name"}).output, id + "\n");
    const Ran status = tests::run({cdctl(), "status", "--master", at});
    EXPECT_EQ(status.exit_code, 0) << status.errors;
    EXPECT_THAT(status.output, HasSubstr("bottleneck"));
}

TEST_F(Cluster, ExplainShowsEachWorkersScore) {
    const Job job = make_job(300);
    start_worker();
    start_worker();
    ASSERT_TRUE(comes_true([&] { return connection_->status().value().workers.size() == 2; }));
    // Stopped workers keep the job running while the test queries it.
    const auto signal_all = [&](int signal) {
        for (const auto& worker : workers_) {
            worker->signal(signal);
        }
    };
    for (const std::string_view strategy : {"best-match", "earliest-finish"}) {
        ClusterOptions options = many_blocks();
        options.strategy = strategy;
        options.q = 200; // Keeps buffers from filling, so that any worker may take the scenario.
        signal_all(SIGSTOP);
        const JobId id = submit(job, {}, options);
        const auto ask = [&](const std::vector<std::string>& more) {
            std::vector<std::string> command{cdctl(), "explain", std::to_string(id.value)};
            command.insert(command.end(), more.begin(), more.end());
            command.insert(command.end(), {"--master", master_->address()});
            return tests::run(command);
        };
        Ran text;
        EXPECT_TRUE(comes_true([&] {
            text = ask({"299"});
            return text.errors.find("being prepared") == std::string::npos;
        }));
        const Ran json = ask({"299", "-o", "json"});
        const Ran none = ask({"300"});
        signal_all(SIGCONT);
        EXPECT_EQ(finish(id, [](const JobStatus&) {}).state, JobState::Done);

        const bool by_time = strategy == "earliest-finish";
        EXPECT_EQ(text.exit_code, 0) << text.errors;
        EXPECT_THAT(text.output, HasSubstr("scenario 299"));
        EXPECT_THAT(text.output, HasSubstr("worker0"));
        EXPECT_THAT(text.output, HasSubstr("worker1"));
        EXPECT_THAT(text.output, HasSubstr(by_time ? "TOTAL MS" : "MISSING"));
        EXPECT_EQ(json.exit_code, 0) << json.errors;
        EXPECT_THAT(json.output, HasSubstr("\"chosen\": true"));
        EXPECT_THAT(json.output, HasSubstr(by_time ? "transfer_ms" : "missing_triangles"));
        EXPECT_THAT(none.errors, HasSubstr("0 to 299"));
        const Ran ended = ask({"299"});
        EXPECT_EQ(ended.exit_code, 0) << ended.errors;
        EXPECT_THAT(ended.output, HasSubstr("answered by worker"));
        EXPECT_THAT(ended.output, HasSubstr("note        the job has ended"));
        EXPECT_THAT(ended.output, testing::Not(HasSubstr("now chosen")));
        EXPECT_THAT(ask({"300"}).errors, HasSubstr("0 to 299"));
    }
}

TEST(Cdctl, ExitCodesSayHowItWent) {
    const TemporaryFolder folder;
    write_boxes(folder);
    const std::string box = folder / "box.obj";
    write_text(folder / "apart.csv", "x,y,z,qx,qy,qz,qw\n3,0,0,0,0,0,1\n");
    write_text(folder / "touch.csv", "x,y,z,qx,qy,qz,qw\n1,0,0,0,0,0,1\n");
    write_text(folder / "cross.csv", "x,y,z,qx,qy,qz,qw\n0.5,0.2,0.1,0,0,0,1\n");
    const auto run_with = [&](const std::string& poses, std::vector<std::string> more) {
        std::vector<std::string> command{
            cdctl(), "run", "--a", box, "--b", box, "--poses", folder / poses};
        command.insert(command.end(), more.begin(), more.end());
        return tests::run(command);
    };
    EXPECT_EQ(run_with("apart.csv", {"--fail-on", "touch"}).exit_code, 0);
    EXPECT_EQ(run_with("touch.csv", {}).exit_code, 0);
    EXPECT_EQ(run_with("touch.csv", {"--fail-on", "touch"}).exit_code, 1);
    EXPECT_EQ(run_with("touch.csv", {"--fail-on", "cross"}).exit_code, 0);
    EXPECT_EQ(run_with("cross.csv", {"--fail-on", "cross"}).exit_code, 1);
    EXPECT_EQ(run_with("cross.csv", {"--fail-on", "cross", "--level", "any"}).exit_code, 2);
    EXPECT_EQ(run_with("cross.csv", {"--no-such-option"}).exit_code, 2);
    EXPECT_EQ(run_with("none.csv", {}).exit_code, 2);
    EXPECT_EQ(run_with("cross.csv", {"--master", "127.0.0.1:1"}).exit_code, 4);
    EXPECT_EQ(run_with("cross.csv", {"--dry-run"}).exit_code, 0);
}

TEST(Cdctl, AnUnknownFieldIsNamedInOneLine) {
    const TemporaryFolder folder;
    write_boxes(folder);
    write_text(folder / "job.toml", "[a]\nmesh = \"box.obj\"\n[b]\nmesh = \"box.obj\"\n[qeury]\n");
    const Ran unknown = tests::run({cdctl(), "run", folder / "job.toml"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.errors,
                testing::AllOf(HasSubstr("job.toml:5"), HasSubstr("qeury"), HasSubstr("query")));
    EXPECT_EQ(std::count(unknown.errors.begin(), unknown.errors.end(), '\n'), 1);
}

TEST(Cdctl, HelpBeginsWithExamples) {
    for (const char* name : {"cdctl", "cdmaster", "cdworker"}) {
        const Ran help = tests::run({program(name).string(), "--help"});
        EXPECT_EQ(help.exit_code, 0);
        EXPECT_TRUE(help.output.starts_with("Examples")) << name << ":\n"
                                                         << help.output.substr(0, 80);
        EXPECT_EQ(tests::run({program(name).string(), "--version"}).exit_code, 0);
    }
    for (const char* verb : {"run",
                             "demo",
                             "submit",
                             "watch",
                             "wait",
                             "results",
                             "get",
                             "status",
                             "explain",
                             "inspect"}) {
        const Ran help = tests::run({cdctl(), verb, "--help"});
        EXPECT_EQ(help.exit_code, 0) << verb;
        EXPECT_THAT(help.output, HasSubstr("cdctl " + std::string(verb))) << verb;
    }
}

} // namespace cd::tests
