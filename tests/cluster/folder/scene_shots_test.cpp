// Proves, with real processes, that lines through a scene have one digest and equal files here and
// on a cluster, that their folder can be verified, exported, reported, compared, extracted from and
// run again, with or without its inputs, and that mistakes end a run with exit code 2.
#include "tests/cluster/folder/cluster_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;

class SceneShotsFolder : public ClusterFolder {
  protected:
    SceneShotsFolder() {
        write_obj(folder_ / "ring.obj", make_torus(1.0, 0.4, 24, 12));
        write_obj(folder_ / "ball.obj", make_sphere(2));
        write_poses(0);
        write_job("");
    }

    /// Writes three steps at which two rings pass a ball and a wall that stand; one ring is absent
    /// at the second step. All are moved along y.
    void write_poses(double y) {
        std::string rows = "step,body,t,x,y,z,yaw_deg\n";
        for (int step = 0; step < 3; ++step) {
            const std::string at = std::to_string(step) + ",";
            const std::string time = "," + std::to_string(0.5 * step) + ",";
            for (int ring = 0; ring < 2; ++ring) {
                const std::string name = at + "ring." + std::to_string(ring) + time;
                rows += name + (step == 1 && ring == 1
                                    ? "nan,nan,nan,nan\n"
                                    : std::to_string(step - ring) + "," + std::to_string(y) + "," +
                                          std::to_string(0.3 * ring) + "," +
                                          std::to_string(30 * step + 10) + "\n");
            }
        }
        write_text(folder_ / "poses.csv", rows);
    }
    void write_job(const std::string& more,
                   const std::string& lines = "spacing = 0.25\ntile = 8\nazimuth_deg = [0, 90, "
                                              "3]\nelevation_deg = [0, 90, 2]\n") {
        write_text(folder_ / "job.toml",
                   "[bodies]\nring = { mesh = \"ring.obj\", count = 2 }\n"
                   "ball = { mesh = \"ball.obj\", pose = [0, 1, 0, 0, 0, 0, 1], quat_order = "
                   "\"xyzw\" }\nwall = { mesh = \"ball.obj\", pose = [2, 1, 0, 0, 0, 0, 1], "
                   "quat_order = \"xyzw\" }\n[poses]\nfile = \"poses.csv\"\nabsent = \"nan\"\n"
                   "[shots]\n" +
                       lines + more);
    }
    /// Runs the job into a folder, in all formats. Returns its manifest.
    nlohmann::json run_into(const std::string& name, std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--formats", "csv,csv-pairs,npz,json"});
        return ClusterFolder::run_into(name, std::move(more));
    }
    /// Returns the rows of a table without its header and so many first columns.
    static std::vector<std::string> rows_after(const std::string& text, int columns) {
        std::vector<std::string> rows;
        std::istringstream lines(text);
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line)) {
            for (int column = 0; column < columns; ++column) {
                line.erase(0, line.find(',') + 1);
            }
            rows.push_back(line);
        }
        return rows;
    }
    /// Returns step, bundle, pairs and hits of each scenario of a body that has any.
    static std::vector<std::string> hits_of(const std::string& text, const std::string& body) {
        std::vector<std::string> hits;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            const auto json = nlohmann::json::parse(line);
            if (json["body_a"] == body && json["count"] != 0) {
                hits.push_back(json["step"].dump() + " " + json["bundle"].dump() + " " +
                               json["pairs"].dump() + " " + json["hits"].dump());
            }
        }
        return hits;
    }
    static std::string short_digest(const nlohmann::json& manifest) {
        return manifest["digest"].get<std::string>().substr(0, 16);
    }
};

} // namespace

TEST_F(SceneShotsFolder, OnThreeWorkersHaveTheDigestAndTheFilesOfOneProcess) {
    start_worker();
    start_worker();
    start_worker();
    int number = 0;
    for (const char* more : {"",
                             "first = true\n",
                             "[query]\nlevel = \"count\"\n",
                             "[rules]\norder = [ { ignore = [\"ring.1\", \"lines\"] } ]\n"}) {
        SCOPED_TRACE(more);
        write_job(more);
        const std::string here = "here" + std::to_string(number);
        const std::string there = "there" + std::to_string(number++);
        const auto one = run_into(here);
        const auto other = run_into(there, {"--master", master_->address()});
        EXPECT_EQ(one["digest"], other["digest"]);
        EXPECT_EQ(one["scene"], other["scene"]);
        EXPECT_EQ(one["scene"]["steps"], 3);
        EXPECT_EQ(one["query"]["question"], "shots");
        EXPECT_EQ(one["bodies"].back()["name"], "lines");
        std::vector<std::string> files{
            "scenarios.csv", "episodes.csv", "coverage.csv", "results.npz", "records", "steps"};
        if (std::string(more).find("count") == std::string::npos) {
            files.insert(files.end(), {"shotlines.csv", "shots.npz"});
        }
        for (const std::string& file : files) {
            EXPECT_EQ(read(here, file), read(there, file)) << file;
        }
        const auto summary = read_json(here, "summary.json");
        EXPECT_EQ(summary["failed"], 0);
        EXPECT_GT(summary["contact"].get<int>(), 20);
        EXPECT_EQ(summary["parts_hit"], read_json(there, "summary.json")["parts_hit"]);
    }
}

TEST_F(SceneShotsFolder, ASceneOfOneBodyHasThePassagesOfAJobOfTwoBodies) {
    const std::string lines = "[shots]\nspacing = 0.125\ntile = 8\nazimuth_deg = [0, 90, "
                              "3]\nelevation_deg = [0, 60, 2]\n";
    write_text(folder_ / "job.toml", "[a]\nmesh = \"ring.obj\"\n" + lines);
    run_into("alone");
    write_text(folder_ / "job.toml",
               "[bodies]\nring = { mesh = \"ring.obj\", pose = [0, 0, 0, 0, 0, 0, 1], quat_order = "
               "\"xyzw\" }\n" +
                   lines);
    run_into("scene");
    const auto alone = rows_after(read("alone", "shotlines.csv"), 1);
    EXPECT_GT(alone.size(), 1000u);
    EXPECT_EQ(rows_after(read("scene", "shotlines.csv"), 4), alone);
}

TEST_F(SceneShotsFolder, ABodyHasTheHitsThatItHasAlone) {
    const std::string box = "box = [-3, -3, -2, 4, 4, 2]\n";
    write_job(box);
    run_into("all");
    write_job(box + "[rules]\norder = [ { ignore = [\"*\", \"lines\"] }, { test = [\"ring.1\", "
                    "\"lines\"] } ]\n");
    run_into("one");
    const auto all = hits_of(read("all", "results.jsonl"), "ring.1");
    EXPECT_GT(all.size(), 10u);
    EXPECT_EQ(hits_of(read("one", "results.jsonl"), "ring.1"), all);
}

TEST_F(SceneShotsFolder, AJobOnAMasterBecomesTheFolderThatRunWrites) {
    start_worker();
    run_into("run", {"--master", master_->address()});
    const Ran fetched = cdctl_at_master({"results",
                                         id_of_last_job(),
                                         "--formats",
                                         "csv,csv-pairs,npz",
                                         "--out",
                                         folder_ / "fetched"});
    EXPECT_EQ(fetched.exit_code, 0) << fetched.errors;
    for (const char* file : {"scenarios.csv", "shotlines.csv", "shots.npz", "steps", "records"}) {
        EXPECT_EQ(read("fetched", file), read("run", file)) << file;
    }
    EXPECT_EQ(read_json("fetched", "run.json")["digest"], read_json("run", "run.json")["digest"]);
    const Ran printed = cdctl_at_master({"results", id_of_last_job(), "-o", "csv"});
    EXPECT_EQ(printed.output, read("run", "scenarios.csv"));
}

TEST_F(SceneShotsFolder, CanBeVerifiedRunAgainReusedAndExported) {
    const auto manifest = run_into("out");
    const std::string lines = read("out", "shotlines.csv");
    EXPECT_THAT(lines, HasSubstr("scenario,step,time,body,view,line,order,part,"));
    EXPECT_THAT(lines, HasSubstr(",ring.1,"));
    EXPECT_THAT(lines, HasSubstr(",wall,"));
    const Ran verified = cdctl_here({"verify", folder_ / "out"});
    EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    const auto reused = run_into("reused", {"--reuse", folder_ / "out"});
    EXPECT_EQ(reused["digest"], manifest["digest"]);
    EXPECT_EQ(reused["reused_from"]["scenarios"], manifest["poses"]["count"]);
    EXPECT_EQ(digest_of(cdctl_here({"run", folder_ / "out"})), short_digest(manifest));
    for (const bool has_inputs : {true, false}) {
        fs::remove(folder_ / "out" / "shotlines.csv");
        const Ran added = cdctl_here({"results", folder_ / "out", "--formats", "csv-pairs"});
        EXPECT_EQ(added.exit_code, 0) << added.errors;
        EXPECT_EQ(read("out", "shotlines.csv"), lines) << has_inputs;
        fs::remove_all(folder_ / "out" / "inputs");
    }
    EXPECT_EQ(digest_of(cdctl_here({"run", folder_ / "out"})), short_digest(manifest))
        << "lines and poses are made again";
    write_poses(0.5);
    const Ran changed = cdctl_here({"results", folder_ / "out", "--formats", "csv-pairs"});
    EXPECT_EQ(changed.exit_code, 2);
    EXPECT_THAT(changed.errors, HasSubstr("has changed since the run"));
}

TEST_F(SceneShotsFolder, IsReportedWithItsPartsAndPictures) {
    run_into("out");
    const Ran report = cdctl_here({"report",
                                   folder_ / "out",
                                   "--3d",
                                   "--pictures",
                                   folder_ / "pictures",
                                   "-o",
                                   folder_ / "report.html"});
    EXPECT_EQ(report.exit_code, 0) << report.errors;
    const std::string html = read_text(folder_ / "report.html");
    EXPECT_THAT(html, HasSubstr("ring.1/"));
    EXPECT_THAT(html, HasSubstr("azimuth 45, elevation 90"));
    EXPECT_THAT(html, ContainsRegex("<td>#[0-9]+, step [0-2], [a-z]+(.[01])?, az=[0-9]+ el=[0-9]"));
    EXPECT_THAT(html, HasSubstr("in the mean over all directions and steps"));
    EXPECT_TRUE(fs::exists(folder_ / "pictures" / "thickness-az45-el90.png"));
}

TEST_F(SceneShotsFolder, RunsAreComparedByStepBundleAndBody) {
    write_job("box = [-3, -3, -2, 4, 4, 2]\n");
    const auto old_run = run_into("old");
    write_poses(0.25);
    run_into("new");
    const Ran diff = cdctl_here({"diff", folder_ / "old", folder_ / "new"});
    EXPECT_EQ(diff.exit_code, 0) << diff.errors;
    EXPECT_THAT(diff.output, HasSubstr("matched by step and bodies"));
    EXPECT_THAT(diff.output, testing::Not(HasSubstr("changed       0 of")));
    write_poses(0);
    EXPECT_EQ(run_into("same")["digest"], old_run["digest"]);
    const Ran same = cdctl_here({"diff", folder_ / "old", folder_ / "same"});
    EXPECT_THAT(same.output, HasSubstr("changed       0 of"));
    write_job("");
    run_into("other");
    const Ran refused = cdctl_here({"diff", folder_ / "old", folder_ / "other"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("their lines stand at other places"));
}

TEST_F(SceneShotsFolder, AScenarioCanBeDrawn) {
    run_into("out");
    const Ran one =
        cdctl_here({"extract", folder_ / "out", "0", "--as", "glb", "--out", folder_ / "one"});
    EXPECT_EQ(one.exit_code, 0) << one.errors;
    EXPECT_TRUE(fs::exists(folder_ / "one" / "0.glb"));
    const Ran made = cdctl_here({"extract", folder_ / "out", "0", "--out", folder_ / "case"});
    EXPECT_EQ(made.exit_code, 2);
    EXPECT_THAT(made.errors, HasSubstr("this run has lines"));
}

TEST_F(SceneShotsFolder, LinesOfAFileAreInTheWorld) {
    write_job("[query]\nlevel = \"pairs\"\n", "file = \"lines.npy\"\n");
    const Ran missing = cdctl_here({"run", folder_ / "job.toml"});
    EXPECT_EQ(missing.exit_code, 2) << missing.errors;
    EXPECT_THAT(missing.errors, HasSubstr("lines.npy"));
}

TEST_F(SceneShotsFolder, MistakesEndTheRunWithCodeTwo) {
    const auto errors = [&](const std::string& more) {
        write_job(more);
        const Ran ran = cdctl_here({"run", folder_ / "job.toml"});
        EXPECT_EQ(ran.exit_code, 2) << more;
        return ran.errors;
    };
    EXPECT_THAT(errors("[rules]\norder = [ { ignore = [\"ringg.*\", \"lines\"] } ]\n"),
                HasSubstr("job.toml:14: [rules]"));
    EXPECT_THAT(errors("[rules]\norder = [ { ignore = [\"*\", \"lines\"] } ]\n"),
                HasSubstr("lines can hit none"));
    EXPECT_THAT(errors("[query]\nlevel = \"any\"\n"), HasSubstr("level count or pairs"));
    write_job("");
    EXPECT_EQ(cdctl_here({"run", folder_ / "job.toml", "--maps", "--level", "count"}).exit_code, 2);
    const Ran checked = cdctl_here({"job", "check", folder_ / "job.toml"});
    EXPECT_EQ(checked.exit_code, 0) << checked.errors;
    EXPECT_THAT(checked.output, HasSubstr("lines: 3 azimuths, 2 elevations, "));
}

} // namespace cd::tests
