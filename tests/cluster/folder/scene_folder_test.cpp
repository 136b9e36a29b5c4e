// Proves, with real processes, that a scene of many bodies runs here and on a cluster to one
// digest, that its results folder can be verified, run again, reused, compared and extracted from,
// and that a job on a master becomes the folder that `run --master` writes.
#include "tests/cluster/folder/cluster_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SceneFolder : public ClusterFolder {
  protected:
    SceneFolder() {
        write_obj(folder_ / "ring.obj", make_torus(1.0, 0.4, 24, 12));
        write_obj(folder_ / "ball.obj", make_sphere(2));
        write_poses(9);
    }

    /// Writes steps at which rings pass a ball that moves, and a wall that stands.
    void write_poses(int steps) {
        std::string rows = "step,body,t,x,y,z\n";
        for (int step = 0; step < steps; ++step) {
            const std::string at = std::to_string(step) + ",";
            const std::string time = "," + std::to_string(0.5 * step) + ",";
            for (int ring = 0; ring < 3; ++ring) {
                const double x = -4 + step + 1.5 * ring;
                rows += at + "ring." + std::to_string(ring) + time + std::to_string(x) + ",0," +
                        std::to_string(0.55 * ring) + "\n";
            }
            rows += at + "ball" + time + (step == 4 ? "nan,nan,nan\n" : "0,0.5,0\n");
        }
        write_text(folder_ / "poses.csv", rows);
    }
    void write_job(const std::string& query, const std::string& rules = "") {
        write_text(folder_ / "job.toml",
                   "[bodies]\nring = { mesh = \"ring.obj\", count = 3, group = \"rings\" }\n"
                   "ball = { mesh = \"ball.obj\" }\n"
                   "wall = { mesh = \"ball.obj\", pose = [3, 1, 0, 0, 0, 0, 1], quat_order = "
                   "\"xyzw\" }\n[poses]\nfile = \"poses.csv\"\nabsent = \"nan\"\n[rules]\n" +
                       rules + "\n[query]\n" + query + "\n");
    }
};

} // namespace

TEST_F(SceneFolder, OnThreeWorkersHasTheDigestAndTheFilesOfOneProcess) {
    start_worker();
    start_worker();
    start_worker();
    const std::string rules =
        "order = [ { ignore = [\"ring.0\", \"ring.1\"] }, { test = [\"ring.2\", \"*\"] } ]";
    int number = 0;
    for (const char* query : {"level = \"contacts\"",
                              "level = \"pairs\"\nclearance = 0.25",
                              "level = \"count\"",
                              "level = \"any\"",
                              "level = \"distance\"\nup_to = 0.5"}) {
        SCOPED_TRACE(query);
        write_job(query, rules);
        const std::string here = "here" + std::to_string(number);
        const std::string there = "there" + std::to_string(number++);
        const auto one = run_into(here);
        const auto other = run_into(there, {"--master", master_->address()});
        EXPECT_EQ(one["digest"], other["digest"]);
        EXPECT_EQ(one["scene"], other["scene"]);
        EXPECT_EQ(one["record_version"], 3);
        for (const char* file : {"scenarios.csv", "episodes.csv", "coverage.csv", "results.npz"}) {
            EXPECT_EQ(read(here, file), read(there, file)) << file;
        }
        const auto summary = read_json(here, "summary.json");
        EXPECT_GT(summary["total"].get<int>(), 9);
        EXPECT_GT(summary["separate"].get<int>(), 0);
        EXPECT_GT(summary["total"].get<int>(), summary["separate"].get<int>());
    }
}

TEST_F(SceneFolder, MotionsOnThreeWorkersHaveTheDigestAndTheFilesOfOneProcess) {
    start_worker();
    start_worker();
    start_worker();
    const std::string motion = "\n[motion]\nresolution = 0.02\nuntil = ";
    int number = 0;
    for (const std::string& query : {"level = \"any\"" + motion + "\"contact\"",
                                     "level = \"pairs\"" + motion + "\"contact\"",
                                     "level = \"pairs\"\nclearance = 0.25" + motion + "\"end\"",
                                     "level = \"any\"" + motion + "\"free\""}) {
        SCOPED_TRACE(query);
        write_job(query, "order = [ { ignore = [\"ring.0\", \"ring.1\"] } ]");
        const std::string here = "here" + std::to_string(number);
        const std::string there = "there" + std::to_string(number++);
        const auto one = run_into(here);
        const auto other = run_into(there, {"--master", master_->address()});
        EXPECT_EQ(one["digest"], other["digest"]);
        EXPECT_EQ(one["scene"], other["scene"]);
        EXPECT_EQ(one["scene"]["steps"], 8) << "there are poses for nine steps";
        for (const char* file : {"scenarios.csv", "episodes.csv", "coverage.csv", "results.npz"}) {
            EXPECT_EQ(read(here, file), read(there, file)) << file;
        }
        const auto summary = read_json(here, "summary.json");
        EXPECT_EQ(summary["failed"], 0);
        EXPECT_GT(summary["separate"].get<int>(), 0);
        EXPECT_GT(summary["total"].get<int>(), summary["separate"].get<int>());
        const Ran verified = cdctl_here({"verify", folder_ / here});
        EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    }
}

TEST_F(SceneFolder, MotionsAreRunAgainAndListedWithTheTimesOfTheirSteps) {
    write_job("level = \"any\"\n[motion]\nresolution = 0.02");
    const auto manifest = run_into("out");
    const std::string rows = read("out", "scenarios.csv");
    EXPECT_THAT(rows, HasSubstr("end,t0,t1"));
    const Ran listed = cdctl_here({"results", folder_ / "out", "-o", "csv"});
    EXPECT_EQ(listed.output, rows);
    const auto again = run_into("again", {"--reuse", folder_ / "out"});
    EXPECT_EQ(again["digest"], manifest["digest"]);
    EXPECT_EQ(again["reused_from"]["scenarios"], manifest["poses"]["count"]);
    const std::string digest = manifest["digest"].get<std::string>().substr(0, 16);
    EXPECT_EQ(digest_of(cdctl_here({"run", folder_ / "out"})), digest);
    fs::remove_all(folder_ / "out" / "inputs");
    EXPECT_EQ(digest_of(cdctl_here({"run", folder_ / "out"})), digest) << "files are read again";
    write_job("level = \"any\"");
    EXPECT_NE(run_into("at_rest")["digest"], manifest["digest"]);
}

TEST_F(SceneFolder, ResultsWritesTheFolderThatRunWrites) {
    start_worker();
    write_job("level = \"pairs\"", "order = [ { ignore = [\"group:rings\", \"wall\"] } ]");
    run_into("run", {"--master", master_->address()});
    const Ran fetched =
        cdctl_at_master({"results", id_of_last_job(), "--out", folder_ / "fetched"});
    EXPECT_EQ(fetched.exit_code, 0) << fetched.errors;
    for (const char* file :
         {"scenarios.csv", "episodes.csv", "coverage.csv", "groups.csv", "steps", "records"}) {
        EXPECT_EQ(read("fetched", file), read("run", file)) << file;
    }
    auto one = read_json("run", "run.json");
    auto other = read_json("fetched", "run.json");
    for (const char* key : {"started", "ended", "command"}) {
        one.erase(key);
        other.erase(key);
    }
    EXPECT_EQ(one, other);
}

TEST_F(SceneFolder, CanBeVerifiedRunAgainReusedAndReported) {
    write_job("level = \"pairs\"");
    const auto manifest = run_into("out");
    EXPECT_FALSE(fs::exists(folder_ / "out" / "map.csv")) << "a map is of two bodies";
    const std::string digest = manifest["digest"].get<std::string>().substr(0, 16);
    const Ran complete = cdctl_here({"run", folder_ / "job.toml", "--out", folder_ / "out"});
    EXPECT_THAT(complete.errors, HasSubstr("already holds this run"));
    const Ran verified = cdctl_here({"verify", folder_ / "out"});
    EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    EXPECT_EQ(digest_of(cdctl_here({"run", folder_ / "out"})), digest);
    const auto reused = run_into("reused", {"--reuse", folder_ / "out"});
    EXPECT_EQ(reused["digest"], manifest["digest"]);
    EXPECT_EQ(reused["reused_from"]["scenarios"], manifest["poses"]["count"]);
    const Ran report = cdctl_here({"report", folder_ / "out", "-o", folder_ / "report.html"});
    EXPECT_EQ(report.exit_code, 0) << report.errors;
    EXPECT_THAT(read_text(folder_ / "report.html"), HasSubstr("An episode is a run of steps"));
    EXPECT_THAT(
        read_text(folder_ / "report.html"),
        testing::ContainsRegex("#[0-9]+, step [0-9]+, [a-z]+(.[0-9])? x [a-z]+(.[0-9])?, t "));
    fs::remove_all(folder_ / "out" / "inputs");
    EXPECT_EQ(digest_of(cdctl_here({"run", folder_ / "out"})), digest) << "files are read again";
}

TEST_F(SceneFolder, AReportIsOfTheBodiesThatAreNamed) {
    write_job("level = \"pairs\"");
    const auto manifest = run_into("out");
    const auto report = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"report", folder_ / "out", "-o", folder_ / "report.html"};
        words.insert(words.end(), more.begin(), more.end());
        return cdctl_here(words);
    };
    const auto scenarios_of = [&](const std::string& body) {
        std::set<std::string> scenarios; // Those in contact.
        std::istringstream rows(read("out", "scenarios.csv"));
        for (std::string row; std::getline(rows, row);) {
            const bool is_hit = row.find("cross") != std::string::npos ||
                                row.find("touch") != std::string::npos ||
                                row.find("inside") != std::string::npos;
            if (is_hit && row.find(body) != std::string::npos) {
                std::istringstream cells(row); // step, time, two bodies, scenario
                std::string scenario;
                for (int i = 0; i < 5; ++i) {
                    std::getline(cells, scenario, ',');
                }
                scenarios.insert(scenario);
            }
        }
        return scenarios;
    };
    ASSERT_EQ(report({}).exit_code, 0);
    const std::string whole = read_text(folder_ / "report.html");
    EXPECT_THAT(whole, testing::Not(HasSubstr("Only scenarios of")));
    ASSERT_FALSE(scenarios_of("wall").empty());
    ASSERT_LT(scenarios_of("wall").size(), scenarios_of("").size());

    const Ran of_wall = report({"--body", "wall", "--pictures", folder_ / "p"});
    EXPECT_EQ(of_wall.exit_code, 0) << of_wall.errors;
    const std::string html = read_text(folder_ / "report.html");
    EXPECT_THAT(html, HasSubstr("Only scenarios of wall: "));
    EXPECT_THAT(html,
                HasSubstr("Digest of the whole run " + manifest["digest"].get<std::string>()));
    EXPECT_THAT(html, HasSubstr("Everything that was asked was tested"));
    EXPECT_THAT(html, testing::Not(HasSubstr("<td>ring.0 x ring.1</td>"))) << "an episode";
    std::set<std::string> pictured;
    for (const auto& entry : fs::directory_iterator(folder_ / "p")) {
        const std::string name = entry.path().stem();
        if (!name.starts_with("body")) {
            pictured.insert(name);
        }
    }
    EXPECT_FALSE(pictured.empty());
    EXPECT_TRUE(std::ranges::includes(scenarios_of("wall"), pictured));
    EXPECT_THAT(read_text(folder_ / "groups.csv"), testing::Not(HasSubstr("ball")));

    const Ran of_both = report({"--body", "wall", "--body", "ball", "--fail-on", "touch"});
    EXPECT_EQ(of_both.exit_code, 1) << of_both.errors;
    EXPECT_THAT(read_text(folder_ / "report.html"), HasSubstr("Only scenarios of wall, ball: "));
    const Ran unknown = report({"--body", "walk"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.errors, HasSubstr("no body \"walk\"; did you mean \"wall\"?"));
    const Ran compared = report({"--body", "wall", "--baseline", folder_ / "out"});
    EXPECT_EQ(compared.exit_code, 2);
    EXPECT_THAT(compared.errors, HasSubstr("leave out --body"));
}

TEST_F(SceneFolder, WithoutInputsTheFileOfASplitMeshIsReadAgain) {
    write_text(folder_ / "two.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no floor\nf 1 2 3\no side\nf 1 2 4\n");
    write_text(folder_ / "job.toml",
               "[bodies]\nhall = { mesh = \"two.obj\", split = \"parts\", origin = [0.25, 0, 0] }\n"
               "ball = { mesh = \"ball.obj\", pose = [0, 0, 0, 0, 0, 0, 1], quat_order = \"xyzw\" "
               "}\n[query]\nlevel = \"pairs\"\n");
    const auto manifest = run_into("out", {"--no-inputs"});
    EXPECT_FALSE(fs::exists(folder_ / "out" / "inputs"));
    ASSERT_EQ(manifest["bodies"].size(), 3u);
    const std::string digest = manifest["digest"].get<std::string>().substr(0, 16);
    const Ran verified = cdctl_here({"verify", folder_ / "out"});
    EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    EXPECT_EQ(digest_of(cdctl_here({"run", folder_ / "out"})), digest);

    write_text(folder_ / "two.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\no floor\nf 1 2 3\no side\nf 1 2 4\n");
    const Ran changed = cdctl_here({"verify", folder_ / "out"});
    EXPECT_EQ(changed.exit_code, 2);
    EXPECT_THAT(changed.errors, HasSubstr("two.obj has changed since the run"));
}

TEST_F(SceneFolder, RunsOfOtherPosesAreComparedByStepAndBodies) {
    write_job("level = \"pairs\"");
    run_into("old");
    write_poses(8);
    run_into("new");
    const Ran diff = cdctl_here({"diff", folder_ / "old", folder_ / "new"});
    EXPECT_EQ(diff.exit_code, 0) << diff.errors;
    EXPECT_THAT(diff.output, HasSubstr("matched by step and bodies"));
    EXPECT_THAT(diff.output, HasSubstr("changed       0 of"));
    write_text(folder_ / "job.toml",
               "[bodies]\nring = { mesh = \"ring.obj\", count = 3 }\n"
               "ball = { mesh = \"ball.obj\" }\n[poses]\nfile = \"poses.csv\"\nabsent = \"nan\"\n");
    run_into("less");
    const Ran refused = cdctl_here({"diff", folder_ / "old", folder_ / "less"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("one has 5 bodies, the other 4"));
    EXPECT_THAT(cdctl_here({"run", folder_ / "job.toml", "--reuse", folder_ / "old"}).errors,
                HasSubstr("nothing can be reused: 4 instances, was 5"));
}

TEST_F(SceneFolder, AScenarioBecomesACaseOfTwoBodies) {
    write_job("level = \"pairs\"");
    const auto manifest = run_into("out");
    const std::uint64_t count = manifest["poses"]["count"];
    for (const std::string& options : {std::string(), std::string("--minimal")}) {
        std::vector<std::string> words{"extract", folder_ / "out", "0", "--out", folder_ / "case"};
        if (!options.empty()) {
            words.push_back(options);
        }
        const Ran made = cdctl_here(words);
        ASSERT_EQ(made.exit_code, 0) << made.errors;
        const auto expected = read_json("case", "expected.json");
        const Ran again = cdctl_here({"run", folder_ / "case" / "job.toml"});
        EXPECT_EQ(digest_of(again), expected["digest"].get<std::string>().substr(0, 16));
    }
    const Ran several = cdctl_here({"extract",
                                    folder_ / "out",
                                    "0-" + std::to_string(count - 1),
                                    "--out",
                                    folder_ / "several"});
    EXPECT_EQ(several.exit_code, 2);
    EXPECT_THAT(several.errors, HasSubstr("extract them one by one"));
    const Ran pictures = cdctl_here(
        {"extract", folder_ / "out", "0-3", "--as", "png", "--out", folder_ / "pictures"});
    EXPECT_EQ(pictures.exit_code, 0) << pictures.errors;
    EXPECT_TRUE(fs::exists(folder_ / "pictures" / "3.png"));
}

TEST_F(SceneFolder, FormatsOfMapsAreRefused) {
    write_job("level = \"pairs\"");
    const Ran refused =
        cdctl_here({"run", folder_ / "job.toml", "--out", folder_ / "out", "--formats", "csv,vtp"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("contact map of two bodies"));
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

} // namespace cd::tests
