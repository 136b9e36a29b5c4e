// Proves that every format stores distances and nearest points, and only if the job asks for them.
#include "client/export/contact_scene.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_exports.hpp"
#include "common/job/result/drawn_witness.hpp"
#include "tests/support/distance_results.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;
using Shape = std::vector<std::uint64_t>;

class DistanceExport : public testing::Test {
  protected:
    DistanceExport() {
        const auto box = share(make_box({1, 1, 1}));
        context_.bodies = {{"a", "a.obj", box}, {"b", "b.obj", box}};
        context_.unit = "m";
        Query query;
        query.level = Level::Any;
        query.question = Question::Distance;
        query.up_to = 2.5;
        context_.describe(query);
    }

    /// Writes the results in these formats and returns what they tell.
    RunFindings write(const std::vector<std::string>& formats) {
        auto files = ResultSink::open({dir_, formats}, context_);
        EXPECT_TRUE(files) << files.error().detail;
        for (const ScenarioResult& result : distance_results()) {
            EXPECT_TRUE(files.value().add(result));
        }
        EXPECT_TRUE(files.value().finish(std::nullopt));
        return files.value().findings();
    }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        return read_text(dir_ / name);
    }

    const TemporaryFolder folder_;
    fs::path dir_ = folder_.path();
    ExportContext context_;
};

} // namespace

TEST_F(DistanceExport, TheResultsAreThoseOfRecords) {
    for (const ScenarioResult& result : distance_results()) {
        const auto decoded = decode_result(encode_result(result));
        ASSERT_TRUE(decoded) << decoded.error().detail;
    }
}

TEST_F(DistanceExport, CsvHasTheDistanceAndThePointsInTheWorld) {
    write({"csv"});
    EXPECT_EQ(text_of("scenarios.csv"),
              "scenario,body_a,body_b,class,count,distance,triangle_a,triangle_b,ax,ay,az,bx,by,bz,"
              "cut,distance_bound,surfaces_only,insides_skipped,failure\n"
              "0,a,b,separate,,0.25,3,7,10.5,0,0,10.75,0,0,0,,0,0,\n"
              "1,a,b,contact,,,,,,,,,,,0,,0,0,\n"
              "2,a,b,separate,,,,,,,,,,,0,,0,0,\n"
              "3,a,b,inside,,0.125,0,5,0,0,1,0,0,1.125,0,,0,0,\n");
}

TEST_F(DistanceExport, TextSaysHowFarTheBodiesAreApart) {
    write({"text"});
    EXPECT_EQ(text_of("results.txt"),
              "0  separate  0.25 apart  A 3  B 7  10.5 0 0  10.75 0 0\n"
              "1  contact\n"
              "2  separate  farther than 2.5 apart\n"
              "3  inside  0.125 apart  A 0  B 5  0 0 1  0 0 1.125\n");
}

TEST_F(DistanceExport, JsonHasNullWithoutADistance) {
    write({"json"});
    std::istringstream lines(text_of("results.jsonl"));
    std::vector<nlohmann::json> parsed;
    for (std::string line; std::getline(lines, line);) {
        parsed.push_back(nlohmann::json::parse(line));
    }
    ASSERT_EQ(parsed.size(), 4u);
    EXPECT_EQ(parsed[0]["distance"], 0.25);
    EXPECT_EQ(parsed[0]["witness"], nlohmann::json::parse("[3,7]"));
    EXPECT_EQ(parsed[0]["feature"], 27);
    EXPECT_EQ(parsed[0]["witness_points"], nlohmann::json::parse("[[10.5,0,0],[10.75,0,0]]"));
    for (const std::size_t none : {1u, 2u}) {
        EXPECT_TRUE(parsed[none]["distance"].is_null());
        EXPECT_FALSE(parsed[none].contains("witness"));
    }
}

TEST_F(DistanceExport, NpzHasNanWithoutADistance) {
    write({"npz"});
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    const auto& arrays = read.value();
    const auto distances = arrays.at("distance").to_doubles();
    EXPECT_EQ(distances[0], 0.25);
    EXPECT_TRUE(std::isnan(distances[1]) && std::isnan(distances[2]));
    EXPECT_EQ(distances[3], 0.125);
    EXPECT_EQ(arrays.at("witness").shape, (Shape{4, 2}));
    EXPECT_EQ(arrays.at("witness").type, NpyType::U4);
    EXPECT_THAT(arrays.at("witness").to_integers().value(), ElementsAre(3, 7, 0, 0, 0, 0, 0, 5));
    EXPECT_THAT(arrays.at("feature").to_integers().value(), ElementsAre(27, 0, 0, 0));
    EXPECT_EQ(arrays.at("witness_points").shape, (Shape{4, 2, 3}));
    const auto points = arrays.at("witness_points").to_doubles();
    EXPECT_EQ(points[0], 10.5);
    EXPECT_EQ(points[3], 10.75);
    EXPECT_TRUE(std::isnan(points[6]));
    EXPECT_EQ(points[23], 1.125);
    EXPECT_FALSE(arrays.contains("witness_origin"));
}

TEST_F(DistanceExport, NpzHasExactPointsIfAskedFor) {
    context_.exact_points = true;
    write({"npz"});
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().at("witness_origin").shape, (Shape{4, 3}));
    EXPECT_EQ(read.value().at("witness_offsets").shape, (Shape{4, 2, 3}));
    EXPECT_EQ(read.value().at("witness_origin").to_doubles()[0], 10);
    EXPECT_EQ(read.value().at("witness_offsets").to_doubles()[3], 0.75);
}

TEST_F(DistanceExport, OtherJobsHaveNothingOfIt) {
    context_.describe(Query{});
    context_.level = Level::Any;
    write({"csv", "json", "npz"});
    EXPECT_THAT(text_of("scenarios.csv"), Not(HasSubstr("distance,")));
    EXPECT_THAT(text_of("results.jsonl"), Not(HasSubstr("\"distance\"")));
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    for (const char* name : {"distance", "witness", "feature", "witness_points"}) {
        EXPECT_FALSE(read.value().contains(name)) << name;
    }
    ASSERT_TRUE(write_summary(dir_, context_, {}));
    EXPECT_THAT(text_of("summary.json"), Not(HasSubstr("least_distance")));
}

TEST_F(DistanceExport, TheSummaryNamesTheScenarioOfLeastDistance) {
    RunReport report;
    report.findings = write({});
    ASSERT_TRUE(write_summary(dir_, context_, report));
    const auto summary = nlohmann::json::parse(text_of("summary.json"));
    EXPECT_EQ(summary["question"], "distance");
    EXPECT_EQ(summary["up_to"], 2.5);
    EXPECT_EQ(summary["least_distance"], 0.125);
    EXPECT_EQ(summary["least_scenario"], 3);
    const auto read = read_summary(dir_ / "summary.json");
    ASSERT_TRUE(read) << read.error().detail;
    ASSERT_TRUE(read.value().findings.least);
    EXPECT_EQ(read.value().findings.least->distance, 0.125);
    EXPECT_EQ(read.value().findings.least->scenario, 3u);
    EXPECT_EQ(read.value().findings.least->unit, "m");
}

TEST_F(DistanceExport, OfEqualDistancesTheFirstScenarioIsTheLeast) {
    auto sink = ResultSink::open({}, context_);
    ASSERT_TRUE(sink);
    ScenarioResult result = distance_results()[0];
    for (const std::uint64_t index : {4, 5}) {
        result.index = index;
        ASSERT_TRUE(sink.value().add(result));
    }
    EXPECT_EQ(sink.value().findings().least->scenario, 4u);
}

TEST_F(DistanceExport, ASceneHasTheLineBetweenTheNearestPoints) {
    const auto box = context_.bodies[0].mesh;
    ScenarioResult result = distance_results()[0];
    list_witness(result);
    const ContactScene scene = make_contact_scene(
        {SceneBody{"a", box, {}, {}}, SceneBody{"b", box, {}, {}}}, Scenario(), result);
    ASSERT_EQ(scene.gaps.size(), 2u);
    EXPECT_EQ(scene.gaps[0].point, Vec3(10.5, 0, 0));
    EXPECT_EQ(scene.gaps[1].point, Vec3(10.75, 0, 0));
    EXPECT_EQ(scene.bodies[1].contacts[0].triangle, 7u);
    EXPECT_EQ(scene.bodies[1].contacts[0].kind, PairClass::Near);
}

} // namespace cd::tests
