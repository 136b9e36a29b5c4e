// Proves, with real processes, that a results folder of a job that asks for distances can be
// verified, run again, reused and extracted from like any other, and that keys which do not go
// together with a distance end a run with their line and exit code 2.
#include "tests/cluster/folder/folder_fixture.hpp"

#include <gmock/gmock.h>

namespace cd::tests {

namespace {

using testing::HasSubstr;

class DistanceFolder : public FolderTest {
  protected:
    void write_distance_job(const std::string& more = "") {
        write_job(9, "level = \"distance\"\n" + more);
    }
    /// Runs the job into a folder. Returns its manifest.
    nlohmann::json run_into(const std::string& name, std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--out", folder_ / name, "--overwrite"});
        const Ran ran = run(std::move(more));
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return read_json(folder_ / name / "run.json");
    }
    /// Returns the number of the first scenario of a folder that has a distance.
    [[nodiscard]] std::string first_apart(const std::string& name) const {
        const auto file = RecordFile::open(folder_ / name / "records");
        const std::vector<KeptRecord> records = file.value().read(0).value();
        for (const KeptRecord& kept : records) {
            if (kept.result.nearest) {
                return std::to_string(kept.result.index);
            }
        }
        return "none";
    }
};

TEST_F(DistanceFolder, KeepsItsQuestionAndIsTrue) {
    write_distance_job("up_to = 1.5");
    const auto manifest = run_into("out");
    EXPECT_EQ(manifest["query"]["question"], "distance");
    EXPECT_EQ(manifest["query"]["level"], "any");
    EXPECT_EQ(manifest["query"]["up_to"], 1.5);
    EXPECT_EQ(manifest["record_version"], 3);
    const Ran verified = tests::run(command("verify", folder_ / "out", {}));
    EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    const Ran again = tests::run(command("run", folder_ / "out", {"--out", folder_ / "again"}));
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(read_json(folder_ / "again" / "run.json")["digest"], manifest["digest"]);
}

TEST_F(DistanceFolder, TheOptionIsTheKey) {
    write_distance_job("up_to = 0.001");
    const auto of_keys = run_into("keys");
    write_job(9, "level = \"any\"");
    const auto of_options = run_into("options", {"--level", "distance", "--up-to", "0.001"});
    EXPECT_EQ(of_options["digest"], of_keys["digest"]);
    EXPECT_NE(run_into("any")["digest"], of_keys["digest"]);
    EXPECT_NE(run_into("all", {"--level", "distance"})["digest"], of_keys["digest"]);
}

TEST_F(DistanceFolder, AnotherUpToIsAnotherQuestion) {
    write_distance_job("up_to = 0.5");
    run_into("old");
    write_distance_job();
    const auto whole = run_into("new");
    const Ran refused = run({"--reuse", folder_ / "old", "--out", folder_ / "reused"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("query changed (up_to none, was 0.5)"));
    const auto reused = run_into("reused", {"--reuse", folder_ / "new"});
    EXPECT_EQ(reused["digest"], whole["digest"]);
    EXPECT_EQ(reused["reused_from"]["scenarios"], whole["poses"]["count"]);
    write_job(9, "level = \"any\"");
    EXPECT_THAT(run({"--reuse", folder_ / "new", "--out", folder_ / "none"}).errors,
                HasSubstr("query changed (level any, was distance)"));
}

TEST_F(DistanceFolder, ACaseGivesTheDistanceAgain) {
    write_distance_job();
    run_into("out");
    const std::string scenario = first_apart("out");
    for (const std::vector<std::string>& options :
         {std::vector<std::string>(), std::vector<std::string>{"--minimal"}}) {
        std::vector<std::string> more{scenario, "--out", folder_ / "case"};
        more.insert(more.end(), options.begin(), options.end());
        const Ran made = tests::run(command("extract", folder_ / "out", std::move(more)));
        ASSERT_EQ(made.exit_code, 0) << made.errors;
        const auto expected = read_json(folder_ / "case" / "expected.json");
        EXPECT_GT(expected["scenarios"][0]["distance"], 0);
        const Ran again = tests::run({cdctl(), "run", folder_ / "case" / "job.toml"});
        EXPECT_EQ(digest_of(again), expected["digest"].get<std::string>().substr(0, 16));
    }
}

TEST_F(DistanceFolder, KeysThatDoNotGoWithItEndTheRunWithTheirLine) {
    write_distance_job("clearance = 0.1");
    const Ran clearance = run({});
    EXPECT_EQ(clearance.exit_code, 2);
    EXPECT_THAT(clearance.errors, HasSubstr("job.toml:9: [query]: level distance tells how far"));
    write_job(9, "up_to = 0.1");
    const Ran up_to = run({});
    EXPECT_EQ(up_to.exit_code, 2);
    EXPECT_THAT(up_to.errors, HasSubstr("job.toml:8: [query]: up_to belongs to level distance"));
    write_distance_job();
    EXPECT_EQ(run({"--maps"}).exit_code, 2);
    EXPECT_EQ(run({"--limit-pairs", "7"}).exit_code, 2);
    EXPECT_EQ(run({"--up-to", "-1"}).exit_code, 2);
}

} // namespace

} // namespace cd::tests
