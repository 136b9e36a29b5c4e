// Proves that the hits of a bundle of lines are those of rationals, with one record for whole trees
// and for subtrees of any cut.

#include "common/job/result/contact_map.hpp"
#include "common/job/run_scenario.hpp"
#include "common/shots/line_hit.hpp"
#include "tests/common/job/in_parts.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/bundle_cases.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/shot_oracle.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

Query shots_query(Level level = Level::Pairs) {
    Query query = query_of(level);
    query.question = Question::Shots;
    return query;
}

/// Makes a mesh of n x n lines along z through the points of a grid, from -4 to 4.
Mesh make_bundle(int n, double spacing) {
    std::vector<Vec3> ends;
    std::vector<Triangle> lines;
    for (int x = 0; x < n; ++x) {
        for (int y = 0; y < n; ++y) {
            const auto first = static_cast<std::uint32_t>(ends.size());
            const Vec3 at(spacing * (x - 0.5 * (n - 1)), spacing * (y - 0.5 * (n - 1)), 0);
            ends.push_back(at - Vec3(0, 0, 4));
            ends.push_back(at + Vec3(0, 0, 4));
            lines.push_back({first, first + 1, first + 1});
        }
    }
    return make_mesh(std::move(ends), std::move(lines));
}

std::vector<Corners> corners_of(const Mesh& mesh) {
    std::vector<Corners> all;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        all.push_back(mesh.corners(i));
    }
    return all;
}

using HitsByPair = std::map<std::pair<std::uint32_t, std::uint32_t>, PairHit>;

HitsByPair true_hits(const Mesh& a, const Mesh& lines, const PosePair& poses, bool only_first) {
    const std::vector<Corners> triangles = corners_of(a);
    HitsByPair all;
    for (std::uint32_t line = 0; line < lines.triangles().size(); ++line) {
        const Corners ends = lines.corners(line);
        const Segment segment{ends[0], ends[1]};
        for (const LineHit& hit : rounded_hits(oracle_hits(triangles, segment, poses), segment)) {
            const bool crosses = (hit.flags & hit_flag::crosses) != 0;
            if (crosses || !only_first) {
                all[{hit.triangle, line}] = {hit.depth, hit.flags, hit.rank};
            }
            if (crosses && only_first) {
                break;
            }
        }
    }
    return all;
}

HitsByPair listed_hits(const ScenarioResult& result) {
    HitsByPair all;
    for (std::size_t i = 0; i < result.pairs.size(); ++i) {
        EXPECT_EQ(result.pairs[i].kind, PairClass::Touch);
        all[{result.pairs[i].a, result.pairs[i].b}] = result.hits[i];
    }
    return all;
}

/// Poses of a bundle: as it is, so that lines pass through vertices and edges, or turned.
Pose bundle_pose(std::mt19937_64& random) {
    switch (random() % 3) {
    case 0:
        return Pose();
    case 1:
        return Pose::from_quaternion({1, 1, 0, 0}, Vec3::Zero());
    default:
        return make_pose(random, 0.5);
    }
}

Mesh some_body(std::uint64_t number, std::mt19937_64& random) {
    switch (number % 4) {
    case 0:
        return make_gridded_box(Vec3(2, 2, 2), 2);
    case 1:
        return make_sphere(1);
    case 2:
        return make_degenerate_soup(random, 40);
    default:
        return join({make_box(Vec3(2, 2, 2)), make_box_between(Vec3(-1, -1, 1), Vec3(1, 1, 2))});
    }
}

std::uint64_t crossings_in(const HitsByPair& hits) {
    return static_cast<std::uint64_t>(std::ranges::count_if(
        hits, [](const auto& each) { return (each.second.flags & hit_flag::crosses) != 0; }));
}

} // namespace

TEST(ShotsScenario, HitsAreThoseOfRationals) {
    std::uint64_t crossings = 0;
    std::uint64_t others = 0;
    for (SeededRandom random : seeds(raised(12))) {
        const Mesh body = some_body(random.seed, random);
        const Mesh lines = make_bundle(5, 0.5);
        const PosePair poses{random() % 2 == 0 ? Pose() : make_pose(random, 0.3),
                             bundle_pose(random)};
        const ObbTree a = make_tree(body);
        const ObbTree b = make_tree(lines);
        const bool only_first = random() % 3 == 0;
        Query query = shots_query();
        query.first_hits = only_first;
        const ScenarioResult result = run_scenario(a, b, make_scenario(poses), query).result;
        const HitsByPair truth = true_hits(body, lines, poses, only_first);
        ASSERT_EQ(listed_hits(result), truth);
        EXPECT_EQ(result.pair_count, truth.size());
        EXPECT_EQ(result.kind, truth.empty() ? ScenarioClass::Separate : ScenarioClass::Contact);
        EXPECT_TRUE(std::ranges::is_sorted(result.pairs));
        EXPECT_FALSE(result.surfaces_only);
        crossings += crossings_in(truth);
        others += truth.size() - crossings_in(truth);
    }
    EXPECT_GT(crossings, 200u);
    EXPECT_GT(others, 50u);
}

TEST(ShotsScenario, PartsGiveTheSameRecordAsTheWhole) {
    std::map<ScenarioClass, int> classes;
    const ObbTree b = make_tree(make_bundle(6, 0.25));
    for (SeededRandom random : seeds(raised(60))) {
        const ObbTree a = make_tree(some_body(random.seed, random));
        const Pose pose = bundle_pose(random);
        const Vec3 by = random() % 4 == 0 ? Vec3(9, 0, 0) : Vec3(0, 0, 0);
        const Scenario scenario =
            make_scenario({Pose(), with_translation(pose, pose.translation() + by)}, 17);
        Query query = shots_query(random() % 3 == 0 ? Level::Count : Level::Pairs);
        query.first_hits = random() % 3 == 0;
        query.limit_pairs = random() % 3 == 0 ? 7 : 0;
        const std::array<std::uint32_t, 2> depths{static_cast<std::uint32_t>(random() % 13),
                                                  static_cast<std::uint32_t>(random() % 13)};
        const SubtreeForm form = random() % 3 > 0 ? SubtreeForm::Wide : SubtreeForm::Binary;
        const ScenarioResult whole = run_scenario(a, b, scenario, query).result;
        const Bytes record = encode_result(whole);
        ASSERT_EQ(encode_result(run_in_parts(a, b, depths, form, scenario, query, random)), record);
        const auto decoded = decode_result(record);
        ASSERT_TRUE(decoded) << decoded.error().detail;
        EXPECT_EQ(encode_result(decoded.value()), record);
        EXPECT_EQ(decoded.value().hits, whole.hits);
        ++classes[whole.kind];
    }
    EXPECT_GT(classes[ScenarioClass::Separate], 5);
    EXPECT_GT(classes[ScenarioClass::Contact], 20);
}

TEST(ShotsScenario, LevelsAndLimitsAgreeOnTheNumber) {
    const ObbTree a = make_tree(make_gridded_box(Vec3(2, 2, 2), 3));
    const ObbTree b = make_tree(make_bundle(5, 0.5));
    const Scenario scenario = make_scenario({});
    for (const bool only_first : {false, true}) {
        Query query = shots_query();
        query.first_hits = only_first;
        const ScenarioResult all = run_scenario(a, b, scenario, query).result;
        ASSERT_GT(all.pair_count, 12u);
        EXPECT_FALSE(all.is_cut());
        query.limit_pairs = 10;
        const ScenarioResult some = run_scenario(a, b, scenario, query).result;
        EXPECT_TRUE(some.is_cut());
        EXPECT_EQ(some.pair_count, all.pair_count);
        ASSERT_EQ(some.pairs.size(), 10u);
        EXPECT_TRUE(std::equal(some.pairs.begin(), some.pairs.end(), all.pairs.begin()));
        EXPECT_TRUE(std::equal(some.hits.begin(), some.hits.end(), all.hits.begin()));
        query.level = Level::Count;
        const ScenarioResult counted = run_scenario(a, b, scenario, query).result;
        EXPECT_EQ(counted.pair_count, all.pair_count);
        EXPECT_EQ(counted.kind, ScenarioClass::Contact);
        EXPECT_TRUE(counted.hits.empty());
    }
}

TEST(ShotsScenario, FirstHitsAreOneForEachLineThatCrosses) {
    const ObbTree a = make_tree(make_box(Vec3(2, 2, 2)));
    const ObbTree b = make_tree(make_bundle(4, 0.5));
    Query query = shots_query();
    query.first_hits = true;
    const ScenarioResult result = run_scenario(a, b, make_scenario({}), query).result;
    ASSERT_EQ(result.hits.size(), 16u);
    for (const PairHit& hit : result.hits) {
        EXPECT_EQ(hit.depth, 3.0);
        EXPECT_NE(hit.flags & hit_flag::crosses, 0);
        EXPECT_NE(hit.flags & hit_flag::front, 0);
    }
}

TEST(ShotsScenario, MapsCountCrossings) {
    const Mesh box = make_box(Vec3(2, 2, 2));
    const Mesh lines = make_bundle(4, 0.5);
    const ObbTree a = make_tree(box);
    const ObbTree b = make_tree(lines);
    for (const Level level : {Level::Count, Level::Pairs}) {
        Query query = shots_query(level);
        query.maps = true;
        query.limit_pairs = 3;
        const ScenarioRun run = run_scenario(a, b, make_scenario({}), query);
        ContactMapSum sum;
        sum.add(run.result, run.found);
        sum.add(run.result, run.found);
        const ContactMap map = sum.take();
        std::map<std::uint32_t, std::uint64_t> expected;
        for (const auto& [pair, hit] : true_hits(box, lines, PosePair{}, false)) {
            expected[pair.first] += (hit.flags & hit_flag::crosses) != 0 ? 2 : 0;
        }
        std::erase_if(expected, [](const auto& entry) { return entry.second == 0; });
        ASSERT_EQ(map.bodies[0].size(), expected.size());
        std::uint64_t total = 0;
        for (const TriangleContacts& entry : map.bodies[0]) {
            EXPECT_EQ(entry.scenarios, expected[entry.triangle]);
            total += entry.scenarios;
        }
        EXPECT_EQ(total, 2 * 2 * 16u); // Sixteen lines enter and leave the box in two scenarios.
        EXPECT_EQ(map.bodies[1].size(), 16u);
    }
}

TEST(ShotsScenario, AStoppedRunHasNoHits) {
    const ObbTree a = make_tree(make_sphere(3));
    const ObbTree b = make_tree(make_bundle(8, 0.125));
    const Query query = shots_query();
    int polls = 0;
    const ScenarioRunner whole(a, b, query, PairStage::Float, [&] {
        ++polls;
        return false;
    });
    ASSERT_FALSE(whole.run(make_scenario({})).is_stopped);
    for (const int last : {1, polls / 2, polls}) {
        int left = last;
        const ScenarioRunner runner(a, b, query, PairStage::Float, [&] { return --left <= 0; });
        const ScenarioRun run = runner.run(make_scenario({}));
        EXPECT_TRUE(run.is_stopped);
        EXPECT_TRUE(run.result.hits.empty());
    }
}

TEST(ShotsScenario, TheFirstStageChangesNoRecord) {
    const ObbTree a = make_tree(make_gridded_box(Vec3(2, 2, 2), 3));
    const ObbTree b = make_tree(make_bundle(5, 0.5));
    for (SeededRandom random : seeds(6)) {
        const Query query = shots_query();
        const Scenario scenario = make_scenario({make_pose(random, 0.1), bundle_pose(random)});
        const Bytes record = encode_result(run_scenario(a, b, scenario, query).result);
        for (const PairStage first :
             {PairStage::DoubleDouble, PairStage::WideInteger, PairStage::Arbitrary}) {
            const ScenarioRunner runner(a, b, query, first);
            EXPECT_EQ(encode_result(runner.run(scenario).result), record);
        }
    }
}

TEST(ShotsScenario, BundlesOfParallelLinesAreDecidedAsOthersAre) {
    std::uint64_t hits = 0;
    for (SeededRandom random : seeds(raised(24))) {
        const ObbTree a =
            make_tree(random() % 2 == 0 ? make_sphere(2) : make_gridded_box(Vec3(2, 3, 2), 3));
        const double jitter = random() % 2 == 0 ? 0 : 0.9;
        const ObbTree b =
            make_tree(mesh_of(grid_lines(random, random() % 3, {11, 8}, 0.25, jitter, {5, -5})));
        Query query = shots_query(random() % 4 == 0 ? Level::Count : Level::Pairs);
        query.first_hits = random() % 3 == 0;
        query.maps = random() % 3 == 0;
        if (random() % 2 == 0) {
            query.ignored = {{5, 20, 0, 88}};
        }
        // The second scenario finds the lines of the first one.
        const ScenarioRunner in_bundles(a, b, query);
        const ScenarioRunner one_by_one(a, b, query, PairStage::DoubleDouble);
        ScenarioSession session(in_bundles);
        for (int i = 0; i < 2; ++i) {
            const Scenario scenario = make_scenario({make_pose(random, 0.2), bundle_pose(random)});
            const ScenarioRun run = session.run(scenario);
            const ScenarioRun expected = one_by_one.run(scenario);
            ASSERT_EQ(encode_result(run.result), encode_result(expected.result));
            EXPECT_EQ(run.found, expected.found);
            hits += run.result.pair_count;
        }
    }
    EXPECT_GT(hits, 2000u);
}

TEST(ShotsScenario, FacesOfTwoSidesAreOnePlaceWithoutExactNumbers) {
    const Mesh sphere = make_sphere(2);
    const ObbTree a = make_tree(join({sphere, reversed(sphere)}));
    for (SeededRandom random : seeds(6)) {
        const ObbTree b = make_tree(mesh_of(grid_lines(random, 0, {20, 20}, 0.1, 0.5, {5, -5})));
        Query query = shots_query();
        query.first_hits = random() % 2 == 0;
        const Scenario scenario = make_scenario({Pose(), make_pose(random, 0.1)});
        const ScenarioRun run = run_scenario(a, b, scenario, query);
        EXPECT_GT(run.result.pair_count, query.first_hits ? 200u : 1000u);
        EXPECT_EQ(run.statistics.decisions.total(), run.statistics.decisions[PairStage::Double]);
        const ScenarioRunner one_by_one(a, b, query, PairStage::DoubleDouble);
        EXPECT_EQ(encode_result(run.result), encode_result(one_by_one.run(scenario).result));
    }
}

TEST(ShotsScenario, MostHitsOfABundleAreProvenInDoubles) {
    const ObbTree a = make_tree(make_sphere(3));
    std::mt19937_64 random(1);
    const ObbTree b = make_tree(mesh_of(grid_lines(random, 0, {20, 20}, 0.1, 0, {5, -5})));
    const Query query = shots_query();
    const ScenarioRun run =
        run_scenario(a, b, make_scenario({Pose(), make_pose(random, 0.1)}), query);
    EXPECT_GT(run.result.pair_count, 500u);
    EXPECT_GT(run.statistics.decisions[PairStage::Double], run.result.pair_count);
    EXPECT_EQ(run.statistics.decisions.total(), run.statistics.decisions[PairStage::Double]);
    EXPECT_EQ(run.statistics.triangle_tests, run.statistics.decisions.total());
    EXPECT_GT(run.statistics.box_tests, 0u);
}

} // namespace cd::tests
