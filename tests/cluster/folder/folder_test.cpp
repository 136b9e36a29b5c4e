// Proves, with real processes, that a run into a folder can be interrupted, killed and resumed;
// that its folder opens without the source files; and that its content never mixes with another
// run's.
#include "common/core/build_info.hpp"
#include "tests/client/import/gltf_text.hpp"
#include "tests/cluster/folder/folder_fixture.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <map>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Folder : public FolderTest {};

TEST_F(Folder, AnInterruptedRunGoesOnWithTheSameCommand) {
    for (const char* query : {"level = \"pairs\"", "level = \"count\"\nmaps = true"}) {
        SCOPED_TRACE(query);
        write_job(200, query);
        const std::string out = folder_ / "out";
        const Ran whole = run({"--out", folder_ / "whole", "--overwrite"});
        ASSERT_EQ(whole.exit_code, 0) << whole.errors;
        EXPECT_THAT(
            stop_early(SIGINT, "out"),
            HasSubstr("of 40 000 are kept in " + out + "; the same command resumes the run"));
        auto begun = read_json(folder_ / "out" / ".part" / "run.json");
        begun["started"] = "2001-02-03T04:05:06Z";
        write_text(folder_ / "out" / ".part" / "run.json", begun.dump());
        stop_early(SIGKILL, "out");
        EXPECT_FALSE(fs::exists(folder_ / "out" / "run.json"));

        const Ran resumed = run({"--out", out});
        ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
        EXPECT_THAT(resumed.errors, HasSubstr("resumed at "));
        EXPECT_EQ(digest_of(resumed), digest_of(whole));
        const auto got = read_json(folder_ / "out" / "run.json");
        const auto expected = read_json(folder_ / "whole" / "run.json");
        EXPECT_EQ(got["started"], "2001-02-03T04:05:06Z");
        EXPECT_EQ(got["commit"], build_commit());
        EXPECT_EQ(got["digest"], expected["digest"]);
        EXPECT_EQ(got["map_digest"], expected["map_digest"]);
        EXPECT_TRUE(got["map_digest"].is_string());
        EXPECT_FALSE(fs::exists(folder_ / "out" / ".part"));
        EXPECT_EQ(read_text(folder_ / "out" / "scenarios.csv"),
                  read_text(folder_ / "whole" / "scenarios.csv"));
        fs::remove_all(out);
    }
}

TEST_F(Folder, ACompleteRunIsToldAndNotRunAgain) {
    write_job(10, "level = \"contacts\"");
    const std::string out = folder_ / "out";
    const Ran first = run({"--out", out, "--formats", "csv"});
    ASSERT_EQ(first.exit_code, 0) << first.errors;
    const auto records = fs::last_write_time(folder_ / "out" / "records");
    const Ran second = run({"--out", out, "--formats", "csv,npz,npz"});
    EXPECT_EQ(second.exit_code, 0);
    EXPECT_THAT(second.errors, HasSubstr("already holds this run"));
    EXPECT_THAT(second.errors, HasSubstr("digest " + digest_of(first)));
    EXPECT_TRUE(fs::exists(folder_ / "out" / "results.npz")) << "a missing format is added";
    EXPECT_EQ(fs::last_write_time(folder_ / "out" / "records"), records);
    const Ran fresh = run({"--out", out, "--fresh"});
    EXPECT_EQ(digest_of(fresh), digest_of(first));
    EXPECT_NE(fs::last_write_time(folder_ / "out" / "records"), records);
}

TEST_F(Folder, AnotherRunIsRefusedUnlessItIsOverwritten) {
    write_job(10, "level = \"pairs\"");
    const std::string out = folder_ / "out";
    ASSERT_EQ(run({"--out", out, "--formats", "csv,csv-pairs,npz"}).exit_code, 0);
    write_text(folder_ / "out" / "mine.txt", "of the user");
    const Ran refused = run({"--out", out, "--level", "count"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr(out + " holds another run (job, of "));
    EXPECT_THAT(refused.errors, HasSubstr("--overwrite"));
    EXPECT_TRUE(fs::exists(folder_ / "out" / "pairs.csv"));

    const Ran replaced =
        run({"--out", out, "--level", "count", "--formats", "json", "--overwrite"});
    EXPECT_EQ(replaced.exit_code, 0) << replaced.errors;
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(out)) {
        names.push_back(entry.path().filename());
    }
    EXPECT_THAT(names,
                testing::UnorderedElementsAre(
                    "mine.txt", "run.json", "records", "summary.json", "results.jsonl", "inputs"));
}

TEST_F(Folder, ResultsOfAnEarlierVersionAreNotMixedWithAndOpenForTheirSummary) {
    write_job(5, "level = \"count\"");
    fs::create_directories(folder_ / "out");
    write_text(folder_ / "out" / "summary.json", "{}");
    write_text(folder_ / "out" / "pairs.csv", "old");
    const std::string out = folder_ / "out";
    const Ran refused = run({"--out", out});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("holds results without a run.json"));
    const Ran opened = tests::run({cdctl(), "run", out});
    EXPECT_EQ(opened.exit_code, 2);
    EXPECT_THAT(opened.errors, HasSubstr("only its summary.json can be opened"));
    EXPECT_EQ(run({"--out", out, "--overwrite"}).exit_code, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out" / "pairs.csv"));
}

TEST_F(Folder, AFolderWhoseRunJsonCannotBeReadIsOverwrittenWhole) {
    write_job(5, "level = \"count\"\nmaps = true");
    write_text(folder_ / "poses.csv", "x\n0\n");
    const std::string out = folder_ / "out";
    ASSERT_EQ(run({"--out", out}).exit_code, 0);
    auto other = read_json(folder_ / "out" / "run.json");
    other["record_version"] = 1;
    for (const std::string& damaged : {std::string("{"), other.dump()}) {
        write_text(folder_ / "out" / "run.json", damaged);
        write_text(folder_ / "out" / "inputs" / "scenarios", "old");
        const Ran refused = run({"--out", out});
        EXPECT_EQ(refused.exit_code, 2);
        EXPECT_THAT(refused.errors, HasSubstr("run.json"));
        EXPECT_THAT(refused.errors, HasSubstr("give another folder with --out, or --overwrite"));
    }
    write_text(folder_ / "out" / "mine.txt", "of the user");
    write_job(5, "level = \"count\"");
    const Ran replaced = run({"--out", out, "--overwrite"});
    ASSERT_EQ(replaced.exit_code, 0) << replaced.errors;
    EXPECT_FALSE(fs::exists(folder_ / "out" / "maps"));
    EXPECT_FALSE(fs::exists(folder_ / "out" / "inputs" / "scenarios"));
    EXPECT_TRUE(fs::exists(folder_ / "out" / "mine.txt"));
}

TEST_F(Folder, AMapOfAnotherRunIsNotExported) {
    write_job(5, "level = \"count\"\nmaps = true");
    ASSERT_EQ(run({"--out", folder_ / "maps"}).exit_code, 0);
    write_job(5, "level = \"count\"");
    ASSERT_EQ(run({"--out", folder_ / "out", "--formats", "json"}).exit_code, 0);
    fs::copy_file(folder_ / "maps" / "maps", folder_ / "out" / "maps");
    ASSERT_EQ(tests::run({cdctl(), "results", folder_ / "out", "--formats", "csv"}).exit_code, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out" / "map.csv"));
}

TEST_F(Folder, FreshBeginsAnewAfterAnInterrupt) {
    write_job(200, "level = \"pairs\"");
    stop_early(SIGINT, "out");
    const Ran fresh = run({"--out", folder_ / "out", "--fresh"});
    EXPECT_EQ(fresh.exit_code, 0) << fresh.errors;
    EXPECT_THAT(fresh.errors, Not(HasSubstr("resumed at")));
    EXPECT_FALSE(read_json(folder_ / "out" / "summary.json").contains("resumed_at"));
}

TEST_F(Folder, ARunOfAPoseFileGoesOn) {
    std::string rows = "x,y,yaw_deg\n";
    for (int i = 0; i < 40'000; ++i) {
        rows += std::to_string(i % 25 * 0.1) + "," + std::to_string(i % 7 * 0.2) + "," +
                std::to_string(i % 360) + "\n";
    }
    write_text(folder_ / "poses.csv", rows);
    write_text(job_,
               "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"poses.csv\"\n");
    const Ran whole = run({"--out", folder_ / "whole", "--formats", "csv"});
    stop_early(SIGKILL, "out");
    const Ran resumed = run({"--out", folder_ / "out", "--formats", "csv"});
    EXPECT_THAT(resumed.errors, HasSubstr("resumed at "));
    EXPECT_EQ(digest_of(resumed), digest_of(whole));
    const auto poses = [&](const char* name) {
        return read_json(folder_ / name / "run.json")["poses"]["sha256"];
    };
    EXPECT_EQ(poses("out"), poses("whole"));
    EXPECT_THAT(tests::run({cdctl(), "verify", folder_ / "out", "--sample", "50"}).output,
                HasSubstr("50 the same"));
}

TEST_F(Folder, AFolderIsRunAgainWithoutWritingAnything) {
    write_job(5, "level = \"count\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    const auto all_files = [&] {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
            if (entry.is_regular_file()) {
                files[entry.path()] = read_text(entry.path());
            }
        }
        return files;
    };
    const auto before = all_files();
    const std::string line = "cd " + folder_.path().string() + " && " + cdctl() + " run out";
    EXPECT_EQ(tests::run({"/bin/sh", "-c", line}).exit_code, 0);
    EXPECT_EQ(all_files(), before);
}

TEST_F(Folder, AFolderRunsAgainWithoutTheFilesThatItCameFrom) {
    write_text(folder_ / "poses.csv",
               "id,x,y,z,qx,qy,qz,qw\np0,3,0,0,0,0,0,1\np1,1,0,0,0,0,0.1,1\np2,0.5,0,0,0,0,0,1\n");
    write_text(folder_ / "job.toml",
               "unit = \"cm\"\n[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\nunit = \"cm\"\n"
               "name = \"ball\"\n[poses]\nfile = \"poses.csv\"\nrigid_tolerance = 1\n[query]\n"
               "level = \"contacts\"\nlimit_pairs = 7\n");
    const Ran first = run({"--out", folder_ / "out"});
    ASSERT_EQ(first.exit_code, 0) << first.errors;
    for (const char* file : {"a.obj", "b.obj", "poses.csv", "job.toml"}) {
        fs::remove(folder_ / file);
    }
    const Ran again = tests::run({cdctl(), "run", folder_ / "out", "--out", folder_ / "again"});
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(digest_of(again), digest_of(first));
    EXPECT_EQ(read_text(folder_ / "again" / "records"), read_text(folder_ / "out" / "records"));
    EXPECT_EQ(read_text(folder_ / "out" / "inputs" / "ids"), "id\np0\np1\np2\n");
    EXPECT_EQ(read_text(folder_ / "again" / "inputs" / "ids"), "id\np0\np1\np2\n");
    const auto bodies = read_json(folder_ / "again" / "run.json")["bodies"];
    EXPECT_EQ(bodies[0]["name"], "a");
    EXPECT_EQ(bodies[1]["name"], "ball");
    EXPECT_EQ(bodies, read_json(folder_ / "out" / "run.json")["bodies"]);
}

TEST_F(Folder, WithoutInputsTheFilesAreReadAgainAndAChangedOneIsNamed) {
    write_text(folder_ / "poses.csv", "x,y,z,qx,qy,qz,qw\n3,0,0,0,0,0,1\n1,0,0,0,0,0,1\n");
    write_text(folder_ / "job.toml",
               "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"poses.csv\"\n");
    const std::string out = folder_ / "out";
    const Ran first = run({"--out", out, "--no-inputs"});
    ASSERT_EQ(first.exit_code, 0) << first.errors;
    EXPECT_FALSE(fs::exists(folder_ / "out" / "inputs"));
    EXPECT_EQ(digest_of(tests::run({cdctl(), "run", out})), digest_of(first));

    write_text(folder_ / "poses.csv", "x,y,z,qx,qy,qz,qw\n3,0,0,0,0,0,1\n2,0,0,0,0,0,1\n");
    const Ran poses = tests::run({cdctl(), "run", out});
    EXPECT_EQ(poses.exit_code, 2);
    EXPECT_THAT(poses.errors, HasSubstr("poses.csv has changed since the run"));
    write_obj(folder_ / "b.obj", make_sphere(1));
    const Ran mesh = tests::run({cdctl(), "run", out});
    EXPECT_EQ(mesh.exit_code, 2);
    EXPECT_THAT(mesh.errors, HasSubstr("b.obj has changed since the run"));
}

TEST_F(Folder, WithoutInputsTheFilesAreReadInTheSameWay) {
    const std::string poses =
        "[poses]\nunit = \"mm\"\ngrid = { x = [-2000, 2000, 30], yaw_deg = [0, 90, 3] }\n";
    write_text(folder_ / "a.off",
               "OFF\n4 4 0\n0 0 0\n1.1 0 0\n0 1.3 0\n0 0 1.7\n"
               "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    write_text(folder_ / "job.toml",
               "unit = \"cm\"\n[a]\nmesh = \"a.off\"\nup = \"y\"\nprecision = \"float\"\n"
               "unit = \"in\"\n[b]\nmesh = \"b.gltf\"\n" +
                   poses);
    write_text(folder_ / "b.gltf", GltfText::triangle().text());
    const std::string out = folder_ / "out";
    const Ran first = run({"--out", out, "--no-inputs"});
    ASSERT_EQ(first.exit_code, 0) << first.errors;
    const auto bodies = read_json(folder_ / "out" / "run.json")["bodies"];
    EXPECT_EQ(bodies[0]["up"], "y");
    EXPECT_EQ(bodies[0]["precision"], "float");
    EXPECT_EQ(bodies[0]["unit"], "in");
    EXPECT_EQ(bodies[1]["unit"], "m") << "what glTF declares";
    EXPECT_EQ(bodies[1]["unit_given"], false);
    const Ran again = tests::run({cdctl(), "run", out, "--out", folder_ / "again"});
    EXPECT_EQ(digest_of(again), digest_of(first)) << again.errors;
    EXPECT_EQ(read_json(folder_ / "again" / "run.json")["bodies"], bodies);
}

TEST_F(Folder, ResultsMakesMoreFormatsOfAFolderWithoutRunning) {
    write_job(12, "level = \"contacts\"");
    const std::string out = folder_ / "out";
    ASSERT_EQ(run({"--out", out, "--formats", "json"}).exit_code, 0);
    const std::string formats = "csv,csv-pairs,npz,text,vtp,glb";
    ASSERT_EQ(run({"--out", folder_ / "all", "--formats", formats}).exit_code, 0);
    fs::remove(folder_ / "a.obj"); // Only the folder is read.
    const Ran made = tests::run({cdctl(), "results", out, "--formats", formats});
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    for (const char* name : {"scenarios.csv",
                             "groups.csv",
                             "a.vtp",
                             "b.vtp",
                             "contacts.vtp",
                             "a.glb",
                             "b.glb",
                             "pairs.csv",
                             "points.csv",
                             "results.npz",
                             "results.txt",
                             "map.csv",
                             "map.npz"}) {
        EXPECT_EQ(read_text(folder_ / "out" / name), read_text(folder_ / "all" / name)) << name;
        EXPECT_FALSE(read_text(folder_ / "out" / name).empty()) << name;
    }
    const Ran printed = tests::run({cdctl(), "results", out, "-o", "csv"});
    EXPECT_EQ(printed.output, read_text(folder_ / "all" / "scenarios.csv"));
    const Ran unknown = tests::run({cdctl(), "results", out, "--formats", "xml"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.errors, HasSubstr("this version has"));
}

TEST_F(Folder, MapsOfLevelCountAreThereForLaterFormats) {
    write_job(12, "level = \"count\"\nmaps = true");
    ASSERT_EQ(run({"--out", folder_ / "out", "--formats", "csv"}).exit_code, 0);
    ASSERT_EQ(run({"--out", folder_ / "npz", "--formats", "npz"}).exit_code, 0);
    ASSERT_EQ(tests::run({cdctl(), "results", folder_ / "out", "--formats", "npz"}).exit_code, 0);
    EXPECT_EQ(read_text(folder_ / "out" / "map.npz"), read_text(folder_ / "npz" / "map.npz"));
}

TEST_F(Folder, AMapOfAnotherVersionIsRefusedOnlyByVerbsThatReadIt) {
    write_job(5, "level = \"count\"\nmaps = true");
    const std::string out = folder_ / "out";
    ASSERT_EQ(run({"--out", out}).exit_code, 0);
    std::string maps = read_text(folder_ / "out" / "maps");
    maps.at(8) = 1; // The version follows the 8 bytes of the magic number.
    write_text(folder_ / "out" / "maps", maps);
    const Ran verified = tests::run({cdctl(), "verify", out});
    EXPECT_EQ(verified.exit_code, 0) << verified.errors;
    const Ran extracted = tests::run({cdctl(), "extract", out, "0", "--out", folder_ / "case"});
    EXPECT_EQ(extracted.exit_code, 0) << extracted.errors;
    const Ran report = tests::run({cdctl(), "report", out, "-o", folder_ / "report.html"});
    EXPECT_EQ(report.exit_code, 2);
    EXPECT_THAT(report.errors,
                HasSubstr("out/maps has version 1; this program reads version 2; run the job "
                          "again with --fresh"));
}

TEST_F(Folder, TwoRunsDoNotWriteOneFolder) {
    write_job(200, "level = \"pairs\"");
    Process first(command("run", "", {"--out", folder_ / "out"}), folder_ / "first");
    EXPECT_TRUE(comes_true([&] { return fs::exists(folder_ / "out" / ".part" / "records"); }));
    first.signal(SIGSTOP);
    const Ran second = run({"--out", folder_ / "out"});
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_THAT(second.errors, HasSubstr("out/.part is in use by another process"));
    first.signal(SIGKILL);
}

TEST_F(Folder, VerifyFindsARecordThatIsWrong) {
    write_job(12, "level = \"pairs\"");
    const std::string out = folder_ / "out";
    ASSERT_EQ(run({"--out", out}).exit_code, 0);
    const Ran right = tests::run({cdctl(), "verify", out});
    EXPECT_EQ(right.exit_code, 0) << right.errors;
    EXPECT_THAT(right.output, HasSubstr("144 of 144 scenarios run again: 144 the same"));
    const Ran few = tests::run({cdctl(), "verify", out, "--sample", "10", "--seed", "5"});
    EXPECT_THAT(few.output, HasSubstr("10 of 144 scenarios run again: 10 the same"));

    // Records of these poses with another mesh.
    write_obj(folder_ / "b.obj", make_sphere(1));
    ASSERT_EQ(run({"--out", folder_ / "other"}).exit_code, 0);
    fs::copy_file(folder_ / "other" / "records",
                  folder_ / "out" / "records",
                  fs::copy_options::overwrite_existing);
    const Ran wrong = tests::run({cdctl(), "verify", out});
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_THAT(wrong.output, HasSubstr(" differs\n"));
}

} // namespace

} // namespace cd::tests
