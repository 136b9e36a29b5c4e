// Proves, with real processes, that a results folder of shot lines can be verified, run again and
// exported like any other, with or without its inputs, and that mistakes end a run with their line
// and exit code 2.
#include "tests/cluster/folder/folder_fixture.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace cd::tests {

namespace {

using testing::HasSubstr;

class ShotsFolder : public FolderTest {
  protected:
    void write_shots(const std::string& shots, const std::string& more = "") {
        write_text(folder_ / "job.toml", "[a]\nmesh = \"a.obj\"\n[shots]\n" + shots + more);
    }
    void write_grid(const std::string& more = "") {
        write_shots("spacing = 0.125\ntile = 8\nazimuth_deg = [0, 90, 2]\n", more);
    }
    /// Runs the job into a folder. Returns its manifest.
    nlohmann::json run_into(const std::string& name, std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--out", folder_ / name, "--overwrite"});
        const Ran ran = run(std::move(more));
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return read_json(folder_ / name / "run.json");
    }
    [[nodiscard]] Ran again(const std::string& name) {
        return tests::run(command("run", folder_ / name, {}));
    }
};

TEST_F(ShotsFolder, KeepsItsLinesAndIsTrue) {
    write_grid();
    const auto manifest = run_into("out");
    EXPECT_EQ(manifest["query"]["question"], "shots");
    EXPECT_EQ(manifest["poses"]["kind"], "shots");
    EXPECT_EQ(manifest["bodies"][1]["name"], "lines");
    EXPECT_EQ(manifest["record_version"], 3);
    const Ran verified = tests::run(command("verify", folder_ / "out", {}));
    EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
    const std::string digest = manifest["digest"].get<std::string>().substr(0, 16);
    EXPECT_EQ(digest_of(again("out")), digest);
    std::filesystem::remove_all(folder_ / "out" / "inputs");
    EXPECT_EQ(digest_of(again("out")), digest) << "lines and poses are made again";
}

TEST_F(ShotsFolder, HasHitsAndPassagesInFiles) {
    write_grid();
    run_into("out", {"--formats", "csv,csv-pairs,npz"});
    const std::string lines = read_text(folder_ / "out" / "shotlines.csv");
    EXPECT_GT(std::ranges::count(lines, '\n'), 100);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / "shots.npz"));
    EXPECT_THAT(read_text(folder_ / "out" / "scenarios.csv"), HasSubstr("count,hits,cut"));
    const auto summary = read_json(folder_ / "out" / "summary.json");
    EXPECT_EQ(summary["question"], "shots");
    ASSERT_EQ(summary["parts_hit"].size(), 1u);
    EXPECT_TRUE(summary["parts_hit"][0]["closed"]);
    EXPECT_GT(summary["parts_hit"][0]["seen_area"], 0);
    run_into("later");
    const Ran added = tests::run(command("results", folder_ / "later", {"--formats", "csv-pairs"}));
    EXPECT_EQ(added.exit_code, 0) << added.errors;
    EXPECT_EQ(read_text(folder_ / "later" / "shotlines.csv"), lines);
}

TEST_F(ShotsFolder, FirstHitsAreAnotherQuestion) {
    write_grid();
    const auto all = run_into("all");
    write_shots("spacing = 0.125\ntile = 8\nazimuth_deg = [0, 90, 2]\nfirst = true\n");
    EXPECT_NE(run_into("first")["digest"], all["digest"]);
    const Ran refused = run({"--reuse", folder_ / "all", "--out", folder_ / "reused"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("query changed (first true, was false)"));
    write_grid();
    const auto reused = run_into("reused", {"--reuse", folder_ / "all"});
    EXPECT_EQ(reused["digest"], all["digest"]);
    EXPECT_EQ(reused["reused_from"]["scenarios"], all["poses"]["count"]);
}

TEST_F(ShotsFolder, MapsOfACountedRunCanBeReadAgain) {
    write_grid("[query]\nlevel = \"count\"\nmaps = true\n");
    run_into("out");
    const Ran added = tests::run(command("results", folder_ / "out", {"--formats", "vtp"}));
    EXPECT_EQ(added.exit_code, 0) << added.errors;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / "a.vtp"));
}

TEST_F(ShotsFolder, MistakesEndTheRunWithTheirLine) {
    const auto errors = [&] {
        const Ran ran = run({});
        EXPECT_EQ(ran.exit_code, 2);
        return ran.errors;
    };
    write_grid("[query]\nclearance = 0.1\n");
    EXPECT_THAT(errors(), HasSubstr("job.toml:8: [query]: a line of [shots] hits"));
    write_grid("[query]\nlevel = \"distance\"\n");
    EXPECT_THAT(errors(), HasSubstr("job.toml:8: [query]: lines of [shots] are asked"));
    write_grid("[b]\nmesh = \"b.obj\"\n");
    EXPECT_THAT(errors(), HasSubstr("job.toml:7: the job: [shots] takes the place of"));
    write_shots("spacing = 1e-9\n");
    EXPECT_THAT(errors(), HasSubstr("job.toml:3: [shots]: "));
    write_shots("file = \"none.npy\"\n");
    EXPECT_THAT(run({}).errors, HasSubstr("none.npy"));
    write_grid();
    EXPECT_EQ(run({"--level", "contacts"}).exit_code, 2);
    EXPECT_EQ(run({"--clearance", "1"}).exit_code, 2);
}

} // namespace

} // namespace cd::tests
