// Proves, with real processes, what `diff` tells of two runs, in folders and on a master, and its
// exit codes.
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/cluster/folder/folder_fixture.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Writes boxes of a size as groups of an OBJ file: each a part with a name and the x of its
/// centre.
void write_boxes(const fs::path& path,
                 const Vec3& size,
                 const std::vector<std::pair<std::string, double>>& boxes) {
    std::string text;
    int first = 1;
    for (const auto& [name, x] : boxes) {
        const Mesh box = translated(make_box(size), {x, 0, 0});
        text += "g " + name + "\n";
        for (const Vec3& v : box.vertices()) {
            text += "v " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
                    std::to_string(v.z()) + "\n";
        }
        for (const Triangle& t : box.triangles()) {
            text += "f";
            for (const std::uint32_t corner : t) {
                text += " " + std::to_string(first + static_cast<int>(corner));
            }
            text += "\n";
        }
        first += static_cast<int>(box.vertices().size());
    }
    write_text(path, text);
}

class DiffOfRuns : public FolderTest {
  protected:
    DiffOfRuns() {
        write_boxes(folder_ / "a.obj", {1, 1, 1}, {{"hood", 0}, {"sill", 5}});
        write_boxes(folder_ / "b.obj", {1, 0.6, 0.6}, {{"post", 0}, {"lamp", 10}, {"base", 20}});
        write_poses({"1,9", "2,0.7", "3,4.7", "4,-9.3", "5,-4.3", "6,-19.3"});
        write_query("level = \"pairs\"");
    }

    /// Each row is an id and the x of B.
    void write_poses(const std::vector<std::string>& rows) {
        std::string text = "id,x\n";
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
    void run_into(const std::string& name) {
        const Ran ran = run({"--out", folder_ / name, "--formats", "csv", "--overwrite"});
        ASSERT_EQ(ran.exit_code, 0) << ran.errors;
    }
    [[nodiscard]] Ran diff(std::vector<std::string> more = {}) {
        more.insert(more.begin(), {cdctl(), "diff", folder_ / "old", folder_ / "new"});
        return tests::run(more);
    }
    [[nodiscard]] nlohmann::json diff_json() {
        const Ran ran = diff({"-o", "json"});
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return nlohmann::json::parse(ran.output);
    }
};

TEST_F(DiffOfRuns, OfARunWithItselfIsEmpty) {
    run_into("old");
    run_into("new");
    const Ran same = diff({"--fail-on", "any", "--out", folder_ / "changes"});
    EXPECT_EQ(same.exit_code, 0) << same.errors;
    EXPECT_THAT(same.output, StartsWith("bodies equal, poses equal, query equal\n"));
    EXPECT_THAT(same.output, HasSubstr("  changed       0 of 6\n"));
    EXPECT_THAT(same.output, Not(HasSubstr("new:")));
    for (const char* name : {"diff.csv", "diff_groups.csv", "diff_triangles.csv"}) {
        const std::string rows = read_text(folder_ / "changes" / name);
        EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1) << name << ": only the header";
    }
    EXPECT_EQ(diff({"-o", "csv"}).output, read_text(folder_ / "changes" / "diff.csv"));
}

TEST_F(DiffOfRuns, RemovingAPartResolvesExactlyItsGroups) {
    run_into("old");
    write_boxes(folder_ / "b.obj", {1, 0.6, 0.6}, {{"post", 0}, {"base", 20}});
    run_into("new");
    const Ran ran = diff({"--out", folder_ / "changes"});
    EXPECT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_THAT(ran.output, StartsWith("B changed (2 parts, 1 gone), poses equal, query equal\n"));
    EXPECT_THAT(read_text(folder_ / "changes" / "diff_groups.csv"),
                testing::MatchesRegex("state,[^\n]*\nresolved,a,[^\n]*,b,lamp,1,0,[0-9]+,0,[0-9]+\n"
                                      "resolved,a,[^\n]*,b,lamp,1,0,[0-9]+,0,[0-9]+\n"));
    EXPECT_THAT(ran.output, HasSubstr("  changed       2 of 6\n"));
    EXPECT_THAT(ran.output, HasSubstr(" a: in contact "));
    EXPECT_THAT(ran.output, Not(HasSubstr(" b: in contact "))) << "B's mesh has changed";
    EXPECT_THAT(read_text(folder_ / "changes" / "diff.csv"),
                HasSubstr("\n3,3,a,b,cross,separate,"));
    EXPECT_EQ(diff({"--fail-on", "new"}).exit_code, 0);
    EXPECT_EQ(diff({"--fail-on", "any"}).exit_code, 1);
    fs::rename(folder_ / "old", folder_ / "was");
    fs::rename(folder_ / "new", folder_ / "old");
    fs::rename(folder_ / "was", folder_ / "new");
    EXPECT_THAT(diff().output, StartsWith("B changed (3 parts, 1 new), "));
    EXPECT_EQ(diff({"--fail-on", "new"}).exit_code, 1);
}

TEST_F(DiffOfRuns, ScenariosAreMatchedByIdThenByPose) {
    run_into("old");
    write_poses({"5,-4.3", "7,1", "2,9", "1,9"}); // 2 has moved away.
    run_into("new");
    auto json = diff_json();
    EXPECT_EQ(json["matched_by"], "id");
    EXPECT_EQ(json["inputs"]["poses_equal"], false);
    EXPECT_EQ(json["both"], 3);
    EXPECT_EQ(json["only_old"], 3);
    EXPECT_EQ(json["only_new"], 1);
    EXPECT_EQ(json["changed"], 1);
    EXPECT_EQ(json["classes"]["cross"]["separate"], 1);
    EXPECT_EQ(diff({"-o", "csv"}).output.find("\n2,1,a,b,cross,separate,"),
              std::string("scenario,scenario_old,body_a,body_b,class_old,class,count_old,count,"
                          "change")
                  .size());
    write_text(folder_ / "poses.csv", "x\n1\n-4.3\n9\n9\n");
    run_into("new");
    json = diff_json();
    EXPECT_EQ(json["matched_by"], "poses");
    EXPECT_EQ(json["both"], 2);
    EXPECT_EQ(json["only_old"], 4);
    EXPECT_EQ(json["only_new"], 2);
    EXPECT_EQ(json["changed"], 0);
}

TEST_F(DiffOfRuns, NothingToCompareHasACodeOfItsOwn) {
    run_into("old");
    write_text(folder_ / "poses.csv", "x\n0.123\n");
    run_into("new");
    const Ran ran = diff({"--fail-on", "any"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_THAT(ran.errors,
                HasSubstr("nothing to compare: no scenario has a class in both runs\n"));
}

TEST_F(DiffOfRuns, RandomPosesOfOtherBodiesAreNotTheSame) {
    const std::string bodies = read_text(job_).substr(0, read_text(job_).find("[poses]"));
    write_text(job_, bodies + "[poses]\nrandom = { n = 3, seed = 1 }\n");
    run_into("old");
    write_obj(folder_ / "b.obj", make_box({0.7, 0.8, 0.9}));
    run_into("new");
    const Ran ran = diff();
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_THAT(ran.errors,
                HasSubstr("in both runs; random poses depend on the bodies: runs of a "
                          "grid or of one pose file can be compared\n"));
}

TEST_F(DiffOfRuns, MissingResultsAreToldAndLeaveTheQuestionOpen) {
    run_into("old");
    run_into("new");
    // The results of scenarios 2 and 3 are removed from the later run, as if it had been cancelled.
    {
        auto kept = RecordFile::open(folder_ / "new" / "records");
        auto writer = RecordWriter::create(folder_ / "fewer");
        ASSERT_TRUE(kept && writer);
        ASSERT_TRUE(kept.value().for_each([&](const RecordView& record) -> Status {
            if (record.result.index != 2 && record.result.index != 3) {
                writer.value().add(record.result.index, record.bytes);
            }
            return Done{};
        }));
        ASSERT_TRUE(writer.value().finish());
    }
    fs::rename(folder_ / "fewer", folder_ / "new" / "records");
    auto manifest = read_json(folder_ / "new" / "run.json");
    manifest["answered"] = 4;
    manifest["digest"] = nullptr;
    write_text(folder_ / "new" / "run.json", manifest.dump());
    const Ran ran = diff();
    EXPECT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_THAT(ran.output, HasSubstr("; 2 failed, undecided or without result\n"));
    EXPECT_THAT(ran.output, HasSubstr("not comparable: hood x lamp: 1 scenario, "));
    EXPECT_THAT(ran.output, Not(HasSubstr("resolved")));
    EXPECT_EQ(diff({"--fail-on", "new"}).exit_code, 3) << "who knows what they have";
    EXPECT_EQ(diff({"--fail-on", "any"}).exit_code, 1) << "their class is another: none";
}

TEST_F(DiffOfRuns, LevelsWithoutPairsHaveNoGroups) {
    run_into("old");
    write_query("level = \"any\"");
    run_into("new");
    const Ran ran = diff();
    EXPECT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_THAT(ran.output, HasSubstr("query changed (level any, was pairs)\n"));
    EXPECT_THAT(ran.output, HasSubstr("  changed       0 of 6\n"));
    EXPECT_THAT(ran.output, HasSubstr("  groups        not compared"));
    const Ran refused = diff({"--fail-on", "new"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors,
                HasSubstr("groups need level pairs or contacts, or level count with maps"));
}

TEST_F(DiffOfRuns, MapsOfLevelCountGiveTheTrianglesThatPairsGive) {
    const auto triangles_at = [&](const std::string& query) {
        write_query(query);
        write_poses({"1,9", "2,0.7", "3,4.7"});
        run_into("old");
        write_poses({"1,9", "2,0.75", "3,5.7"});
        run_into("new");
        EXPECT_EQ(diff({"--out", folder_ / "changes"}).exit_code, 0);
        EXPECT_THAT(read_text(folder_ / "changes" / "diff_triangles.csv"), HasSubstr("\na,"));
        return diff_json()["triangles"];
    };
    const auto of_pairs = triangles_at("level = \"pairs\"");
    EXPECT_EQ(triangles_at("level = \"count\"\nmaps = true"), of_pairs);
    EXPECT_EQ(of_pairs.size(), 2u) << "both meshes are equal";
    EXPECT_GT(of_pairs[0]["only_old"], 0);
    EXPECT_GT(of_pairs[0]["only_new"], 0);
    write_poses({"1,9"});
    run_into("new");
    EXPECT_TRUE(diff_json()["triangles"].empty()) << "the maps are of other scenarios";
}

class DiffAtMaster : public Cluster {};

TEST_F(DiffAtMaster, AJobIsComparedAsItsFolderIs) {
    start_worker();
    write_obj(folder_ / "a.obj", make_torus(1.0, 0.4, 24, 12));
    write_obj(folder_ / "b.obj", make_sphere(2));
    const auto run_count = [&](int count, const std::string& out) {
        return tests::run({cdctl(),
                           "run",
                           "--a",
                           folder_ / "a.obj",
                           "--b",
                           folder_ / "b.obj",
                           "--random",
                           std::to_string(count),
                           "--out",
                           folder_ / out,
                           "--master",
                           master_->address()});
    };
    ASSERT_EQ(run_count(30, "old").exit_code, 0);
    ASSERT_EQ(run_count(40, "new").exit_code, 0);
    const auto diff_with = [&](const std::string& later) {
        return tests::run({cdctl(),
                           "diff",
                           folder_ / "old",
                           later,
                           "-o",
                           "json",
                           "--master",
                           master_->address()});
    };
    const Ran of_folder = diff_with(folder_ / "new");
    const Ran of_job = diff_with("last");
    EXPECT_EQ(of_job.exit_code, 0) << of_job.errors;
    EXPECT_EQ(of_job.output, of_folder.output);
    const auto json = nlohmann::json::parse(of_job.output);
    EXPECT_EQ(json["both"], 30);
    EXPECT_EQ(json["only_new"], 10);
    EXPECT_EQ(json["changed"], 0);
}

} // namespace

} // namespace cd::tests
