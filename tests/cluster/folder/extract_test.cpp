// Proves, with real processes, that scenarios extracted from a run become a job with identical
// records, and that unsuitable input is refused.
#include "common/job/result/record_file.hpp"
#include "tests/cluster/folder/folder_fixture.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/vtp_arrays.hpp"

#include <gmock/gmock.h>

#include <set>
#include <sstream>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Extract : public FolderTest {
  protected:
    [[nodiscard]] Ran extract(const std::string& scenarios, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {scenarios, "--out", folder_ / "case"});
        return tests::run(command("extract", folder_ / "out", std::move(more)));
    }
    /// Writes a job with the poses of poses.csv.
    void write_job_of_file(const std::string& poses, const std::string& query) {
        write_text(job_,
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"poses.csv\"\n" +
                       poses + "[query]\n" + query + "\n");
    }
    /// Runs the case and compares the digest and the hash of each record.
    void expect_the_case_gives_what_it_says() {
        const std::string out = folder_ / "again";
        const Ran again = tests::run(
            {cdctl(), "run", folder_ / "case" / "job.toml", "--out", out, "--overwrite"});
        const auto expected = read_json(folder_ / "case" / "expected.json");
        EXPECT_EQ(digest_of(again), expected["digest"].get<std::string>().substr(0, 16));
        const auto records = RecordFile::open(folder_ / "again" / "records");
        ASSERT_TRUE(records);
        std::vector<std::string> hashes;
        ASSERT_TRUE(records.value().for_each([&](const RecordView& record) {
            hashes.push_back(to_hex(sha256(record.bytes)));
            return Status(Done{});
        }));
        ASSERT_EQ(hashes.size(), expected["scenarios"].size());
        for (std::size_t i = 0; i < hashes.size(); ++i) {
            EXPECT_EQ(expected["scenarios"][i]["record_sha256"], hashes[i]);
        }
    }
};

TEST_F(Extract, AnExtractedCaseGivesTheSameRecords) {
    // The poses give separate, corner touch, cross and inside.
    write_obj(folder_ / "a.obj", make_box({2, 2, 2}));
    write_obj(folder_ / "b.obj", make_box({1, 1, 1}));
    write_text(
        folder_ / "poses.csv",
        "x,y,z,qx,qy,qz,qw\n9,0,0,0,0,0,1\n1.5,1.5,1.5,0,0,0,1\n1.25,0.3,0.1,0.1,0.2,0.3,0.9\n"
        "0.1,0.2,0,0,0,0,1\n");
    std::set<std::string> classes;
    for (const std::string query : {"level = \"contacts\"",
                                    "level = \"any\"",
                                    "level = \"count\"",
                                    "level = \"pairs\"\nlimit_pairs = 2"}) {
        SCOPED_TRACE(query);
        write_text(folder_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"poses.csv\"\n"
                   "rigid_tolerance = 1\n[query]\n" +
                       query + "\n");
        ASSERT_EQ(run({"--out", folder_ / "out", "--overwrite"}).exit_code, 0);
        for (const std::string scenarios : {"0", "1", "2", "3", "1-3"}) {
            const Ran made = extract(scenarios);
            ASSERT_EQ(made.exit_code, 0) << made.errors;
            expect_the_case_gives_what_it_says();
            const auto expected = read_json(folder_ / "case" / "expected.json");
            for (const auto& each : expected["scenarios"]) {
                classes.insert(each["class"]);
            }
        }
    }
    EXPECT_THAT(classes,
                testing::IsSupersetOf({"separate", "touch", "cross", "inside", "contact"}));
    const Ran none = tests::run({cdctl(), "extract", folder_ / "out", "4"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_THAT(none.errors, HasSubstr("the run has the scenarios 0 to 3"));
}

TEST_F(Extract, ASmallestCaseHasTheRunsContactsUnderNewNumbers) {
    write_job(12, "level = \"contacts\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    std::istringstream rows(read_text(folder_ / "out" / "scenarios.csv"));
    std::string crossing;
    for (std::string row; std::getline(rows, row);) {
        crossing =
            row.find(",cross,") == std::string::npos ? crossing : row.substr(0, row.find(','));
    }
    const Ran made = extract(crossing, {"--minimal"});
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    const auto faces = read_npz(folder_ / "case" / "a.npz");
    ASSERT_TRUE(faces);
    EXPECT_LT(faces.value().at("faces").shape[0], make_torus(1.0, 0.4, 24, 12).triangles().size());
    EXPECT_THAT(read_text(folder_ / "case" / "ids.csv"),
                testing::StartsWith("body,triangle,triangle_in_run\na,0,"));
    expect_the_case_gives_what_it_says();
}

TEST_F(Extract, PosesOfAnyFormAreThoseThatWereTested) {
    const std::string matrices =
        "m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n"
        "0.6,-0.8,0,1.1,0.8,0.6,0,0.1,0,0,1,0.3\n1,0,0,0.3,0,1,0,0,0,0,1,0.1\n";
    const std::string both = "scenario,body,x,y,z,qx,qy,qz,qw\n0,a,0.1,0,0,0,0,0.1,1\n"
                             "0,b,1,0.1,0.2,0.1,0,0,1\n1,a,0,0,7,0,0,0,1\n1,b,0.9,0,7,0,0,0,1\n";
    const std::string scaled = "m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n"
                               "2,0,0,1.1,0,2,0,0.1,0,0,2,0.3\n3,0,0,0.3,0,3,0,0,0,0,3,0.1\n";
    for (const auto& [poses, more] : {std::pair(matrices, "rigid_tolerance = 1\n"),
                                      std::pair(both, "rigid_tolerance = 1\nof = \"both\"\n"),
                                      std::pair(scaled, "rigid_tolerance = 8\n")}) {
        SCOPED_TRACE(poses);
        write_text(folder_ / "poses.csv", poses);
        write_job_of_file(more, "level = \"contacts\"");
        ASSERT_EQ(run({"--out", folder_ / "out", "--overwrite"}).exit_code, 0);
        for (const char* scenarios : {"0", "1", "0-1"}) {
            const Ran made = extract(scenarios);
            ASSERT_EQ(made.exit_code, 0) << made.errors;
            expect_the_case_gives_what_it_says();
        }
    }
}

TEST_F(Extract, OfOpenBodiesACaseSpeaksOfSurfacesToo) {
    const Mesh torus = make_torus(1.0, 0.4, 24, 12);
    std::vector<Triangle> triangles = torus.triangles();
    triangles.pop_back();
    write_obj(folder_ / "a.obj", make_mesh(torus.vertices(), triangles));
    write_text(folder_ / "poses.csv", "x\n0\n1\n9\n");
    write_job_of_file("", "level = \"any\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    const Ran made = extract("0-2");
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    expect_the_case_gives_what_it_says();
    const Ran shown = tests::run({cdctl(), "run", folder_ / "case" / "job.toml", "-o", "json"});
    EXPECT_THAT(shown.output, HasSubstr("\"surfaces_only\":true"));
}

TEST_F(Extract, ASmallestCaseOfAnotherClassIsRefused) {
    write_obj(folder_ / "a.obj", make_sphere(0));
    write_obj(folder_ / "b.obj", make_box({0.4, 0.4, 0.4}));
    write_text(folder_ / "poses.csv", "x\n0.35\n");
    for (const char* level : {"any", "pairs"}) {
        write_job_of_file("", "level = \"" + std::string(level) + "\"");
        ASSERT_EQ(run({"--out", folder_ / "out", "--overwrite"}).exit_code, 0);
        const Ran refused = extract("0", {"--minimal"});
        EXPECT_EQ(refused.exit_code, 2);
        EXPECT_EQ(refused.errors,
                  "cdctl: scenario 0 is inside, and its smallest meshes are separate (surfaces "
                  "only): the class depends on more triangles; without --minimal the case has "
                  "all\n");
        EXPECT_FALSE(fs::exists(folder_ / "case"));
        EXPECT_EQ(extract("0").exit_code, 0);
        fs::remove_all(folder_ / "case");
    }
}

TEST_F(Extract, AScenarioThatFailedIsRefused) {
    write_job(2, "level = \"pairs\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    auto records = RecordWriter::create(folder_ / "out" / "records");
    ASSERT_TRUE(records);
    for (std::uint64_t i = 0; i < 4; ++i) {
        ScenarioResult result;
        result.index = i;
        result.kind = i == 1 ? ScenarioClass::Failed : ScenarioClass::Separate;
        result.failure = i == 1 ? "scenario 1: its worker lost three limbs" : "";
        records.value().add(i, encode_result(result));
    }
    ASSERT_TRUE(records.value().finish());
    const Ran refused = extract("0-2");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors,
                HasSubstr("scenario 1: its worker lost three limbs: a scenario that failed has no "
                          "answer"));
    EXPECT_FALSE(fs::exists(folder_ / "case"));
}

TEST_F(Extract, ARunOfAnEarlierVersionUnderAToleranceIsReadAndNotRunAgain) {
    write_job(2, "level = \"count\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    auto records = RecordWriter::create(folder_ / "out" / "records");
    ASSERT_TRUE(records);
    for (std::uint64_t i = 0; i < 4; ++i) {
        ScenarioResult result;
        result.index = i;
        result.level = Level::Count;
        result.kind = i == 1 ? ScenarioClass::Undecided : ScenarioClass::Separate;
        result.distance_bound = i == 1 ? 0.125 : 0;
        records.value().add(i, encode_result(result));
    }
    ASSERT_TRUE(records.value().finish());
    auto manifest = read_json(folder_ / "out" / "run.json");
    std::string job = manifest["job"];
    manifest["format"] = 1;
    manifest["query"]["tolerance"] = 0.25;
    manifest["job"] = job.insert(job.find("[query]") + 8, "tolerance = 0.25\n");
    write_text(folder_ / "out" / "run.json", manifest.dump());

    const std::string out = folder_ / "out";
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"extract", out, "1"},
             {"verify", out},
             {"run", out},
             {"run", job_, "--reuse", out, "--out", folder_ / "new"}}) {
        std::vector<std::string> line{cdctl()};
        line.insert(line.end(), words.begin(), words.end());
        const Ran refused = tests::run(line);
        EXPECT_EQ(refused.exit_code, 2) << words[0];
        EXPECT_THAT(refused.errors, HasSubstr("the run had a tolerance of 0.25")) << words[0];
    }
    const Ran other = run({"--out", out});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_THAT(other.errors, HasSubstr("another run"));
    EXPECT_EQ(extract("1", {"--as", "glb"}).exit_code, 0);
    const Ran shown = tests::run({cdctl(), "results", out, "-o", "csv"});
    EXPECT_EQ(shown.exit_code, 0) << shown.errors;
    EXPECT_THAT(shown.output, HasSubstr(",undecided,0,0,"));
    EXPECT_THAT(shown.output, HasSubstr(",0.125,"));
    const Ran diff = tests::run({cdctl(), "diff", out, out});
    EXPECT_EQ(diff.exit_code, 0) << diff.errors;
    const Ran report = tests::run({cdctl(), "report", out, "-o", folder_ / "report.html"});
    EXPECT_EQ(report.exit_code, 0) << report.errors;
}

TEST_F(Extract, APictureOfEachScenarioIsDrawn) {
    write_obj(folder_ / "a.obj", make_box({2, 2, 2}));
    write_obj(folder_ / "b.obj", make_box({1, 1, 1}));
    write_text(folder_ / "poses.csv", "x,y,z\n9,0,0\n1.25,0.3,0.1\n");
    write_job_of_file("", "level = \"pairs\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    const Ran drawn = extract("0-1", {"--as", "png"});
    ASSERT_EQ(drawn.exit_code, 0) << drawn.errors;
    EXPECT_THAT(drawn.output, testing::StartsWith("2 pictures in "));
    for (const char* name : {"0.png", "1.png"}) {
        EXPECT_THAT(read_text(folder_ / "case" / name), testing::StartsWith("\x89PNG\r\n"));
    }
    EXPECT_NE(read_text(folder_ / "case" / "0.png"), read_text(folder_ / "case" / "1.png"));
}

TEST_F(Extract, ScenesDoNotDependOnTheRunsLevel) {
    write_obj(folder_ / "a.obj", make_box({2, 2, 2}));
    write_obj(folder_ / "b.obj", make_box({1, 1, 1}));
    write_text(folder_ / "poses.csv", "x,y,z\n1.5,0.3,0.1\n1.25,0.3,0.1\n9,0,0\n");
    std::set<std::string> scenes;
    for (const char* query : {"level = \"contacts\"",
                              "level = \"any\"",
                              "level = \"count\"",
                              "level = \"pairs\"\nlimit_pairs = 2"}) {
        SCOPED_TRACE(query);
        write_job_of_file("", query);
        ASSERT_EQ(run({"--out", folder_ / "out", "--overwrite"}).exit_code, 0);
        fs::remove_all(folder_ / "case");
        const Ran made = extract("0-2", {"--as", "vtp"});
        ASSERT_EQ(made.exit_code, 0) << made.errors;
        EXPECT_THAT(made.output, testing::StartsWith("3 scenes in "));
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_ / "case")) {
            names.insert(entry.path().filename());
        }
        EXPECT_EQ(names,
                  (std::set<std::string>{"a.vtp",
                                         "b-0.vtp",
                                         "b-1.vtp",
                                         "b-2.vtp",
                                         "contacts-0.vtp",
                                         "contacts-1.vtp",
                                         "contacts-2.vtp",
                                         "scenarios.pvd"}));
        ASSERT_EQ(extract("1", {"--as", "glb"}).exit_code, 0);
        scenes.insert(read_text(folder_ / "case" / "contacts-1.vtp") +
                      read_text(folder_ / "case" / "1.glb"));
    }
    EXPECT_EQ(scenes.size(), 1u);
    const auto cells = read_vtp(folder_ / "case" / "contacts-1.vtp");
    EXPECT_THAT(cells.arrays.at("class").as<std::uint8_t>(), testing::Contains(3));
    EXPECT_EQ(read_vtp(folder_ / "case" / "contacts-2.vtp").arrays.at("class").bytes, "");
}

TEST_F(Extract, ABodyThatMovesHasAFileForEachScene) {
    write_text(folder_ / "poses.csv", "scenario,body,x\n0,a,0\n0,b,2\n1,a,1\n1,b,2\n");
    write_job_of_file("of = \"both\"\n", "level = \"pairs\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    ASSERT_EQ(extract("0-1", {"--as", "vtp"}).exit_code, 0);
    for (const char* name : {"a-0.vtp", "a-1.vtp", "b.vtp"}) {
        EXPECT_TRUE(fs::exists(folder_ / "case" / name)) << name;
    }
    EXPECT_FALSE(fs::exists(folder_ / "case" / "a.vtp"));
    EXPECT_FALSE(fs::exists(folder_ / "case" / "b-0.vtp"));
    EXPECT_NE(read_text(folder_ / "case" / "a-0.vtp"), read_text(folder_ / "case" / "a-1.vtp"));
}

TEST_F(Extract, FilesHaveTheNamesOfTheBodies) {
    write_obj(folder_ / "a.obj", make_box({2, 2, 2}));
    write_obj(folder_ / "b.obj", make_box({1, 1, 1}));
    write_text(folder_ / "poses.csv", "x\n9\n1.25\n");
    write_text(job_,
               "[a]\nmesh = \"a.obj\"\nname = \"the/van\"\n[b]\nmesh = \"b.obj\"\nname = "
               "\"contacts-1\"\n[poses]\nfile = \"poses.csv\"\n");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    ASSERT_EQ(extract("1").exit_code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "case" / "the_van.npz"));
    EXPECT_TRUE(fs::exists(folder_ / "case" / "contacts-1.npz"));
    EXPECT_FALSE(fs::exists(folder_ / "case" / "a.npz"));
    expect_the_case_gives_what_it_says();
    ASSERT_EQ(extract("1", {"--as", "vtp"}).exit_code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "case" / "the_van.vtp"));
    EXPECT_TRUE(fs::exists(folder_ / "case" / "contacts-1.vtp")) << "body B, which stands";
    EXPECT_TRUE(fs::exists(folder_ / "case" / "contacts-1_.vtp")) << "its contacts";
    EXPECT_THAT(read_text(folder_ / "case" / "scenarios.pvd"), HasSubstr("\"contacts-1_.vtp\""));
}

TEST_F(Extract, ASceneWithOtherContactsThanTheRunIsRefused) {
    write_job(2, "level = \"pairs\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    auto records = RecordWriter::create(folder_ / "out" / "records");
    ASSERT_TRUE(records);
    for (std::uint64_t i = 0; i < 4; ++i) {
        ScenarioResult result;
        result.index = i;
        result.kind = ScenarioClass::Touch;
        result.pair_count = 1;
        result.pairs = {{0, 0, PairClass::Touch}};
        records.value().add(i, encode_result(result));
    }
    ASSERT_TRUE(records.value().finish());
    const Ran refused = extract("1", {"--as", "glb"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("scenario 1 has other contacts here than in the run"));
    EXPECT_TRUE(fs::is_empty(folder_ / "case"));
    const Ran minimal = extract("1", {"--as", "glb", "--minimal"});
    EXPECT_EQ(minimal.exit_code, 2);
    EXPECT_THAT(minimal.errors, HasSubstr("--minimal belongs to --as case"));
}

TEST_F(Extract, ACasePassesOverThePartsOfItsRun) {
    // Each box of A meets B once; the rule leaves the contacts of one of them.
    write_text(folder_ / "a.obj",
               "o wheel/*\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
               "o ground\nv 0 0 0.5\nv 1 0 0.5\nv 0 1 0.5\nf 4 5 6\n"
               "o far\nv 50 0 0\nv 51 0 0\nv 50 1 0\nf 7 8 9\n");
    write_text(folder_ / "b.obj", "o pole\nv 0.2 0.2 -1\nv 0.2 0.3 -1\nv 0.2 0.2 2\nf 1 2 3\n");
    write_text(folder_ / "poses.csv", "x\n0\n0.1\n");
    write_text(job_,
               "[a]\nmesh = \"a.obj\"\nname = \"car\"\n[b]\nmesh = \"b.obj\"\n[poses]\n"
               "file = \"poses.csv\"\n[query]\nlevel = \"contacts\"\nignore = "
               "[[\"car/wheel\\\\/\\\\*\", \"*\"], [\"far\", \"pole\"]]\n");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    for (const std::vector<std::string>& more : {{}, std::vector<std::string>{"--minimal"}}) {
        SCOPED_TRACE(more.size());
        const Ran made = extract("0-1", more);
        ASSERT_EQ(made.exit_code, 0) << made.errors;
        expect_the_case_gives_what_it_says();
        const auto expected = read_json(folder_ / "case" / "expected.json");
        EXPECT_EQ(expected["scenarios"][1]["count"], 1);
        EXPECT_EQ(expected["scenarios"][1]["class"], "cross");
        const std::string rules = read_text(folder_ / "case" / "job.toml");
        EXPECT_THAT(rules, HasSubstr("[\"car/wheel\\\\/\\\\*\", \"*\"]"));
        EXPECT_EQ(rules.find("\"far\"") == std::string::npos, !more.empty());
    }
}

TEST_F(Extract, TheUsersOwnJobIsNotOverwrittenButAnEarlierCaseIs) {
    fs::create_directories(folder_ / "case");
    write_job(2, "level = \"pairs\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    write_text(folder_ / "case" / "job.toml", "mine");
    const Ran refused = extract("0");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("job.toml is of no case, and would be overwritten"));
    EXPECT_EQ(read_text(folder_ / "case" / "job.toml"), "mine");

    write_text(folder_ / "case" / "expected.json", "{}");
    write_text(folder_ / "case" / "ids.csv", "of --minimal");
    ASSERT_EQ(extract("0").exit_code, 0);
    expect_the_case_gives_what_it_says();
    EXPECT_FALSE(fs::exists(folder_ / "case" / "ids.csv"));
}

} // namespace

} // namespace cd::tests
