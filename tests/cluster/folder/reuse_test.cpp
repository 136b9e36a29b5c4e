// Proves, with real processes, that `run --reuse` gives the files of a run without it and runs only
// the scenarios that the earlier run lacks; and that it refuses results of other inputs.
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/cluster/folder/folder_fixture.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> pose_rows(int count) {
    std::vector<std::string> rows;
    for (int i = 0; i < count; ++i) {
        rows.push_back(std::to_string(i % 101 * 0.03) + "," + std::to_string(i % 53 * 0.04) + "," +
                       std::to_string(i));
    }
    return rows;
}

class Reuse : public FolderTest {
  protected:
    void write_poses(const std::vector<std::string>& rows) {
        std::string text = "x,y,yaw_deg\n";
        for (const std::string& row : rows) {
            text += row + "\n";
        }
        write_text(folder_ / "poses.csv", text);
    }
    void write_query(const std::string& query) {
        write_text(job_,
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"poses.csv\"\n"
                   "[query]\n" +
                       query + "\n");
    }
    [[nodiscard]] Ran run_into(const std::string& name, std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--out", folder_ / name, "--formats", "csv,csv-pairs,npz,json"});
        return run(std::move(more));
    }
    /// Runs the job with and without the results in `old`, and expects equal files. Returns the
    /// number of reused results.
    std::uint64_t expect_equal_runs(const std::string& name) {
        EXPECT_EQ(run_into("whole", {"--overwrite"}).exit_code, 0);
        const Ran ran = run_into(name, {"--reuse", folder_ / "old"});
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        const auto whole = read_json(folder_ / "whole" / "run.json");
        const auto got = read_json(folder_ / name / "run.json");
        EXPECT_EQ(got["digest"], whole["digest"]);
        EXPECT_EQ(got["map_digest"], whole["map_digest"]);
        EXPECT_EQ(got["poses"], whole["poses"]);
        for (const auto& file : whole["files"]) {
            const std::string path = file["name"];
            // Blocks of these depend on how many scenarios were read or run together.
            const bool has_blocks =
                path == "records" || path == "maps" || path == "inputs/scenarios";
            if (path != "summary.json" && !has_blocks) {
                EXPECT_EQ(read_text(folder_ / name / path), read_text(folder_ / "whole" / path))
                    << path;
            }
        }
        EXPECT_EQ(got["reused_from"]["digest"], read_json(folder_ / "old" / "run.json")["digest"]);
        EXPECT_EQ(got["reused_from"]["run"], (folder_ / "old").string());
        return got["reused_from"]["scenarios"];
    }
};

TEST_F(Reuse, OneChangedPoseOfTenThousandIsRun) {
    auto rows = pose_rows(10'000);
    write_poses(rows);
    write_query("level = \"pairs\"");
    ASSERT_EQ(run_into("old").exit_code, 0);
    rows[4'321] = "0.5,0.25,77";
    write_poses(rows);
    EXPECT_EQ(expect_equal_runs("new"), 9'999u);
    const Ran again = run({"--reuse", folder_ / "old"});
    EXPECT_THAT(again.errors, HasSubstr("\n9 999 of 10 000 results are those of "));
    EXPECT_THAT(again.output, HasSubstr("  reused        9 999 of 10 000 results"));
    EXPECT_EQ(digest_of(again), digest_of(run({})));
    EXPECT_EQ(read_json(folder_ / "new" / "summary.json")["reused"], 9'999);
    EXPECT_EQ(tests::run(command("verify", folder_ / "new", {"--sample", "50"})).exit_code, 0);
}

TEST_F(Reuse, TheOrderOfPosesDoesNotMatterNorTheSignOfZero) {
    auto rows = pose_rows(6'000);
    rows[17] = "0,0.5,0";
    rows[18] = rows[17];
    write_poses(rows);
    write_query("level = \"contacts\"");
    ASSERT_EQ(run_into("old").exit_code, 0);
    rows[17] = "-0.0,0.5,-0";
    std::reverse(rows.begin(), rows.end());
    rows.push_back("0.3,0.3,0.125");
    rows.push_back(rows[1'000]);
    rows.erase(rows.begin() + 40);
    write_poses(rows);
    EXPECT_EQ(expect_equal_runs("new"), 6'000u);
}

TEST_F(Reuse, AGridIsReusedByAFileOfItsPosesAndTheOtherWayRound) {
    write_job(20, "level = \"pairs\"");
    ASSERT_EQ(run_into("old").exit_code, 0);
    write_job(39, "level = \"pairs\""); // Every second position is one of the old ones.
    const std::uint64_t reused = expect_equal_runs("new");
    EXPECT_GT(reused, 0u);
    EXPECT_LT(reused, 39u * 39u);
}

TEST_F(Reuse, MapsCountReusedScenariosToo) {
    auto rows = pose_rows(2'000);
    write_poses(rows);
    for (const char* query : {"level = \"count\"\nmaps = true",
                              "level = \"pairs\"\nmaps = true",
                              "level = \"pairs\"\nlimit_pairs = 20\nmaps = true",
                              "level = \"pairs\"\nlimit_pairs = 20"}) {
        SCOPED_TRACE(query);
        write_query(query);
        ASSERT_EQ(run_into("old", {"--overwrite"}).exit_code, 0);
        rows.back() += "1";
        write_poses(rows);
        const std::uint64_t reused = expect_equal_runs("new");
        const auto classes = read_json(folder_ / "old" / "summary.json");
        const std::uint64_t without_pairs =
            classes["separate"].get<std::uint64_t>() + classes["inside"].get<std::uint64_t>();
        ASSERT_LT(without_pairs, 1'900u);
        if (std::string(query).starts_with("level = \"count\"")) {
            EXPECT_THAT(reused,
                        testing::AllOf(testing::Ge(without_pairs - 1), testing::Le(without_pairs)));
        } else if (std::string(query).ends_with("20\nmaps = true")) {
            EXPECT_GT(reused, without_pairs);
            EXPECT_LT(reused, 1'999u);
        } else {
            EXPECT_EQ(reused, 1'999u);
        }
        fs::remove_all(folder_ / "new");
    }
}

TEST_F(Reuse, ResultsOfOtherMeshesOrQueriesAreRefused) {
    write_poses(pose_rows(50));
    write_query("level = \"pairs\"");
    ASSERT_EQ(run_into("old").exit_code, 0);
    const auto refusal = [&] {
        const Ran ran = run_into("new", {"--reuse", folder_ / "old"});
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_FALSE(fs::exists(folder_ / "new"));
        return ran.errors;
    };
    write_query("level = \"count\"");
    EXPECT_THAT(refusal(),
                HasSubstr("nothing can be reused: query changed (level count, was pairs)"));
    write_query("level = \"pairs\"\nlimit_pairs = 7");
    EXPECT_THAT(refusal(), HasSubstr("query changed (limit_pairs 7, was 0)"));
    write_query("level = \"pairs\"");
    write_obj(folder_ / "b.obj", make_sphere(1));
    EXPECT_THAT(refusal(), HasSubstr("nothing can be reused: B changed ("));
    const Ran missing = run({"--reuse", "nowhere"});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_THAT(missing.errors, HasSubstr("there is no folder 'nowhere' to reuse"));
}

TEST_F(Reuse, AFolderMayReuseItsOwnEarlierRun) {
    auto rows = pose_rows(500);
    write_poses(rows);
    write_query("level = \"pairs\"");
    ASSERT_EQ(run_into("out").exit_code, 0);
    rows[7] = "0.4,0.4,4";
    write_poses(rows);
    ASSERT_EQ(run_into("whole").exit_code, 0);
    const Ran ran = run_into("out", {"--reuse", folder_ / "out", "--overwrite"});
    EXPECT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_THAT(ran.output, HasSubstr("  reused        499 of 500 results"));
    EXPECT_EQ(read_json(folder_ / "out" / "run.json")["digest"],
              read_json(folder_ / "whole" / "run.json")["digest"]);
    EXPECT_EQ(tests::run(command("verify", folder_ / "out", {})).exit_code, 0);
    const Ran equal = run_into("equal", {"--reuse", folder_ / "out"});
    EXPECT_THAT(equal.output, HasSubstr("  reused        500 of 500 results"));
    EXPECT_EQ(digest_of(equal), digest_of(ran));
}

TEST_F(Reuse, ADryRunTellsHowManyResultsAreReused) {
    auto rows = pose_rows(50);
    write_poses(rows);
    write_query("level = \"pairs\"");
    ASSERT_EQ(run_into("old").exit_code, 0);
    rows.push_back("0.4,0.4,4");
    write_poses(rows);
    const Ran dry = run({"--dry-run", "--reuse", folder_ / "old"});
    EXPECT_EQ(dry.exit_code, 0) << dry.errors;
    EXPECT_THAT(dry.errors, HasSubstr("50 of 51 results are those of "));
}

TEST_F(Reuse, AnInterruptedRunResumesOnlyWithItsReuse) {
    auto rows = pose_rows(60'000);
    std::vector<std::string> old_rows;
    for (std::size_t i = 0; i < rows.size(); i += 3) {
        old_rows.push_back(rows[i]);
    }
    write_poses(old_rows);
    write_query("level = \"pairs\"");
    ASSERT_EQ(run_into("old").exit_code, 0);
    write_poses(rows);
    const Ran whole = run_into("whole");
    const std::vector<std::string> reuse{"--reuse", folder_ / "old"};
    const auto words = command(
        "run",
        "",
        {"--out", folder_ / "new", "--formats", "csv,csv-pairs,npz,json", "--reuse", reuse[1]});
    Process process(words, folder_ / "stopped");
    ASSERT_TRUE(comes_true([&] {
        const auto kept = RecordFile::open_unfinished(folder_ / "new" / ".part" / "records");
        return kept && kept.value().count() > 0;
    }));
    process.signal(SIGINT);
    ASSERT_EQ(process.wait(), 130) << process.errors();
    const Ran without = run_into("new");
    EXPECT_EQ(without.exit_code, 2);
    EXPECT_THAT(without.errors,
                HasSubstr("holds the unfinished part of a run with --reuse " + reuse[1]));
    const Ran resumed = run_into("new", reuse);
    ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
    EXPECT_THAT(resumed.errors, HasSubstr("resumed at "));
    EXPECT_EQ(digest_of(resumed), digest_of(whole));
    const auto run_json = read_json(folder_ / "new" / "run.json");
    EXPECT_EQ(run_json["reused_from"]["scenarios"], 20'000);
    EXPECT_EQ(run_json["poses"]["sha256"],
              read_json(folder_ / "whole" / "run.json")["poses"]["sha256"]);
    EXPECT_EQ(read_text(folder_ / "new" / "pairs.csv"), read_text(folder_ / "whole" / "pairs.csv"));
}

class ReuseAtMaster : public Cluster {
  protected:
    ReuseAtMaster() {
        write_obj(folder_ / "a.obj", make_torus(1.0, 0.4, 24, 12));
        write_obj(folder_ / "b.obj", make_sphere(2));
    }

    void write_job(int last, const std::string& query) {
        std::string text = "id,x,y,yaw_deg\n";
        for (int i = 0; i <= last; ++i) {
            text += std::to_string(i) + "," + std::to_string(i % 50 * 0.06) + "," +
                    std::to_string(i % 7 * 0.2) + "," + std::to_string(i) + "\n";
        }
        write_text(folder_ / "poses.csv", text);
        write_text(folder_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"poses.csv\"\n"
                   "[query]\n" +
                       query + "\n");
    }
    [[nodiscard]] Ran run_job(const std::string& out, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {cdctl(), "run", folder_ / "job.toml"});
        if (!out.empty()) {
            more.insert(more.end(), {"--out", folder_ / out, "--formats", "csv,csv-pairs,npz"});
        }
        return tests::run(more);
    }
    [[nodiscard]] nlohmann::json run_json(const std::string& name) {
        return nlohmann::json::parse(read_text(folder_ / name / "run.json"));
    }
    [[nodiscard]] std::size_t count_jobs() {
        const Ran jobs =
            tests::run({cdctl(), "get", "jobs", "-o", "json", "--master", master_->address()});
        return nlohmann::json::parse(jobs.output).size();
    }
};

TEST_F(ReuseAtMaster, TheRestRunsAsAJobOfItsOwn) {
    start_worker();
    for (const char* query : {"level = \"contacts\"", "level = \"count\"\nmaps = true"}) {
        SCOPED_TRACE(query);
        write_job(300, query);
        ASSERT_EQ(run_job("old", {"--master", master_->address(), "--overwrite"}).exit_code, 0);
        write_job(400, query);
        const Ran whole = run_job("whole", {"--overwrite"});
        const std::size_t jobs = count_jobs();
        // The results folder, and the job on the master, are the same earlier run.
        for (const std::string& earlier : {std::string("last"), std::string(folder_ / "old")}) {
            SCOPED_TRACE(earlier);
            const Ran ran =
                run_job("new", {"--reuse", earlier, "--master", master_->address(), "--overwrite"});
            ASSERT_EQ(ran.exit_code, 0) << ran.errors;
            EXPECT_EQ(digest_of(ran), digest_of(whole));
            for (const char* key : {"digest", "map_digest"}) {
                EXPECT_EQ(run_json("new")[key], run_json("whole")[key]) << key;
            }
            for (const char* file : {"scenarios.csv", "map.csv", "inputs/ids"}) {
                EXPECT_EQ(read_text(folder_ / "new" / file), read_text(folder_ / "whole" / file));
            }
            EXPECT_GT(run_json("new")["reused_from"]["scenarios"], 50);
            EXPECT_EQ(run_json("new")["reused_from"]["digest"], run_json("old")["digest"]);
            fs::remove_all(folder_ / "new");
        }
        EXPECT_EQ(count_jobs(), jobs + 2);
        // Without a folder.
        const Ran printed =
            run_job("", {"--reuse", folder_ / "old", "--master", master_->address(), "-o", "csv"});
        EXPECT_EQ(printed.output, read_text(folder_ / "whole" / "scenarios.csv")) << printed.errors;
    }
}

TEST_F(ReuseAtMaster, NothingIsSubmittedIfAllResultsAreReused) {
    write_job(60, "level = \"pairs\"");
    ASSERT_EQ(run_job("old").exit_code, 0);
    const Ran ran = run_job("new", {"--reuse", folder_ / "old", "--master", master_->address()});
    ASSERT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_EQ(run_json("new")["digest"], run_json("old")["digest"]);
    EXPECT_EQ(run_json("new")["reused_from"]["scenarios"], 61);
    EXPECT_EQ(count_jobs(), 0u);
}

TEST_F(ReuseAtMaster, WhatACancelledJobHasIsReused) {
    write_job(300, "level = \"pairs\"");
    // Without a worker, the master alone answers all it can.
    const Ran submitted =
        tests::run({cdctl(), "submit", folder_ / "job.toml", "--master", master_->address()});
    ASSERT_EQ(submitted.exit_code, 0) << submitted.errors;
    ASSERT_TRUE(comes_true([&] {
        const Ran jobs =
            tests::run({cdctl(), "get", "jobs", "-o", "json", "--master", master_->address()});
        return nlohmann::json::parse(jobs.output).front()["done"] > 0;
    }));
    ASSERT_EQ(tests::run({cdctl(), "cancel", "last", "--master", master_->address()}).exit_code, 0);
    const Ran whole = run_job("whole");
    start_worker();
    const Ran ran = run_job("new", {"--reuse", "last", "--master", master_->address()});
    ASSERT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_EQ(digest_of(ran), digest_of(whole));
    EXPECT_GT(run_json("new")["reused_from"]["scenarios"], 0);
    EXPECT_TRUE(run_json("new")["reused_from"]["digest"].is_null());
}

} // namespace

} // namespace cd::tests
