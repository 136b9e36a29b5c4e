// Proves that lines through several bodies have one order over all of them, that posed bodies have
// the angles and thicknesses of the world, and that files name step, bundle and body.
#include "client/export/result_sink.hpp"
#include "client/export/shots/bundle_passages.hpp"
#include "common/job/poses/pose_source.hpp"
#include "tests/support/line_scene.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Row = std::map<std::string, std::string>;

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream cells(line);
    for (std::string field; std::getline(cells, field, ',');) {
        fields.push_back(field);
    }
    return fields;
}

/// Returns the rows of a table by the names of its columns.
std::vector<Row> rows_of(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> names = fields_of(line);
    std::vector<Row> rows;
    while (std::getline(lines, line)) {
        std::vector<std::string> fields = fields_of(line);
        fields.resize(names.size());
        Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < names.size(); ++i) {
            row[names[i]] = fields[i];
        }
    }
    return rows;
}

/// A box in front of another, two steps, and lines from the front. In the second step the boxes
/// have changed places, and one of them is turned by 45 degrees about its middle.
class SceneShots : public testing::Test {
  protected:
    SceneShots() {
        box_ = share(make_box_between(Vec3(-0.5, 0, 0), Vec3(0.5, 1, 1)));
        spec_.grid.spacing = 0.5;
        spec_.grid.tile = 2;
        spec_.box = Aabb{Vec3(-4, 0, 0), Vec3(4, 1, 1)};
        lines_ = share(shot_mesh(spec_, *spec_.box).value());
        bundles_ = shot_poses(spec_, *spec_.box).value();
        context_.bodies = {
            {"near", "box.obj", box_}, {"far", "box.obj", box_}, {"lines", "", lines_}};
        context_.bodies[2].views = std::make_shared<const ShotViews>(spec_, *spec_.box);
        context_.unit = "m";
        add_step(at(2), at(-2));
        add_step(
            Pose::from_quaternion(
                {std::cos(0.125 * 3.141592653589793), 0, 0, std::sin(0.125 * 3.141592653589793)},
                Vec3(-2 + std::sqrt(0.125), 0.5 - std::sqrt(0.125), 0)),
            at(2));
        const auto steps = std::make_shared<StepIndex>();
        steps->add_step({2 * bundles_.size()});
        steps->add_step({2 * bundles_.size()});
        steps->set_times({0.5, 1.5});
        context_.steps = steps;
        context_.bodies.back().poses = make_list_source(scenarios_);
        ask(shots_query(Level::Pairs));
    }

    static Pose at(double x) { return Pose::from_quaternion({1, 0, 0, 0}, Vec3(x, 0, 0)); }

    void add_step(const Pose& near, const Pose& far) {
        const std::uint64_t step = scenarios_.size() / (2 * bundles_.size());
        for (std::uint64_t bundle = 0; bundle < bundles_.size(); ++bundle) {
            for (std::uint32_t body = 0; body < 2; ++body) {
                scenarios_.push_back({scenarios_.size(),
                                      body,
                                      2,
                                      {body == 0 ? near : far, bundles_[bundle].pose},
                                      step * bundles_.size() + bundle});
            }
        }
    }

    void ask(const Query& query) {
        query_ = query;
        context_.describe(query);
    }

    [[nodiscard]] std::vector<ScenarioResult> results() const {
        const ObbTree box = make_tree(*box_);
        const ObbTree lines = make_tree(*lines_);
        std::vector<ScenarioResult> results;
        for (const Scenario& scenario : scenarios_) {
            Scenario alone = scenario; // The trees are those of bodies 0 and 1.
            alone.body_a = 0;
            alone.body_b = 1;
            results.push_back(run_scenario(box, lines, alone, query_).result);
            results.back().body_a = scenario.body_a;
            results.back().body_b = scenario.body_b;
        }
        return results;
    }

    RunFindings write(const std::vector<std::string>& formats) {
        auto files = ResultSink::open({folder_.path(), formats}, context_);
        EXPECT_TRUE(files) << files.error().detail;
        for (const ScenarioResult& result : results()) {
            EXPECT_TRUE(files.value().add(result));
        }
        EXPECT_TRUE(files.value().finish(std::nullopt));
        return files.value().findings();
    }

    [[nodiscard]] std::vector<Row> shotlines() const {
        return rows_of(read_text(folder_ / "shotlines.csv"));
    }

    const TemporaryFolder folder_;
    std::shared_ptr<const Mesh> box_;
    ShotsSpec spec_;
    std::shared_ptr<const Mesh> lines_;
    std::vector<BundlePose> bundles_;
    std::vector<Scenario> scenarios_;
    ExportContext context_;
    Query query_;
};

} // namespace

TEST_F(SceneShots, PassagesOfALineAreInOneOrderOverAllBodies) {
    write({"csv", "csv-pairs"});
    const std::vector<Row> rows = shotlines();
    ASSERT_EQ(rows.size(), 4u + 4u + 4u + 4u) << "four lines through two boxes at two steps";
    std::size_t of_second_step = 0;
    for (std::size_t i = 0; i < rows.size(); i += 2) {
        const bool is_second = rows[i].at("step") == "1";
        of_second_step += is_second ? 1 : 0;
        EXPECT_EQ(rows[i].at("time"), is_second ? "1.5" : "0.5");
        EXPECT_EQ(rows[i].at("body"), is_second ? "far" : "near") << "it stands at x = 2";
        EXPECT_EQ(rows[i + 1].at("body"), is_second ? "near" : "far");
        EXPECT_EQ(rows[i].at("line"), rows[i + 1].at("line"));
        EXPECT_EQ(rows[i].at("order"), "0");
        EXPECT_EQ(rows[i + 1].at("order"), "1");
        EXPECT_EQ(rows[i].at("thickness"), "1");
        const double gap = std::stod(rows[i + 1].at("in")) - std::stod(rows[i].at("out"));
        EXPECT_NEAR(std::stod(rows[i].at("gap")), gap, 1e-12);
        EXPECT_EQ(rows[i + 1].at("gap"), "");
        const double cosine = std::stod(rows[i + 1].at("cos_in"));
        EXPECT_NEAR(cosine, is_second ? std::sqrt(0.5) : 1, 1e-12) << "of the box as it stands";
        EXPECT_EQ(std::stod(rows[i].at("cos_in")), 1);
    }
    EXPECT_EQ(of_second_step, 4u);
    const std::string scenarios = read_text(folder_ / "scenarios.csv");
    EXPECT_THAT(scenarios, HasSubstr("count,hits,bundle,bundle_id,cut"));
    EXPECT_THAT(scenarios, HasSubstr(",0,\"az=0 el=0 tile="));
}

TEST_F(SceneShots, WithFirstALineHasOneCrossingOfAllBodies) {
    Query first = shots_query(Level::Pairs);
    first.first_hits = true;
    ask(first);
    const RunFindings findings = write({"csv-pairs"});
    const std::vector<Row> rows = shotlines();
    ASSERT_EQ(rows.size(), 8u);
    for (const Row& row : rows) {
        EXPECT_EQ(row.at("body"), row.at("step") == "0" ? "near" : "far");
        EXPECT_EQ(row.at("order"), "0");
        EXPECT_EQ(row.at("thickness"), "");
    }
    ASSERT_EQ(findings.shots.size(), 2u);
    EXPECT_EQ(findings.shots[0].lines, 4u);
    EXPECT_EQ(findings.shots[1].lines, 4u);
}

TEST_F(SceneShots, PartsAreNamedWithTheirBodies) {
    const RunFindings findings = write({"csv"});
    ASSERT_EQ(findings.shots.size(), 2u);
    std::map<std::string, ShotPart> parts;
    for (const ShotPart& part : findings.shots) {
        parts[part.name] = part;
        EXPECT_EQ(part.lines, 8u);
        EXPECT_EQ(part.crossings, 16u);
        EXPECT_EQ(part.area, 1.0) << "in the mean over two steps";
        EXPECT_TRUE(part.is_closed);
    }
    ASSERT_TRUE(parts.contains("near/whole"));
    ASSERT_TRUE(parts.contains("far/whole"));
    EXPECT_EQ(parts["far/whole"].thickness, (std::array<double, 2>{1, 1}));
    EXPECT_LT((*parts["near/whole"].thickness)[0], 1)
        << "lines pass by its middle where it is turned";
}

TEST_F(SceneShots, NpzNamesStepBundleAndBody) {
    write({"npz"});
    const auto read = read_npz(folder_ / "shots.npz");
    ASSERT_TRUE(read) << read.error().detail;
    const auto steps = read.value().at("step").to_integers().value();
    const auto bundles = read.value().at("bundle").to_integers().value();
    const auto bodies = read.value().at("body").to_integers().value();
    ASSERT_EQ(steps.size(), scenarios_.size());
    for (std::size_t i = 0; i < scenarios_.size(); ++i) {
        EXPECT_EQ(static_cast<std::uint64_t>(steps[i]) * bundles_.size() +
                      static_cast<std::uint64_t>(bundles[i]),
                  *scenarios_[i].step);
        EXPECT_EQ(bodies[i], scenarios_[i].body_a);
    }
    const auto results = read_npz(folder_ / "results.npz");
    ASSERT_TRUE(results);
    EXPECT_EQ(results.value().at("step").to_integers().value(), steps);
    EXPECT_EQ(results.value().at("body_a").to_integers().value(), bodies);
}

TEST_F(SceneShots, OverlappingBodiesAreBothTold) {
    scenarios_.clear();
    add_step(at(0), at(0.25));
    add_step(at(0), at(0));
    context_.bodies.back().poses = make_list_source(scenarios_);
    write({"csv-pairs"});
    const std::vector<Row> rows = shotlines();
    ASSERT_EQ(rows.size(), 16u);
    EXPECT_EQ(rows[0].at("body"), "far");
    EXPECT_EQ(rows[1].at("body"), "near");
    EXPECT_EQ(rows[0].at("gap"), "-0.75");
    const Row& same = *std::ranges::find(rows, "1", [](const Row& row) { return row.at("step"); });
    EXPECT_EQ(same.at("body"), "near") << "at equal depths the first body comes first";
    EXPECT_EQ(same.at("gap"), "-1");
}

TEST_F(SceneShots, LinesOfAFileEndInsideABodyWhereItStands) {
    spec_ = {};
    spec_.file = "lines.npy";
    context_.bodies[2].views = std::make_shared<const ShotViews>(spec_, Aabb());
    lines_ = share(line_mesh({{Vec3(8, 0.5, 0.5), Vec3(-1.75, 0.5, 0.5)},
                              {Vec3(8, 0.25, 0.5), Vec3(-8, 0.25, 0.5)}})
                       .value());
    context_.bodies[2].mesh = lines_;
    scenarios_.clear();
    bundles_.assign(1, {});
    add_step(at(2), at(-2));
    add_step(at(-2), at(2));
    const auto steps = std::make_shared<StepIndex>();
    steps->add_step({2});
    steps->add_step({2});
    context_.steps = steps;
    context_.bodies.back().poses = make_list_source(scenarios_);
    write({"csv-pairs"});
    const std::vector<Row> rows = shotlines();
    ASSERT_EQ(rows.size(), 8u);
    for (std::size_t i = 0; i < rows.size(); i += 4) {
        EXPECT_EQ(rows[i].at("thickness"), "1");
        EXPECT_EQ(rows[i + 1].at("thickness"), "") << "line 0 ends inside the body at x = -2";
        EXPECT_EQ(rows[i + 1].at("body"), i == 0 ? "far" : "near");
        EXPECT_EQ(rows[i + 2].at("thickness"), "1");
        EXPECT_EQ(rows[i + 3].at("thickness"), "1");
    }
}

TEST_F(SceneShots, WithoutPosesOnlyWhatNeedsNoneIsTold) {
    context_.bodies.back().poses = nullptr;
    const auto refused = ResultSink::open({folder_.path(), {"csv-pairs"}}, context_);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().detail, HasSubstr("poses of the scene are not at hand"));
    EXPECT_EQ(write({"csv"}).shots.size(), 2u) << "lines of a grid end outside";
    spec_ = {};
    spec_.file = "lines.npy";
    context_.bodies[2].views = std::make_shared<const ShotViews>(spec_, Aabb());
    EXPECT_TRUE(write({"csv"}).shots.empty()) << "where lines of a file end is not known";
}

TEST_F(SceneShots, ResultsOfOtherBodiesAreRefused) {
    auto files = ResultSink::open({folder_.path(), {"csv"}}, context_);
    ASSERT_TRUE(files);
    ScenarioResult odd = results().front();
    odd.body_b = 1;
    const Status added = files.value().add(odd);
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().code, ErrorCode::BadFrame);
}

} // namespace cd::tests
