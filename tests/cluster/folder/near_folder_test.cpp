// Proves, with real processes, that a results folder of a job with a clearance can be verified, run
// again, reused and extracted from like any other, and that no command takes one clearance for
// another.
#include "tests/cluster/folder/folder_fixture.hpp"

#include <gmock/gmock.h>

#include <sstream>

namespace cd::tests {

namespace {

using testing::HasSubstr;

class NearFolder : public FolderTest {
  protected:
    void write_near_job(const std::string& clearance, const std::string& level = "contacts") {
        write_job(11, "level = \"" + level + "\"\nclearance = " + clearance);
    }
    /// Runs the job into a folder. Returns its manifest.
    nlohmann::json run_into(const std::string& name, std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--out", folder_ / name, "--overwrite"});
        const Ran ran = run(std::move(more));
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return read_json(folder_ / name / "run.json");
    }
    /// Returns the number of the first scenario of a class; "none" if there is none.
    [[nodiscard]] std::string first_of(const std::string& name, const std::string& kind) const {
        std::istringstream rows(read_text(folder_ / name / "scenarios.csv"));
        for (std::string row; std::getline(rows, row);) {
            if (row.find("," + kind + ",") != std::string::npos) {
                return row.substr(0, row.find(','));
            }
        }
        return "none";
    }
};

TEST_F(NearFolder, KeepsItsClearanceAndIsTrue) {
    write_near_job("0.2");
    const auto manifest = run_into("out");
    EXPECT_EQ(manifest["query"]["clearance"], 0.2);
    EXPECT_EQ(manifest["record_version"], 3);
    EXPECT_NE(first_of("out", "near"), "none");
    const Ran verified = tests::run(command("verify", folder_ / "out", {}));
    EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    const Ran again = tests::run(command("run", folder_ / "out", {"--out", folder_ / "again"}));
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(read_json(folder_ / "again" / "run.json")["digest"], manifest["digest"]);
}

TEST_F(NearFolder, TheOptionIsTheKey) {
    write_near_job("0.2");
    const auto of_key = run_into("key");
    write_job(11, "level = \"contacts\"");
    EXPECT_EQ(run_into("option", {"--clearance", "0.2"})["digest"], of_key["digest"]);
    const auto without = run_into("without");
    EXPECT_NE(without["digest"], of_key["digest"]);
    EXPECT_EQ(without["record_version"], 2);
    EXPECT_FALSE(without["query"].contains("clearance"));
}

TEST_F(NearFolder, AnotherClearanceIsAnotherQuestion) {
    write_near_job("0.1");
    run_into("old");
    write_near_job("0.2");
    const auto whole = run_into("new");
    const Ran refused = run({"--reuse", folder_ / "old", "--out", folder_ / "reused"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("query changed (clearance 0.2, was 0.1)"));
    const Ran diff = tests::run({cdctl(), "diff", folder_ / "old", folder_ / "new"});
    EXPECT_THAT(diff.output, HasSubstr("query changed (clearance 0.2, was 0.1)"));
    const auto reused = run_into("reused", {"--reuse", folder_ / "new"});
    EXPECT_EQ(reused["digest"], whole["digest"]);
    EXPECT_EQ(reused["reused_from"]["scenarios"], whole["poses"]["count"]);
    write_job(11, "level = \"contacts\"");
    EXPECT_THAT(run({"--reuse", folder_ / "new", "--out", folder_ / "none"}).errors,
                HasSubstr("query changed (clearance none, was 0.2)"));
}

TEST_F(NearFolder, ACaseOfANearScenarioGivesItsRecordAgain) {
    write_near_job("0.2");
    run_into("out");
    const std::string scenario = first_of("out", "near");
    for (const std::vector<std::string>& options :
         {std::vector<std::string>(), std::vector<std::string>{"--minimal"}}) {
        std::vector<std::string> more{scenario, "--out", folder_ / "case"};
        more.insert(more.end(), options.begin(), options.end());
        const Ran made = tests::run(command("extract", folder_ / "out", std::move(more)));
        ASSERT_EQ(made.exit_code, 0) << made.errors;
        const auto expected = read_json(folder_ / "case" / "expected.json");
        EXPECT_EQ(expected["scenarios"][0]["class"], "near");
        EXPECT_EQ(expected["scenarios"][0]["count"], 0);
        EXPECT_GT(expected["scenarios"][0]["near_count"], 0);
        const Ran again = tests::run({cdctl(), "run", folder_ / "case" / "job.toml"});
        EXPECT_EQ(digest_of(again), expected["digest"].get<std::string>().substr(0, 16));
    }
}

TEST_F(NearFolder, FailOnNearTellsAMissFromANearMiss) {
    write_text(folder_ / "poses.csv", "x\n2.5\n");
    const std::string job = "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = "
                            "\"poses.csv\"\n[query]\nlevel = \"any\"\nclearance = ";
    write_text(job_, job + "0.05\n"); // The torus ends at 1.4, the sphere begins at 1.5.
    EXPECT_EQ(run({"--fail-on", "near"}).exit_code, 0);
    write_text(job_, job + "0.15\n");
    EXPECT_EQ(run({"--fail-on", "near"}).exit_code, 1);
    EXPECT_EQ(run({"--fail-on", "touch"}).exit_code, 0);
    write_job(3, "level = \"any\"");
    const Ran without = run({"--fail-on", "near"});
    EXPECT_EQ(without.exit_code, 2);
    EXPECT_THAT(without.errors, HasSubstr("--fail-on near needs a clearance"));
}

} // namespace

} // namespace cd::tests
