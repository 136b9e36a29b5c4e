// Proves, with real processes, how `results` exports a folder: formats and their summary, without
// writing anything if nothing is to be added; and its message for a folder of an earlier version.
#include "tests/cluster/folder/folder_fixture.hpp"
#include "tests/support/npz_arrays.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Results : public FolderTest {
  protected:
    [[nodiscard]] Ran results(std::vector<std::string> more) {
        return tests::run(command("results", folder_ / "out", std::move(more)));
    }
};

TEST_F(Results, PrintingNeedsNoRightToWrite) {
    write_job(5, "level = \"count\"");
    ASSERT_EQ(run({"--out", folder_ / "out", "--formats", "csv"}).exit_code, 0);
    write_text(folder_ / "out" / ".part", "where who writes makes a folder");
    const Ran printed = results({"-o", "csv"});
    EXPECT_EQ(printed.exit_code, 0) << printed.errors;
    EXPECT_EQ(printed.output, read_text(folder_ / "out" / "scenarios.csv"));
    EXPECT_THAT(printed.errors, HasSubstr("tested 25 of 25"));
    EXPECT_EQ(results({"-o", "csv", "-q"}).errors, "");
    EXPECT_THAT(results({}).output, HasSubstr("\n24  separate"));
}

TEST_F(Results, AddedFormatsEndWithTheSummaryOfTheRun) {
    write_job(5, "level = \"pairs\"");
    const Ran ran = run({"--out", folder_ / "out", "--formats", "csv"});
    ASSERT_EQ(ran.exit_code, 0);
    const Ran added = results({"--formats", "npz"});
    EXPECT_EQ(added.exit_code, 0);
    EXPECT_EQ(digest_of(added), digest_of(ran));
    const auto classes = [](const std::string& text) {
        return text.substr(text.find("  separate"));
    };
    EXPECT_EQ(classes(added.output), classes(ran.output));
    EXPECT_FALSE(fs::exists(folder_ / "out" / ".part"));
}

TEST_F(Results, MissingResultsAreTold) {
    write_job(5, "level = \"count\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    auto manifest = read_json(folder_ / "out" / "run.json");
    manifest["poses"]["count"] = 30;
    manifest["poses"]["grid"]["position"][2]["count"] = 30;
    manifest["poses"]["grid"]["position"][0]["count"] = 1;
    manifest["poses"]["grid"]["rotation_wxyz"][2] = {{1, 0, 0, 0}};
    manifest["digest"] = nullptr;
    write_text(folder_ / "out" / "run.json", manifest.dump());
    const Ran added = results({"--formats", "csv"});
    EXPECT_EQ(added.exit_code, 3) << added.errors;
    EXPECT_THAT(added.errors, HasSubstr("incomplete: 25 of 30 scenarios have a result"));
    EXPECT_THAT(added.output, HasSubstr("tested 25 of 30"));
}

TEST_F(Results, AFolderOfAnEarlierVersionTellsItsSummary) {
    write_job(5, "level = \"pairs\"");
    const Ran ran = run({"--out", folder_ / "new"});
    fs::create_directories(folder_ / "out");
    fs::copy_file(folder_ / "new" / "summary.json", folder_ / "out" / "summary.json");
    const Ran told = results({});
    EXPECT_EQ(told.exit_code, 0) << told.errors;
    EXPECT_EQ(digest_of(told), digest_of(ran));
    EXPECT_THAT(told.output, HasSubstr("tested 25 of 25"));
    EXPECT_EQ(results({"-o", "json"}).output, read_text(folder_ / "out" / "summary.json"));
    for (const Ran& refused : {results({"-o", "csv"}),
                               results({"--formats", "csv"}),
                               tests::run({cdctl(), "run", folder_ / "out"}),
                               tests::run({cdctl(), "verify", folder_ / "out"}),
                               tests::run({cdctl(), "extract", folder_ / "out", "0"})}) {
        EXPECT_EQ(refused.exit_code, 2);
        EXPECT_THAT(refused.errors, HasSubstr("only its summary.json can be opened"));
    }
    write_text(folder_ / "out" / "summary.json", "{\"total\": \"many\"}");
    const Ran damaged = results({});
    EXPECT_EQ(damaged.exit_code, 2);
    EXPECT_THAT(damaged.errors, HasSubstr("summary.json is damaged, or no summary of cdctl"));
}

TEST_F(Results, AFolderNamedLikeAJobIsAFolder) {
    write_job(2, "level = \"count\"");
    for (const std::string name : {"last", "j-5692"}) {
        ASSERT_EQ(run({"--out", folder_ / name}).exit_code, 0);
        const std::string line =
            "cd " + folder_.path().string() + " && " + cdctl() + " results " + name + " -o csv";
        const Ran printed = tests::run({"/bin/sh", "-c", line});
        EXPECT_EQ(printed.exit_code, 0) << printed.errors;
        EXPECT_EQ(printed.output, read_text(folder_ / name / "scenarios.csv"));
    }
}

TEST_F(Results, NamesOfPartsAreInEveryFormat) {
    write_text(folder_ / "a.obj", "o ring\n" + read_text(folder_ / "a.obj"));
    write_text(folder_ / "b.obj", "g ball\n" + read_text(folder_ / "b.obj"));
    write_job(5, "level = \"pairs\"");
    ASSERT_EQ(run({"--out", folder_ / "out", "--formats", "json"}).exit_code, 0);
    fs::remove(folder_ / "a.obj");
    ASSERT_EQ(results({"--formats", "csv,csv-pairs,text"}).exit_code, 0);
    EXPECT_THAT(read_text(folder_ / "out" / "pairs.csv"), HasSubstr(",ring,ball\n"));
    EXPECT_THAT(read_text(folder_ / "out" / "results.txt"), HasSubstr(" (ball "));
    EXPECT_THAT(read_text(folder_ / "out" / "map.csv"), HasSubstr(",ring\n"));
}

TEST_F(Results, TheMapIsTheSumOfThePairs) {
    write_text(folder_ / "a.obj", "o ring\n" + read_text(folder_ / "a.obj"));
    write_job(6, "level = \"pairs\"");
    ASSERT_EQ(run({"--out", folder_ / "out", "--formats", "csv,json"}).exit_code, 0);
    ASSERT_EQ(results({"--formats", "npz"}).exit_code, 0);
    std::map<std::uint32_t, std::set<std::uint64_t>> touched; // Triangles of A.
    std::istringstream lines(read_text(folder_ / "out" / "results.jsonl"));
    for (std::string line; std::getline(lines, line);) {
        const auto json = nlohmann::json::parse(line);
        for (const auto& pair : json["pairs"]) {
            touched[pair[0].get<std::uint32_t>()].insert(json["index"].get<std::uint64_t>());
        }
    }
    ASSERT_FALSE(touched.empty());
    std::string rows;
    std::vector<std::int64_t> numbers;
    for (const auto& [triangle, scenarios] : touched) {
        rows +=
            "a," + std::to_string(triangle) + "," + std::to_string(scenarios.size()) + ",ring\n";
        numbers.push_back(triangle);
        numbers.push_back(static_cast<std::int64_t>(scenarios.size()));
    }
    EXPECT_THAT(read_text(folder_ / "out" / "map.csv"),
                testing::StartsWith("body,triangle,scenarios,part\n" + rows + "b,"));
    const auto arrays = read_npz(folder_ / "out" / "map.npz");
    ASSERT_TRUE(arrays);
    EXPECT_EQ(arrays.value().at("a").to_integers().value(), numbers);
}

TEST_F(Results, AMapOfListedPairsSaysSo) {
    write_job(6, "level = \"pairs\"\nlimit_pairs = 2");
    ASSERT_EQ(run({"--out", folder_ / "out", "--formats", "csv"}).exit_code, 0);
    ASSERT_EQ(results({"--formats", "npz"}).exit_code, 0);
    EXPECT_THAT(read_text(folder_ / "out" / "map.csv"),
                testing::StartsWith("body,triangle,scenarios_of_first_2_pairs,part\na,"));
    const auto arrays = read_npz(folder_ / "out" / "map.npz");
    ASSERT_TRUE(arrays);
    EXPECT_EQ(arrays.value().at("first_pairs").to_integers().value(), std::vector<std::int64_t>{2});
    write_job(6, "level = \"pairs\"\nlimit_pairs = 2\nmaps = true");
    ASSERT_EQ(run({"--out", folder_ / "all", "--formats", "csv"}).exit_code, 0);
    EXPECT_THAT(read_text(folder_ / "all" / "map.csv"),
                testing::StartsWith("body,triangle,scenarios,part\na,"));
}

TEST_F(Results, TheListOfFilesIsThatOfTheFolder) {
    write_job(5, "level = \"count\"\nmaps = true");
    ASSERT_EQ(run({"--out", folder_ / "out", "--formats", "csv"}).exit_code, 0);
    ASSERT_EQ(results({"--formats", "npz"}).exit_code, 0);
    std::map<std::string, std::uint64_t> listed;
    const auto manifest = read_json(folder_ / "out" / "run.json");
    for (const auto& file : manifest["files"]) {
        listed[file["name"]] = file["bytes"];
    }
    std::map<std::string, std::uint64_t> there;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) {
        if (entry.is_regular_file() && entry.path().filename() != "run.json") {
            there[entry.path().lexically_relative(folder_ / "out")] = entry.file_size();
        }
    }
    EXPECT_EQ(listed, there);
    EXPECT_TRUE(there.contains("maps"));
    EXPECT_TRUE(there.contains("map.npz"));
}

TEST_F(Results, OneMeshIsKeptForTwoEqualBodies) {
    write_text(folder_ / "b.obj", read_text(folder_ / "a.obj"));
    write_job(3, "level = \"count\"");
    ASSERT_EQ(run({"--out", folder_ / "out"}).exit_code, 0);
    const fs::directory_iterator meshes(folder_ / "out" / "inputs" / "meshes");
    EXPECT_EQ(std::distance(meshes, fs::directory_iterator()), 1);
    EXPECT_THAT(tests::run({cdctl(), "verify", folder_ / "out"}).output, HasSubstr("9 the same"));
}

} // namespace

} // namespace cd::tests
