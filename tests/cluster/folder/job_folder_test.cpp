// Proves, with real processes, that a job on a master becomes a folder: the folder that `results`
// writes equals the one `run --master` writes, except for times.
#include "client/folder/opened_run.hpp"
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/report_answers.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <map>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class JobFolder : public Cluster {
  protected:
    JobFolder() {
        write_obj(folder_ / "a.obj", make_torus(1.0, 0.4, 24, 12));
        write_obj(folder_ / "b.obj", make_sphere(2));
    }

    void write_job(const std::string& poses, const std::string& query) {
        write_text(folder_ / "job.toml",
                   "unit = \"cm\"\n[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\nname = \"ball\"\n"
                   "unit = \"cm\"\n[poses]\n" +
                       poses + "\n[query]\n" + query + "\n");
    }
    [[nodiscard]] Ran cdctl_at_master(std::vector<std::string> words) {
        words.insert(words.begin(), cdctl());
        words.insert(words.end(), {"--master", master_->address()});
        return tests::run(words);
    }
    [[nodiscard]] Process start_run_into(const std::string& name) {
        return {{cdctl(),
                 "run",
                 folder_ / "job.toml",
                 "--out",
                 folder_ / name,
                 "--master",
                 master_->address()},
                folder_ / "run"};
    }
    /// Reads run.json without the fields in which two writers of one run may differ.
    [[nodiscard]] static nlohmann::json without_times(const fs::path& path) {
        auto json = nlohmann::json::parse(read_text(path));
        for (const char* key : {"started", "ended", "command"}) {
            json.erase(key);
        }
        return json;
    }
    [[nodiscard]] std::vector<std::string> files_of(const std::string& name) {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / name)) {
            if (entry.is_regular_file()) {
                names.push_back(entry.path().lexically_relative(folder_ / name));
            }
        }
        std::sort(names.begin(), names.end());
        return names;
    }
    [[nodiscard]] std::string id_of_last_job() {
        const Ran jobs = cdctl_at_master({"get", "jobs", "-o", "name"});
        const std::string ids = jobs.output.substr(0, jobs.output.find_last_not_of('\n') + 1);
        return ids.substr(ids.rfind('\n') + 1);
    }
};

TEST_F(JobFolder, ResultsWritesTheFolderThatRunWrites) {
    start_worker();
    write_text(folder_ / "poses.csv",
               "x,y,z,qx,qy,qz,qw\n3,0,0,0,0,0,1\n1,0,0,0,0,0,1\n0.5,0.2,0.1,0,0,0,1\n");
    write_text(folder_ / "named.csv", "id,t,x\nfirst,0.1,3\n\"a, b\",0.2,1\n");
    const std::vector<std::array<std::string, 2>> jobs{
        {"random = { n = 50, seed = 3 }", "level = \"contacts\""},
        {"random = { n = 40, seed = 4 }", "level = \"contacts\"\nclearance = 0.125"},
        {"grid = { x = [-3, 3, 9], yaw_deg = [0, 90, 4] }",
         "level = \"count\"\nclearance = 0.25\nmaps = true"},
        {"grid = { x = [-3, 3, 9], yaw_deg = [0, 90, 4] }", "level = \"distance\"\nup_to = 0.5"},
        {"file = \"poses.csv\"", "level = \"pairs\"\nlimit_pairs = 3"},
        {"file = \"poses.csv\"\nunit = \"mm\"", "level = \"any\""},
        {"file = \"named.csv\"", "level = \"count\""},
        {"grid = { x = [-2, 2, 9], yaw_deg = [0, 90, 4] }", "level = \"count\"\nmaps = true"},
        {"grid = { x = [-20, 20, 9] }\nunit = \"mm\"",
         "level = \"pairs\"\nignore = [[\"default*\", \"ball/defaultobject\"]]\n"
         "[cluster]\nstrategy = \"random\"\nseed = 5\ndepth = { b = 2 }"}};
    for (const auto& [poses, query] : jobs) {
        SCOPED_TRACE(poses);
        write_job(poses, query);
        const bool has_map =
            query.find("any") == std::string::npos && query.find("distance") == std::string::npos &&
            (query.find("count") == std::string::npos || query.find("maps") != std::string::npos);
        const std::vector<std::string> formats{
            "--formats", std::string("csv,csv-pairs,npz,json") + (has_map ? ",vtp,glb" : "")};
        std::vector<std::string> command{"run", folder_ / "job.toml", "--out", folder_ / "x"};
        command.insert(command.end(), formats.begin(), formats.end());
        const Ran ran = cdctl_at_master(command);
        ASSERT_EQ(ran.exit_code, 0) << ran.errors;
        command = {"results", "last", "--out", folder_ / "y"};
        command.insert(command.end(), formats.begin(), formats.end());
        const Ran fetched = cdctl_at_master(command);
        ASSERT_EQ(fetched.exit_code, 0) << fetched.errors;
        EXPECT_EQ(digest_of(fetched), digest_of(ran));

        const Ran without_map =
            cdctl_at_master({"results", "last", "--out", folder_ / "maps", "--formats", "glb"});
        EXPECT_EQ(without_map.exit_code, has_map ? 0 : 2) << without_map.errors;
        std::filesystem::remove_all(folder_ / "maps");

        ASSERT_EQ(files_of("y"), files_of("x"));
        for (const std::string& name : files_of("x")) {
            if (name != "run.json") {
                EXPECT_EQ(read_text(folder_ / "y" / name), read_text(folder_ / "x" / name)) << name;
            }
        }
        EXPECT_EQ(without_times(folder_ / "y" / "run.json"),
                  without_times(folder_ / "x" / "run.json"));
        if (poses.find("named.csv") != std::string::npos) {
            EXPECT_EQ(read_text(folder_ / "y" / "inputs" / "ids"),
                      "id,t\nfirst,0.1\n\"a, b\",0.2\n");
            const auto told = without_times(folder_ / "y" / "run.json")["poses"];
            EXPECT_EQ(told["ids"], true);
            EXPECT_EQ(told["times"], true);
        }
        const auto written = nlohmann::json::parse(read_text(folder_ / "y" / "run.json"));
        EXPECT_EQ(written["where"]["workers"], 1);
        const auto summary = nlohmann::json::parse(read_text(folder_ / "y" / "summary.json"));
        EXPECT_EQ(summary["depths"].size(), 2u) << "by body";
        const Ran told = cdctl_at_master({"get", "jobs", "-o", "json"});
        std::string began = nlohmann::json::parse(told.output).back()["began"];
        EXPECT_EQ(written["started"], began.replace(began.find(' '), 1, "T"));
        EXPECT_GE(written["ended"], written["started"]);
        const Ran here = tests::run({cdctl(), "run", folder_ / "y"});
        EXPECT_EQ(digest_of(here), digest_of(ran)) << here.errors;
        const std::string without = folder_ / "z";
        ASSERT_EQ(cdctl_at_master({"results", "last", "--out", without, "--no-inputs"}).exit_code,
                  0);
        const Ran of_files = tests::run({cdctl(), "run", without});
        EXPECT_EQ(digest_of(of_files), digest_of(ran)) << of_files.errors;
        for (const char* name : {"x", "y", "z"}) {
            fs::remove_all(folder_ / name);
        }
    }
}

TEST_F(JobFolder, AJobIsVerifiedAndExtractedAsAFolderIs) {
    start_worker();
    write_job("random = { n = 40, seed = 3 }", "level = \"contacts\"");
    ASSERT_EQ(cdctl_at_master({"run", folder_ / "job.toml"}).exit_code, 0);
    const Ran verified = cdctl_at_master({"verify", "last", "--sample", "30"});
    EXPECT_EQ(verified.exit_code, 0) << verified.errors;
    EXPECT_THAT(verified.output, HasSubstr("30 of 40 scenarios run again: 30 the same"));
    const std::string dir = folder_ / "case";
    const Ran extracted = cdctl_at_master({"extract", "last", "17", "--out", dir});
    EXPECT_EQ(extracted.exit_code, 0) << extracted.errors;
    const Ran again = tests::run({cdctl(), "run", dir + "/job.toml"});
    const auto expected = nlohmann::json::parse(read_text(folder_ / "case" / "expected.json"));
    EXPECT_EQ(digest_of(again), expected["digest"].get<std::string>().substr(0, 16));
}

TEST_F(JobFolder, AMeshWithAnotherOriginIsReadSoAgain) {
    start_worker();
    const auto write = [&](const std::string& mesh) {
        write_text(folder_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\n" + mesh +
                       "\n[poses]\ngrid = { yaw_deg = [0, 315, 8] }\n[query]\nlevel = "
                       "\"contacts\"\n");
    };
    const Mesh door = make_box({1, 0.125, 0.5});
    write_obj(folder_ / "door.obj", translated(door, {2, 0.5, 0}));
    write_obj(folder_ / "hinged.obj", door);
    write("mesh = \"hinged.obj\"");
    const Ran hinged = tests::run({cdctl(), "run", folder_ / "job.toml"});
    write("mesh = \"door.obj\"\norigin = [2, 0.5, 0]");
    const Ran here =
        tests::run({cdctl(), "run", folder_ / "job.toml", "--out", folder_ / "x", "--no-inputs"});
    EXPECT_EQ(here.exit_code, 0) << here.errors;
    EXPECT_EQ(digest_of(here), digest_of(hinged));
    EXPECT_EQ(digest_of(tests::run({cdctl(), "run", folder_ / "x"})), digest_of(hinged));

    const Ran extracted =
        tests::run({cdctl(), "extract", folder_ / "x", "1", "--out", folder_ / "case"});
    EXPECT_EQ(extracted.exit_code, 0) << extracted.errors;
    const auto expected = nlohmann::json::parse(read_text(folder_ / "case" / "expected.json"));
    EXPECT_EQ(digest_of(tests::run({cdctl(), "run", folder_ / "case" / "job.toml"})),
              expected["digest"].get<std::string>().substr(0, 16));

    const Ran there = cdctl_at_master({"run", folder_ / "job.toml"});
    EXPECT_EQ(digest_of(there), digest_of(hinged)) << there.errors;
    const Ran results = cdctl_at_master({"results", "last", "--out", folder_ / "y"});
    EXPECT_EQ(results.exit_code, 0) << results.errors;
    const auto run = nlohmann::json::parse(read_text(folder_ / "y" / "run.json"));
    EXPECT_EQ(run["bodies"][1]["origin"], nlohmann::json({2, 0.5, 0}));
    EXPECT_EQ(digest_of(tests::run({cdctl(), "run", folder_ / "y"})), digest_of(hinged));
    EXPECT_EQ(cdctl_at_master({"verify", "last"}).exit_code, 0);
}

TEST_F(JobFolder, ACancelledJobKeepsItsResults) {
    write_job("random = { n = 500, seed = 3 }", "level = \"count\"\nmaps = true");
    // Without a worker, the master alone answers all it can.
    const Ran submitted = cdctl_at_master({"submit", folder_ / "job.toml", "-o", "name"});
    ASSERT_EQ(submitted.exit_code, 0) << submitted.errors;
    ASSERT_EQ(cdctl_at_master({"cancel", "last"}).exit_code, 0);
    const Ran results = cdctl_at_master({"results", "last", "--out", folder_ / "x"});
    EXPECT_EQ(results.exit_code, 3) << results.errors;
    EXPECT_THAT(results.errors, HasSubstr("incomplete: "));
    EXPECT_THAT(results.errors, HasSubstr("of 500 scenarios have a result"));
    const auto run = nlohmann::json::parse(read_text(folder_ / "x" / "run.json"));
    EXPECT_EQ(run["complete"], false);
    EXPECT_LT(run["answered"], 500);
    EXPECT_TRUE(run["digest"].is_null());
    EXPECT_EQ(cdctl_at_master({"verify", "last"}).exit_code, 3);
}

TEST_F(JobFolder, AnInterruptedRunLeavesItsAnswersAtTheMasterAndNothingInItsFolder) {
    write_job("random = { n = 500, seed = 3 }", "level = \"count\"");
    // Without a worker, the master alone answers all it can.
    Process run = start_run_into("x");
    ASSERT_TRUE(comes_true([&] { return id_of_last_job().starts_with("j-"); })) << run.errors();
    run.signal(SIGINT);
    EXPECT_EQ(run.wait(), 130);
    const std::string id = id_of_last_job();
    EXPECT_THAT(run.errors(),
                HasSubstr("cdctl: job " + id + " is cancelled; `cdctl results " + id +
                          "` gives the results so far\n"));
    EXPECT_FALSE(fs::exists(folder_ / "x" / ".part"));

    const Ran results = cdctl_at_master({"results", id, "--out", folder_ / "y"});
    EXPECT_EQ(results.exit_code, 3) << results.errors;
    EXPECT_THAT(results.errors, HasSubstr("incomplete: "));
    write_job("random = { n = 5, seed = 4 }", "level = \"count\"");
    const Ran other = tests::run({cdctl(), "run", folder_ / "job.toml", "--out", folder_ / "x"});
    EXPECT_EQ(other.exit_code, 0) << other.errors;
}

TEST_F(JobFolder, ResultsDoNotGoIntoAFolderOfAnotherRun) {
    start_worker();
    write_job("random = { n = 5, seed = 4 }", "level = \"count\"");
    ASSERT_EQ(tests::run({cdctl(), "run", folder_ / "job.toml", "--out", folder_ / "x"}).exit_code,
              0);
    const std::string before = read_text(folder_ / "x" / "run.json");
    write_job("random = { n = 6, seed = 3 }", "level = \"count\"");
    ASSERT_EQ(cdctl_at_master({"run", folder_ / "job.toml"}).exit_code, 0);
    const Ran refused = cdctl_at_master({"results", "last", "--out", folder_ / "x"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("holds another run (job, of "));
    EXPECT_EQ(read_text(folder_ / "x" / "run.json"), before);
    EXPECT_FALSE(fs::exists(folder_ / "x" / ".part"));
}

TEST_F(JobFolder, AKilledRunOfAMasterDoesNotKeepItsFolderFromOthers) {
    write_job("random = { n = 500, seed = 3 }", "level = \"count\"");
    Process run = start_run_into("x");
    ASSERT_TRUE(comes_true([&] { return fs::exists(folder_ / "x" / ".part" / "run.json"); }));
    run.signal(SIGKILL);
    EXPECT_EQ(run.wait(), 128 + SIGKILL);
    write_job("random = { n = 5, seed = 4 }", "level = \"count\"");
    const Ran other = tests::run({cdctl(), "run", folder_ / "job.toml", "--out", folder_ / "x"});
    EXPECT_EQ(other.exit_code, 0) << other.errors;
}

} // namespace

TEST_F(JobFolder, AJobIsReportedAsItsFolderIs) {
    start_worker();
    write_text(folder_ / "poses.csv",
               "x,y,z,qx,qy,qz,qw\n3,0,0,0,0,0,1\n1,0,0,0,0,0,1\n0.5,0.2,0.1,0,0,0,1\n");
    write_job("file = \"poses.csv\"", "level = \"pairs\"");
    const std::string out = folder_ / "out";
    ASSERT_EQ(cdctl_at_master({"run", folder_ / "job.toml", "--out", out}).exit_code, 0);
    const auto report = [&](const std::string& run, const std::string& name) {
        const Ran ran = cdctl_at_master({"report",
                                         run,
                                         "-o",
                                         folder_ / name / "report.html",
                                         "--pictures",
                                         folder_ / name,
                                         "--baseline",
                                         out});
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
    };
    report(out, "of_folder");
    report("last", "of_job");
    for (const char* name : {"groups.csv", "a.png", "b.png", "1.png", "2.png"}) {
        EXPECT_EQ(read_text(folder_ / "of_job" / name), read_text(folder_ / "of_folder" / name))
            << name;
    }
    EXPECT_THAT(read_text(folder_ / "of_job" / "groups.csv"), HasSubstr(",active,\n"));
    EXPECT_THAT(read_text(folder_ / "of_job" / "report.html"), HasSubstr("<h2>Groups</h2>"));
}

TEST_F(JobFolder, AReportOfAJobHoldsTheViewerOfItsFolder) {
    start_worker();
    write_text(folder_ / "poses.csv",
               "x,y,z,qx,qy,qz,qw\n3,0,0,0,0,0,1\n1,0,0,0,0,0,1\n0.5,0.2,0.1,0,0,0,1\n");
    write_job("file = \"poses.csv\"", "level = \"count\"\nmaps = true");
    const std::string out = folder_ / "out";
    ASSERT_EQ(cdctl_at_master({"run", folder_ / "job.toml", "--out", out}).exit_code, 0);
    const auto answers = [&](const std::string& run, const std::string& job) {
        const Ran ran = cdctl_at_master(
            {"report", run, "--3d", "-o", folder_ / "report.html", "--threads", "1"});
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        std::map<std::string, std::string> found;
        for (const auto& [path, text] : answers_in(read_text(folder_ / "report.html"))) {
            if (path == "jobs/" + job) {
                EXPECT_THAT(text, HasSubstr("\"groups\":[{")) << run;
            } else if (path != "source") {
                found[path.starts_with("jobs/") ? path.substr(("jobs/" + job).size()) : path] =
                    text;
            }
        }
        return found;
    };
    const auto of_folder = answers(out, "folder");
    const std::string id = OpenedRun::open(out).value().manifest().where.job;
    EXPECT_GT(of_folder.size(), 2u);
    EXPECT_EQ(answers("last", id), of_folder);
}

} // namespace cd::tests
