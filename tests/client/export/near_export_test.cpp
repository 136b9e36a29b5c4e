// Proves that every format stores near pairs with their distances, and only with a clearance.
#include "client/export/contact_scene.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_exports.hpp"
#include "tests/support/near_results.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vtp_arrays.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class NearExport : public testing::Test {
  protected:
    NearExport() {
        const auto box = share(make_box({1, 1, 1}));
        context_.bodies = {{"a", "a.obj", box}, {"b", "b.obj", box}};
        context_.clearance = 0.25;
    }

    void write(const std::vector<std::string>& formats, Level level, bool has_map = false) {
        context_.level = level;
        auto files = ResultSink::open({dir_, formats}, context_);
        ASSERT_TRUE(files) << files.error().detail;
        for (const ScenarioResult& result : near_results(level)) {
            ASSERT_TRUE(files.value().add(result));
        }
        ASSERT_TRUE(files.value().finish(has_map ? files.value().map() : std::nullopt));
    }
    void write_map(const std::vector<std::string>& formats, Level level) {
        write(formats, level, true);
    }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        return read_text(dir_ / name);
    }

    const TemporaryFolder folder_;
    fs::path dir_ = folder_.path();
    ExportContext context_;
};

} // namespace

TEST_F(NearExport, TheResultsAreThoseOfRecords) {
    for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
        for (const ScenarioResult& result : near_results(level)) {
            const auto decoded = decode_result(encode_result(result));
            ASSERT_TRUE(decoded) << decoded.error().detail;
        }
    }
}

TEST_F(NearExport, CsvCountsAndListsNearPairs) {
    write({"csv", "csv-pairs"}, Level::Contacts);
    EXPECT_EQ(text_of("scenarios.csv"),
              "scenario,body_a,body_b,class,count,near_count,cut,distance_bound,surfaces_only,"
              "insides_skipped,failure\n"
              "0,a,b,separate,0,0,0,,0,0,\n"
              "1,a,b,near,0,2,0,,0,0,\n"
              "2,a,b,touch,1,3,1,,0,0,\n");
    EXPECT_THAT(text_of("groups.csv"),
                HasSubstr(",scenarios,share,pairs,near,worst,worst_pairs,worst_near,regions_a,"));
    EXPECT_THAT(text_of("groups.csv"), HasSubstr("whole,touch,2,0.6666666666666666,1,3,2,1,1,"));
    EXPECT_EQ(text_of("pairs.csv"),
              "scenario,triangle_a,triangle_b,class,part_a,part_b\n"
              "1,0,5,near,,\n"
              "1,7,2,near,,\n"
              "2,0,4,touch,,\n"
              "2,0,5,near,,\n");
    EXPECT_EQ(text_of("points.csv"),
              "scenario,triangle_a,triangle_b,x,y,z\n"
              "1,0,5,10,0,0\n"
              "1,0,5,10,0,0.125\n"
              "1,7,2,20,0,0\n"
              "1,7,2,20.25,0,0\n"
              "2,0,4,1,2,3\n"
              "2,0,5,0,0,0\n"
              "2,0,5,0,0.0625,0\n");
}

TEST_F(NearExport, LevelAnyCountsNothing) {
    write({"csv"}, Level::Any);
    EXPECT_THAT(text_of("scenarios.csv"), HasSubstr("\n1,a,b,near,,,0,,0,0,\n"));
}

TEST_F(NearExport, TextSaysHowFarPairsAreApart) {
    write({"text"}, Level::Contacts);
    EXPECT_EQ(text_of("results.txt"),
              "0  separate  0 pairs, 0 near\n"
              "1  near  0 pairs, 2 near\n"
              "    A 0  B 5  near  0.125 apart  10 0 0  10 0 0.125\n"
              "    A 7  B 2  near  0.25 apart  20 0 0  20.25 0 0\n"
              "2  touch  1 pair, 3 near, the first 2\n"
              "    A 0  B 4  touch  1 2 3\n"
              "    A 0  B 5  near  0.0625 apart  0 0 0  0 0.0625 0\n");
}

TEST_F(NearExport, JsonHasADistanceForEachPair) {
    write({"json"}, Level::Contacts);
    std::istringstream lines(text_of("results.jsonl"));
    std::vector<nlohmann::json> parsed;
    for (std::string line; std::getline(lines, line);) {
        parsed.push_back(nlohmann::json::parse(line));
    }
    ASSERT_EQ(parsed.size(), 3u);
    EXPECT_EQ(parsed[1]["class"], "near");
    EXPECT_EQ(parsed[2]["count"], 1);
    EXPECT_EQ(parsed[2]["near_count"], 3);
    EXPECT_EQ(parsed[2]["pairs"], nlohmann::json::parse(R"([[0,4,"touch"],[0,5,"near"]])"));
    EXPECT_EQ(parsed[2]["distances"], nlohmann::json::parse("[0.0,0.0625]"));
}

TEST_F(NearExport, NpzHasCountsClassesAndDistances) {
    write({"npz"}, Level::Contacts);
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    const auto& arrays = read.value();
    EXPECT_THAT(arrays.at("class").to_integers().value(), ElementsAre(0, 7, 1));
    EXPECT_THAT(arrays.at("near_count").to_integers().value(), ElementsAre(0, 2, 3));
    EXPECT_EQ(arrays.at("near_count").type, NpyType::U8);
    EXPECT_THAT(arrays.at("pair_class").to_integers().value(), ElementsAre(4, 4, 1, 4));
    EXPECT_THAT(arrays.at("pair_distance").to_doubles(), ElementsAre(0.125, 0.25, 0, 0.0625));
    EXPECT_EQ(arrays.at("points_world").shape, (std::vector<std::uint64_t>{7, 3}));
    EXPECT_FALSE(arrays.contains("points"));
}

TEST_F(NearExport, NpzHasExactPointsBesideDistances) {
    context_.exact_points = true;
    write({"npz"}, Level::Contacts);
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_THAT(read.value().at("pair_distance").to_doubles(), ElementsAre(0.125, 0.25, 0, 0.0625));
    EXPECT_EQ(read.value().at("points").shape, (std::vector<std::uint64_t>{7, 3}));
}

TEST_F(NearExport, NpzOfLowerLevelsHasCountsButNoDistances) {
    for (const Level level : {Level::Count, Level::Pairs}) {
        write({"npz"}, level);
        const auto read = read_npz(dir_ / "results.npz");
        ASSERT_TRUE(read) << read.error().detail;
        EXPECT_THAT(read.value().at("near_count").to_integers().value(), ElementsAre(0, 2, 3));
        EXPECT_FALSE(read.value().contains("pair_distance"));
        EXPECT_EQ(read.value().contains("pair_class"), level == Level::Pairs);
    }
}

TEST_F(NearExport, VtpHasALineForEachNearPair) {
    write({"vtp"}, Level::Contacts);
    const VtpArrays contacts = read_vtp(dir_ / "contacts.vtp");
    EXPECT_THAT(contacts.arrays.at("class").as<std::uint8_t>(), ElementsAre(4, 4, 4, 4, 1, 4, 4));
    EXPECT_THAT(contacts.arrays.at("Lines.connectivity").as<std::int64_t>(),
                ElementsAre(0, 1, 2, 3, 5, 6));
    EXPECT_THAT(contacts.arrays.at("Lines.offsets").as<std::int64_t>(), ElementsAre(2, 4, 6));
}

TEST_F(NearExport, MapsTellContactsFromNearTriangles) {
    write_map({"csv", "npz", "vtp"}, Level::Pairs);
    EXPECT_EQ(text_of("map.csv"),
              "body,triangle,scenarios,in_contact,part\n"
              "a,0,2,1,\n"
              "a,7,1,0,\n"
              "b,2,1,0,\n"
              "b,4,1,1,\n"
              "b,5,2,0,\n");
    const auto read = read_npz(dir_ / "map.npz");
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().at("b").shape, (std::vector<std::uint64_t>{3, 3}));
    EXPECT_THAT(read.value().at("b").to_integers().value(), ElementsAre(2, 1, 0, 4, 1, 1, 5, 2, 0));
    EXPECT_THAT(read_vtp(dir_ / "a.vtp").arrays.at("in_contact").as<std::int64_t>(),
                ElementsAre(1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
}

TEST_F(NearExport, MapsOfListedPairsTellThoseInContact) {
    context_.listed.limit_pairs = 2;
    write_map({"csv"}, Level::Pairs);
    EXPECT_THAT(text_of("map.csv"),
                HasSubstr("body,triangle,scenarios_of_first_2_pairs,in_contact,part\na,0,2,1,\n"));
}

TEST_F(NearExport, MapsThatCountMoreThanListsTellNoContacts) {
    context_.listed = {.limit_pairs = 2, .maps = true};
    write_map({"csv"}, Level::Pairs);
    EXPECT_THAT(text_of("map.csv"), HasSubstr("body,triangle,scenarios,part\na,0,2,\n"));
    context_.listed = {.maps = true};
    write_map({"csv"}, Level::Count);
    EXPECT_EQ(text_of("map.csv"), "body,triangle,scenarios,part\n");
}

TEST_F(NearExport, WithoutAClearanceFilesHaveNothingOfIt) {
    context_.clearance.reset();
    write({"csv", "json", "npz", "vtp"}, Level::Contacts);
    EXPECT_THAT(text_of("scenarios.csv"), Not(HasSubstr("near_count")));
    EXPECT_THAT(text_of("results.jsonl"), Not(HasSubstr("near_count")));
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_FALSE(read.value().contains("near_count"));
    EXPECT_FALSE(read.value().contains("pair_distance"));
    EXPECT_THAT(read_vtp(dir_ / "contacts.vtp").xml, HasSubstr("NumberOfLines=\"0\""));
    write_map({"csv", "vtp"}, Level::Pairs);
    EXPECT_THAT(text_of("map.csv"), HasSubstr("body,triangle,scenarios,part\n"));
    EXPECT_FALSE(read_vtp(dir_ / "a.vtp").arrays.contains("in_contact"));
}

TEST_F(NearExport, TheSummaryHasTheClearanceAndTheNearScenarios) {
    RunReport report;
    report.summary.total = 3;
    report.summary.near = 2;
    report.summary.near_pairs = 40;
    ASSERT_TRUE(write_summary(dir_, context_, report));
    const auto summary = nlohmann::json::parse(text_of("summary.json"));
    EXPECT_EQ(summary["clearance"], 0.25);
    EXPECT_EQ(summary["near"], 2);
    EXPECT_EQ(summary["near_pairs"], 40);
    const auto read = read_summary(dir_ / "summary.json");
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().query.clearance, 0.25);
    EXPECT_EQ(read.value().summary.near, 2u);
    EXPECT_EQ(read.value().summary.near_pairs, 40u);
    context_.clearance.reset();
    ASSERT_TRUE(write_summary(dir_, context_, report));
    for (const char* key : {"clearance", "near", "near_pairs"}) {
        EXPECT_FALSE(nlohmann::json::parse(text_of("summary.json")).contains(key)) << key;
    }
}

TEST_F(NearExport, ASceneHasTheLinesBetweenNearestPoints) {
    const auto box = context_.bodies[0].mesh;
    const std::vector<ScenarioResult> results = near_results(Level::Contacts);
    const auto scene_of = [&](const ScenarioResult& result) {
        return make_contact_scene(
            {SceneBody{"a", box, {}, {}}, SceneBody{"b", box, {}, {}}}, Scenario(), result);
    };
    const ContactScene scene = scene_of(results[2]);
    ASSERT_EQ(scene.gaps.size(), 2u);
    EXPECT_EQ(scene.gaps[1].point, Vec3(0, 0.0625, 0));
    EXPECT_TRUE(scene.segments.empty()) << "nothing shared is a segment";
    ASSERT_EQ(scene.bodies[0].contacts.size(), 1u);
    EXPECT_EQ(scene.bodies[0].contacts[0].kind, PairClass::Touch) << "worse than near";

    ASSERT_TRUE(write_scene_contacts(scene, dir_ / "contacts.vtp", {}));
    const VtpArrays file = read_vtp(dir_ / "contacts.vtp");
    EXPECT_THAT(file.arrays.at("class").as<std::uint8_t>(), ElementsAre(1, 4, 1, 1, 4))
        << "a dot, a line, triangle 0 of A, triangles 4 and 5 of B";
    EXPECT_THAT(file.arrays.at("Lines.connectivity").as<std::int32_t>(), ElementsAre(1, 2));
    const auto colours = file.arrays.at("colour").as<std::uint8_t>();
    EXPECT_EQ((std::vector<std::uint8_t>(colours.begin() + 3, colours.begin() + 6)),
              (std::vector<std::uint8_t>{near_colour.red, near_colour.green, near_colour.blue}));
}

} // namespace cd::tests
