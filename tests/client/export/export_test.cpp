// Proves that every format stores exactly the results, and that files appear whole or not at all.
#include "client/export/result_sink.hpp"
#include "client/export/result_writer.hpp"
#include "client/formats/npz.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Export : public testing::Test {
  protected:
    Export() {
        const Mesh box = make_box({1, 1, 1});
        MeshArrays arrays{box.vertices(),
                          box.triangles(),
                          {{"left, \"old\"", 0, 6}, {"right", 6, 12}},
                          box.precision()};
        context_.bodies = {{"a", "a.obj", share(Mesh::create(std::move(arrays)).value())},
                           {"b", "b.obj", share(make_box({1, 1, 1}))}};
        context_.job = "test";
        context_.unit = "m";
    }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        return read_text(dir_ / name);
    }

    void write(const std::vector<std::string>& formats, Level level) {
        context_.level = level;
        auto files = ResultSink::open({dir_, formats}, context_);
        ASSERT_TRUE(files) << files.error().detail;
        RunReport report;
        report.summary.total = 3;
        report.execution.statistics.search.box_tests = 5;
        report.execution.statistics.search.triangle_tests = 6;
        report.execution.statistics.search.decisions[PairStage::Lattice] = 6;
        report.execution.statistics.search.effort = {9, 5, 12, 3};
        report.execution.statistics.inside = {7, 0.5, {}};
        report.execution.cost = cost_;
        for (ScenarioResult result : results()) {
            result.level = level;
            ASSERT_TRUE(files.value().add(result));
        }
        ASSERT_TRUE(files.value().finish(std::nullopt));
        ASSERT_TRUE(write_summary(dir_, context_, report));
    }

    /// Returns a separate one; one with two pairs, of which one has points, and a third that was
    /// cut; a failed one; an undecided one.
    static std::vector<ScenarioResult> results() {
        ScenarioResult separate;
        separate.insides_skipped = true;
        ScenarioResult contact;
        contact.surfaces_only = true;
        contact.index = 1;
        contact.kind = ScenarioClass::Cross;
        contact.pair_count = 3;
        contact.pairs = {{0, 5, PairClass::Proper}, {7, 2, PairClass::Coplanar}};
        contact.point_origins = {{10, 0, 0}, {20, 0, 0}};
        contact.point_offsets = {0, 2, 2};
        contact.points = {{0.5, 1, 0}, {0.25, 0, -3}};
        ScenarioResult failed;
        failed.index = 2;
        failed.kind = ScenarioClass::Failed;
        failed.failure = "too, large";
        ScenarioResult undecided;
        undecided.index = 3;
        undecided.kind = ScenarioClass::Undecided;
        undecided.distance_bound = 0.125;
        undecided.point_offsets = {0};
        return {separate, contact, failed, undecided};
    }

    const TemporaryFolder folder_;
    fs::path dir_ = folder_.path();
    ExportContext context_;
    std::optional<SearchCost> cost_;
};

} // namespace

TEST_F(Export, CsvHasARowForEachScenarioAndCsvPairsForEachPairAndPoint) {
    write({"csv", "csv-pairs"}, Level::Contacts);
    EXPECT_EQ(text_of("scenarios.csv"),
              "scenario,body_a,body_b,class,count,cut,distance_bound,surfaces_only,"
              "insides_skipped,failure\n"
              "0,a,b,separate,0,0,,0,1,\n"
              "1,a,b,cross,3,1,,1,0,\n"
              "2,a,b,failed,0,0,,0,0,\"too, large\"\n"
              "3,a,b,undecided,0,0,0.125,0,0,\n");
    EXPECT_EQ(text_of("pairs.csv"),
              "scenario,triangle_a,triangle_b,class,part_a,part_b\n"
              "1,0,5,proper,\"left, \"\"old\"\"\",\n"
              "1,7,2,coplanar,right,\n");
    EXPECT_EQ(text_of("points.csv"),
              "scenario,triangle_a,triangle_b,x,y,z\n"
              "1,0,5,10.5,1,0\n"
              "1,0,5,10.25,0,-3\n");
}

TEST_F(Export, CsvAloneHasScenariosAndGroups) {
    write({"csv"}, Level::Contacts);
    EXPECT_TRUE(fs::exists(dir_ / "scenarios.csv"));
    EXPECT_EQ(text_of("groups.csv"),
              "body_a,part_a,body_b,part_b,class,scenarios,share,pairs,worst,worst_pairs,"
              "regions_a,regions_b,episodes,first,last,status,note\n"
              "a,\"left, \"\"old\"\"\",b,whole,cross,1,0.3333333333333333,1,1,1,1,1,1,1,1,,\n"
              "a,right,b,whole,touch,1,0.3333333333333333,1,1,1,1,1,1,1,1,,\n");
    EXPECT_FALSE(fs::exists(dir_ / "pairs.csv"));
    EXPECT_FALSE(fs::exists(dir_ / "points.csv"));
}

TEST_F(Export, LevelCountHasNoPairs) {
    write({"csv", "csv-pairs"}, Level::Count);
    EXPECT_TRUE(fs::exists(dir_ / "scenarios.csv"));
    EXPECT_FALSE(fs::exists(dir_ / "groups.csv"));
    EXPECT_FALSE(fs::exists(dir_ / "pairs.csv"));
    EXPECT_FALSE(fs::exists(dir_ / "points.csv"));
}

TEST_F(Export, GroupsOfListedPairsHaveNoShare) {
    context_.listed.limit_pairs = 2;
    context_.listed.maps = true;
    write({"csv"}, Level::Pairs);
    EXPECT_THAT(text_of("groups.csv"), HasSubstr("\na,right,b,whole,touch,1,,1,1,1,1,1,"));
}

TEST_F(Export, JsonHasAnObjectOnEachLine) {
    write({"json"}, Level::Contacts);
    std::istringstream lines(text_of("results.jsonl"));
    std::vector<nlohmann::json> parsed;
    for (std::string line; std::getline(lines, line);) {
        parsed.push_back(nlohmann::json::parse(line));
    }
    ASSERT_EQ(parsed.size(), 4u);
    EXPECT_EQ(parsed[0]["class"], "separate");
    EXPECT_EQ(parsed[0]["surfaces_only"], false);
    EXPECT_EQ(parsed[0]["insides_skipped"], true);
    EXPECT_EQ(parsed[1]["surfaces_only"], true);
    EXPECT_EQ(parsed[1]["insides_skipped"], false);
    EXPECT_EQ(parsed[1]["body_a"], "a");
    EXPECT_EQ(parsed[1]["count"], 3);
    EXPECT_EQ(parsed[1]["cut"], true);
    EXPECT_EQ(parsed[1]["pairs"], nlohmann::json::parse(R"([[0,5,"proper"],[7,2,"coplanar"]])"));
    EXPECT_EQ(parsed[1]["points"], nlohmann::json::parse("[[[10.5,1.0,0.0],[10.25,0.0,-3.0]],[]]"));
    EXPECT_EQ(parsed[2]["failure"], "too, large");
    EXPECT_EQ(parsed[3]["distance_bound"], 0.125);
    EXPECT_FALSE(parsed[1].contains("distance_bound"));
}

TEST_F(Export, TextNamesPartsAndPoints) {
    write({"text"}, Level::Contacts);
    EXPECT_EQ(text_of("results.txt"),
              "0  separate  0 pairs  containment not tested\n"
              "1  cross  3 pairs, the first 2  surfaces only\n"
              "    A 0 (left, \"old\" 0)  B 5  proper  10.5 1 0  10.25 0 -3\n"
              "    A 7 (right 1)  B 2  coplanar\n"
              "2  failed  too, large\n"
              "3  undecided  at least 0 pairs  at most 0.125 apart\n");
}

TEST_F(Export, NpzHoldsCompressedRows) {
    write({"npz"}, Level::Contacts);
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    const auto& arrays = read.value();
    const auto integers = [&](const char* name) { return arrays.at(name).to_integers().value(); };
    using Integers = std::vector<std::int64_t>;
    EXPECT_EQ(integers("index"), (Integers{0, 1, 2, 3}));
    EXPECT_EQ(integers("class"), (Integers{0, 2, 6, 5}));
    EXPECT_EQ(integers("count"), (Integers{0, 3, 0, 0}));
    EXPECT_EQ(arrays.at("distance_bound").to_doubles(), (std::vector<double>{0, 0, 0, 0.125}));
    EXPECT_EQ(integers("surfaces_only"), (Integers{0, 1, 0, 0}));
    EXPECT_EQ(integers("insides_skipped"), (Integers{1, 0, 0, 0}));
    EXPECT_EQ(integers("offsets"), (Integers{0, 0, 2, 2, 2}));
    EXPECT_EQ(integers("pairs"), (Integers{0, 5, 7, 2}));
    EXPECT_EQ(arrays.at("pairs").shape, (std::vector<std::uint64_t>{2, 2}));
    EXPECT_EQ(integers("pair_class"), (Integers{3, 2}));
    EXPECT_EQ(integers("point_offsets"), (Integers{0, 2, 2}));
    EXPECT_EQ(integers("body_a"), (Integers{0, 0, 0, 0}));
    EXPECT_EQ(integers("body_b"), (Integers{1, 1, 1, 1}));
    EXPECT_EQ(arrays.at("points_world").shape, (std::vector<std::uint64_t>{2, 3}));
    EXPECT_EQ(arrays.at("points_world").to_doubles(),
              (std::vector<double>{10.5, 1, 0, 10.25, 0, -3}));
    EXPECT_FALSE(arrays.contains("points")) << "what is written is in the world";
}

TEST_F(Export, NpzHoldsExactPointsWhereTheyAreAskedFor) {
    context_.exact_points = true;
    write({"npz"}, Level::Contacts);
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    const auto& arrays = read.value();
    EXPECT_EQ(arrays.at("points").shape, (std::vector<std::uint64_t>{2, 3}));
    EXPECT_EQ(arrays.at("points").to_doubles(), (std::vector<double>{0.5, 1, 0, 0.25, 0, -3}));
    EXPECT_EQ(arrays.at("point_origins").to_doubles(), (std::vector<double>{10, 0, 0, 20, 0, 0}));
    EXPECT_TRUE(arrays.contains("points_world"));
}

TEST_F(Export, AFullDiskIsNoticedAtOnce) {
    fs::create_directories(dir_);
    const FileSizeLimit limit(1u << 20);
    context_.level = Level::Pairs;
    auto writer = make_array_writer("npz", context_, dir_);
    ASSERT_TRUE(writer);
    ScenarioResult result = results()[1];
    Status added = Done{};
    for (int i = 0; i < 200'000 && added; ++i) {
        added = writer->add(result);
    }
    ASSERT_FALSE(added) << "long before the end";
    EXPECT_THAT(added.error().detail, HasSubstr("results.npz"));
}

TEST_F(Export, NpzOfLevelCountHasNoLists) {
    write({"npz"}, Level::Count);
    const auto read = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_TRUE(read.value().contains("count"));
    EXPECT_FALSE(read.value().contains("pairs"));
    EXPECT_FALSE(read.value().contains("points"));
}

TEST_F(Export, TheSummaryHasBodiesCoverageAndStatistics) {
    write({"csv"}, Level::Pairs);
    const auto summary = nlohmann::json::parse(text_of("summary.json"));
    EXPECT_EQ(summary["job"], "test");
    EXPECT_EQ(summary["bodies"][0]["triangles"], 12);
    EXPECT_EQ(summary["bodies"][0]["sha256"], to_hex(context_.bodies[0].mesh->hash()));
    EXPECT_EQ(summary["bodies"][1]["name"], "b");
    EXPECT_EQ(summary["not_tested"], 3);
    EXPECT_TRUE(summary["digest"].is_null());
    EXPECT_EQ(summary["statistics"],
              nlohmann::json::parse(R"({"box_tests": 5, "candidates": 6, "box_test_ns": null,
                  "candidate_ns": null, "cost_seconds": null, "settled": {"float": 0,
                  "double": 0, "lattice": 6, "double-double": 0, "wide integer": 0,
                  "arbitrary": 0}, "cells": 9, "leaves": 5, "roots_named": 12, "roots_used": 3,
                  "inside_scenarios": 7, "inside_seconds": 0.5})"));
}

TEST_F(Export, TheSummaryGivesThePapersCost) {
    cost_ = SearchCost{2e8, 5e8};
    write({"csv"}, Level::Pairs);
    const auto statistics = nlohmann::json::parse(text_of("summary.json"))["statistics"];
    EXPECT_EQ(statistics["box_test_ns"], 2e8);
    EXPECT_EQ(statistics["candidate_ns"], 5e8);
    EXPECT_EQ(statistics["cost_seconds"], 5 * 0.2 + 6 * 0.5);
}

TEST_F(Export, AResultOfABodyThatTheJobDoesNotHaveIsRefused) {
    auto sink = ResultSink::open({dir_, {"csv", "csv-pairs", "text", "json"}, "text"}, context_);
    ASSERT_TRUE(sink) << sink.error().detail;
    ScenarioResult result = results()[1];
    EXPECT_TRUE(sink.value().add(result));
    result.body_b = 7;
    const Status refused = sink.value().add(result);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().detail, "the result of scenario 1 is of body 7, and the job has 2");
}

TEST_F(Export, NothingStaysOfARunThatDidNotFinish) {
    {
        auto files =
            ResultSink::open({dir_, {"csv", "csv-pairs", "json", "text", "npz"}}, context_);
        ASSERT_TRUE(files) << files.error().detail;
        ASSERT_TRUE(files.value().add(results()[1]));
        EXPECT_FALSE(fs::is_empty(dir_));
    }
    EXPECT_TRUE(fs::is_empty(dir_));
}

TEST_F(Export, NamesThatAreNoUtf8AreShownWithTheReplacementCharacter) {
    MeshArrays arrays;
    arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    arrays.triangles.assign(8, Triangle{0, 1, 2});
    arrays.parts = {{"Caf\xe9", 0, 8}};
    context_.bodies[0].mesh = share(Mesh::create(std::move(arrays)).value());
    write({"csv", "csv-pairs", "json", "text"}, Level::Pairs);
    for (const char* name : {"pairs.csv", "results.txt"}) {
        EXPECT_THAT(text_of(name), HasSubstr("Caf\xEF\xBF\xBD")) << name;
        EXPECT_THAT(text_of(name), Not(HasSubstr("\xe9"))) << name;
    }
}

TEST_F(Export, ARunThatDidNotFinishLeavesEarlierResultsAlone) {
    write({"csv-pairs"}, Level::Pairs);
    const std::string before = text_of("pairs.csv");
    {
        auto files = ResultSink::open({dir_, {"csv-pairs"}}, context_);
        ASSERT_TRUE(files);
    }
    EXPECT_EQ(text_of("pairs.csv"), before);
}

TEST_F(Export, AFolderThatCannotBeMadeIsNamed) {
    const auto files = ResultSink::open({"/proc/no/such", {"csv"}}, context_);
    ASSERT_FALSE(files);
    EXPECT_EQ(files.error().code, ErrorCode::Io);
    EXPECT_THAT(files.error().detail, HasSubstr("/proc/no/such"));
}

} // namespace cd::tests
