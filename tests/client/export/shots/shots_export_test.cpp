// Proves that lines tell the thickness of closed parts alone, that files have every hit and every
// passage, and that sums by part are those of the lines.
#include "client/export/result_sink.hpp"
#include "client/export/shots/passages.hpp"
#include "tests/support/line_scene.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class ShotsExport : public testing::Test {
  protected:
    ShotsExport() {
        context_ = scene_.context();
        ask(shots_query(Level::Pairs));
    }

    void ask(const Query& query) {
        query_ = query;
        context_.describe(query);
    }

    [[nodiscard]] std::vector<ScenarioResult> results() const { return scene_.results(query_); }

    RunFindings write(const std::vector<std::string>& formats) {
        auto files = ResultSink::open({dir_, formats}, context_);
        EXPECT_TRUE(files) << files.error().detail;
        for (const ScenarioResult& result : results()) {
            EXPECT_TRUE(files.value().add(result));
        }
        map_ = files.value().map().value_or(ContactMap());
        EXPECT_TRUE(files.value().finish(std::nullopt));
        return files.value().findings();
    }

    [[nodiscard]] std::string text_of(const std::string& name) const {
        return read_text(dir_ / name);
    }

    const TemporaryFolder folder_;
    fs::path dir_ = folder_.path();
    LineScene scene_;
    ExportContext context_;
    Query query_;
    ContactMap map_;
};

} // namespace

TEST_F(ShotsExport, ALineIsThickOnlyInClosedParts) {
    const PassageFinder finder(*scene_.a);
    ASSERT_EQ(finder.parts().count(), 3u);
    EXPECT_TRUE(finder.is_closed(0) && finder.is_closed(1));
    EXPECT_FALSE(finder.is_closed(2));
    const std::vector<ScenarioResult> all = results();
    ASSERT_EQ(all.size(), 9u);
    EXPECT_TRUE(finder.passages(all[0]).empty());
    const std::vector<Passage> passages = finder.passages(all[4]);
    ASSERT_EQ(passages.size(), 3 * 16u);
    for (std::size_t i = 0; i < passages.size(); ++i) {
        EXPECT_EQ(passages[i].line, i / 3);
        EXPECT_EQ(passages[i].part, i % 3);
    }
    EXPECT_EQ(passages[0].in.depth, 0.25);
    EXPECT_EQ(passages[0].thickness(), 0.5);
    EXPECT_EQ(passages[1].in.depth, 1.75);
    EXPECT_EQ(passages[1].thickness(), 1.0);
    EXPECT_EQ(passages[2].in.depth, 3.75);
    EXPECT_EQ(passages[2].thickness(), std::nullopt);
}

TEST_F(ShotsExport, NoThicknessIsInventedWhereHitsAreMissing) {
    const PassageFinder finder(*scene_.a);
    query_.limit_pairs = 50;
    for (const Passage& passage : finder.passages(results()[4])) {
        EXPECT_EQ(passage.thickness(), std::nullopt) << "the list is cut";
    }
    query_.limit_pairs = 0;
    query_.first_hits = true;
    const std::vector<Passage> first = finder.passages(results()[4]);
    EXPECT_EQ(first.size(), 16u);
    for (const Passage& passage : first) {
        EXPECT_EQ(passage.in.depth, 0.25);
        EXPECT_EQ(passage.thickness(), std::nullopt);
    }
}

TEST_F(ShotsExport, ALineThatMayStartInsideAPartHasNoThicknessThere) {
    // A line of a file from inside the second box, and one from before both boxes.
    scene_.lines = share(line_mesh({{Vec3(0.5, 0.375, 0.25), Vec3(4, 0.375, 0.25)},
                                    {Vec3(-0.5, 0.375, 0.25), Vec3(4, 0.375, 0.25)}})
                             .value());
    const ObbTree a = make_tree(*scene_.a);
    const ObbTree b = make_tree(*scene_.lines);
    const ScenarioResult result = run_scenario(a, b, make_scenario({}), query_).result;
    const auto finder = make_finder(*scene_.a, scene_.lines, ShotViews());
    const std::vector<Passage> passages = finder->passages(result);
    ASSERT_EQ(passages.size(), 4u);
    EXPECT_EQ(passages[0].thickness(), std::nullopt) << "the second box, left at depth 0.5";
    EXPECT_EQ(passages[0].in.depth, 0.5);
    EXPECT_EQ(passages[1].thickness(), 0.5);
    EXPECT_EQ(passages[2].thickness(), 1.0);
    EXPECT_EQ(passages[3].thickness(), 0.5);
}

TEST_F(ShotsExport, ShotlinesHaveARowForEachPassage) {
    write({"csv", "csv-pairs"});
    const std::string text = text_of("shotlines.csv");
    EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 3 * 16);
    EXPECT_THAT(text, HasSubstr("\n4,0,0,0,first,0.25,0.75,0.5,0.5,1,1,"));
    EXPECT_THAT(text, HasSubstr("\n4,0,0,1,second,1.75,2.75,1,1,1,1,"));
    EXPECT_THAT(text, HasSubstr("\n4,0,15,2,plate,3.75,,,,1,,"));
    const std::size_t row = text.find("\n4,0,7,0,") + 1;
    EXPECT_EQ(text.substr(text.rfind(',', text.find('\n', row)), 3), ",1\n") << "the gap";
    EXPECT_FALSE(fs::exists(dir_ / "pairs.csv"));
    EXPECT_THAT(text_of("scenarios.csv"), HasSubstr("a,lines,contact,"));
    EXPECT_THAT(text_of("scenarios.csv"), HasSubstr("class,count,hits,cut"));
}

TEST_F(ShotsExport, ASlantedPartIsThinnerAlongItsNormal) {
    scene_.spec.elevation_deg = {45, 45, 1};
    context_.bodies[1].views = scene_.views();
    write({"csv-pairs"});
    // Each face of a box leans by 45 degrees, whether it is in front or on top.
    std::istringstream rows(text_of("shotlines.csv"));
    std::string row;
    std::getline(rows, row);
    std::size_t thick = 0;
    while (std::getline(rows, row)) {
        std::vector<std::string> fields;
        std::istringstream cells(row);
        for (std::string field; std::getline(cells, field, ',');) {
            fields.push_back(field);
        }
        ASSERT_GE(fields.size(), 10u);
        EXPECT_NEAR(std::stod(fields[9]), std::sqrt(0.5), 1e-12) << row;
        if (!fields[7].empty()) {
            ++thick;
            EXPECT_NEAR(std::stod(fields[8]), std::stod(fields[7]) * std::sqrt(0.5), 1e-12) << row;
        }
    }
    EXPECT_GT(thick, 0u);
}

TEST_F(ShotsExport, NpzHasEveryHit) {
    write({"npz"});
    const auto read = read_npz(dir_ / "shots.npz");
    ASSERT_TRUE(read) << read.error().detail;
    const auto& arrays = read.value();
    const ScenarioResult hit = results()[4];
    const auto offsets = arrays.at("offsets").to_integers().value();
    ASSERT_EQ(offsets.size(), 10u);
    EXPECT_EQ(offsets[4], 0);
    EXPECT_EQ(offsets[5], static_cast<std::int64_t>(hit.hits.size()));
    EXPECT_EQ(offsets[9], offsets[5]);
    EXPECT_EQ(arrays.at("hits").shape, (std::vector<std::uint64_t>{hit.hits.size(), 2}));
    EXPECT_EQ(arrays.at("depth").type, NpyType::F8);
    EXPECT_EQ(arrays.at("flags").type, NpyType::U1);
    for (std::size_t i = 0; i < hit.hits.size(); ++i) {
        EXPECT_EQ(arrays.at("hits").to_integers().value()[2 * i], hit.pairs[i].a);
        EXPECT_EQ(arrays.at("hits").to_integers().value()[2 * i + 1], hit.pairs[i].b);
        EXPECT_EQ(arrays.at("depth").to_doubles()[i], hit.hits[i].depth);
        EXPECT_EQ(arrays.at("flags").to_integers().value()[i], hit.hits[i].flags);
        EXPECT_EQ(arrays.at("rank").to_integers().value()[i], hit.hits[i].rank);
    }
    const auto others = read_npz(dir_ / "results.npz");
    ASSERT_TRUE(others) << others.error().detail;
    EXPECT_FALSE(others.value().contains("pairs"));
}

TEST_F(ShotsExport, PartsHaveTheirAreaAndThickness) {
    RunReport report;
    report.findings = write({"csv"});
    ASSERT_EQ(report.findings.shots.size(), 3u);
    std::map<std::string, ShotPart> parts;
    for (const ShotPart& part : report.findings.shots) {
        parts[part.name] = part;
        EXPECT_EQ(part.lines, 16u);
        EXPECT_EQ(part.area, 1.0);
    }
    EXPECT_EQ(parts["first"].thickness, (std::array<double, 2>{0.5, 0.5}));
    EXPECT_EQ(parts["second"].thickness, (std::array<double, 2>{1, 1}));
    EXPECT_EQ(parts["second"].crossings, 32u);
    EXPECT_EQ(parts["plate"].crossings, 16u);
    EXPECT_FALSE(parts["plate"].thickness);
    EXPECT_FALSE(parts["plate"].is_closed);
    EXPECT_THAT(
        summary_text(report),
        HasSubstr("second: crossed 32 times by 16 lines, seen area 1.00 m^2, thickness 1.00 m"));
    EXPECT_THAT(summary_text(report),
                HasSubstr("plate: crossed 16 times by 16 lines, seen area 1.00 "
                          "m^2, not closed: no thickness"));
    ASSERT_TRUE(write_summary(dir_, context_, report));
    const auto summary = nlohmann::json::parse(text_of("summary.json"));
    EXPECT_EQ(summary["question"], "shots");
    ASSERT_EQ(summary["parts_hit"].size(), 3u);
    EXPECT_EQ(summary["parts_hit"][0]["seen_area"], 1.0);
}

TEST_F(ShotsExport, TheMapCountsCrossings) {
    write({});
    std::uint64_t of_a = 0;
    for (const TriangleContacts& triangle : map_.bodies[0]) {
        of_a += triangle.scenarios;
    }
    EXPECT_EQ(of_a, 5 * 16u);
    EXPECT_EQ(map_.bodies[1].size(), 16u);
}

TEST_F(ShotsExport, LevelCountHasNoHits) {
    ask(shots_query(Level::Count));
    EXPECT_TRUE(write({"csv", "csv-pairs", "npz"}).shots.empty());
    EXPECT_FALSE(fs::exists(dir_ / "shotlines.csv"));
    EXPECT_FALSE(fs::exists(dir_ / "shots.npz"));
    EXPECT_THAT(text_of("scenarios.csv"), HasSubstr("class,count,hits,cut"));
}

TEST_F(ShotsExport, TextNamesHitsAndWhatTheyDo) {
    write({"text"});
    const std::string text = text_of("results.txt");
    EXPECT_THAT(text, HasSubstr("  contact  "));
    EXPECT_THAT(text, HasSubstr(" hits\n"));
    EXPECT_THAT(text, HasSubstr("  enters at depth "));
    EXPECT_THAT(text, HasSubstr("  leaves at depth "));
    EXPECT_THAT(text, testing::Not(HasSubstr("pair")));
    EXPECT_THAT(text, testing::Not(HasSubstr("proper")));
}

} // namespace cd::tests
