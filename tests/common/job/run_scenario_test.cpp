// Proves that a scenario has one result for whole trees and for subtrees of any cut, that each
// level contains what it promises, and that classes are as documented.

#include "common/job/run_scenario.hpp"

#include "common/search/brute_force.hpp"
#include "tests/common/job/in_parts.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

namespace cd::tests {

namespace {

/// Returns the wide subtrees of a cut, with support points where wanted.
std::vector<Subtree> wide_parts(const ObbTree& tree, std::uint32_t depth, bool has_points) {
    std::vector<Subtree> parts;
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        const Subtree binary = extract_subtree(tree, node);
        const WideTree wide = WideTree::of_part(binary.view());
        parts.emplace_back(has_points ? wide.with_support() : wide);
    }
    return parts;
}

ScenarioClass class_at(const ObbTree& a, const ObbTree& b, const Pose& pose, Level level) {
    return run_scenario(a, b, make_scenario({Pose{}, pose}), query_of(level)).result.kind;
}

} // namespace

TEST(RunScenario, PartsGiveTheSameRecordAsTheWhole) {
    std::mt19937_64 random(5);
    std::vector<ObbTree> trees;
    trees.push_back(make_tree(make_sphere(2)));
    trees.push_back(make_tree(make_gridded_box(Vec3(1.5, 1, 1), 4)));
    trees.push_back(make_tree(make_triangle_soup(random, 60)));
    trees.push_back(make_tree(make_degenerate_soup(random, 40)));
    int in_contact = 0;
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        const ObbTree& a = trees[random() % trees.size()];
        const ObbTree& b = trees[random() % trees.size()];
        const Scenario scenario =
            make_scenario({make_pose(random, 0.2), make_pose(random, 1.5)}, 17);
        const bool is_wide = suits_wide_tree(a.view()) && suits_wide_tree(b.view());
        for (const Level level : levels) {
            const Query query = query_of(level, round % 3 == 0 ? 5 : 0);
            const std::array<std::uint32_t, 2> depths{static_cast<std::uint32_t>(random() % 12),
                                                      static_cast<std::uint32_t>(random() % 12)};
            const SubtreeForm form =
                is_wide && random() % 4 > 0 ? SubtreeForm::Wide : SubtreeForm::Binary;
            const ScenarioResult whole = run_scenario(a, b, scenario, query).result;
            const Bytes record = encode_result(whole);
            const ScenarioResult parts = run_in_parts(a, b, depths, form, scenario, query, random);
            ASSERT_EQ(encode_result(parts), record);
            const auto decoded = decode_result(record);
            ASSERT_TRUE(decoded) << decoded.error().detail;
            in_contact += whole.kind == ScenarioClass::Contact ? 1 : 0;
        }
    }
    EXPECT_GT(in_contact, 15);
    EXPECT_LT(in_contact, 55);
}

/// One search goes from pair to pair of subtrees and from pose to pose. Half of the rounds have
/// subtrees with support points.
TEST(RunScenario, ASearchKeptAlongASweepFindsInPartsWhatTheWholeHas) {
    const ObbTree torus = make_tree(make_torus(1, 0.3, 60, 30));
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 0.5, 0.25), 12));
    int in_contact = 0;
    int runs = 0;
    for (SeededRandom random : seeds(8)) {
        const std::array<std::uint32_t, 2> depths{static_cast<std::uint32_t>(random() % 5),
                                                  static_cast<std::uint32_t>(random() % 5)};
        const bool has_points = random() % 2 == 0;
        const std::vector<Subtree> parts_a = wide_parts(torus, depths[0], has_points);
        const std::vector<Subtree> parts_b = wide_parts(box, depths[1], has_points);
        const TreeTop top_a = cut_tree(torus, depths[0]);
        const TreeTop top_b = cut_tree(box, depths[1]);
        for (const Level level : {Level::Any, Level::Pairs}) {
            const Query query = query_of(level);
            KeptSearch kept;
            Vec3 place(uniform(random, 1.75, 1.85), 0, 0);
            for (std::uint64_t i = 0; i < 60; ++i) {
                place += 0.02 * make_pose(random, 1).translation();
                const Scenario scenario =
                    make_scenario({Pose{}, translation_pose(place.x(), place.y(), place.z())}, i);
                std::vector<SubtreePair> pairs;
                const auto roots = colliding_roots(top_a, top_b, scenario.poses).value();
                for (const RootPair& pair : roots.pairs) {
                    pairs.push_back({parts_a[pair.a].view(), parts_b[pair.b].view()});
                }
                std::shuffle(pairs.begin(), pairs.end(), random);
                ScenarioResult found = run_on_subtrees(kept, pairs, scenario, query).result;
                ASSERT_EQ(kept.touching.has_value(), found.kind == ScenarioClass::Contact);
                if (kept.touching) {
                    const SubtreePair touching = pairs[*kept.touching];
                    ASSERT_EQ(run_on_subtrees({&touching, 1}, scenario, query).result.kind,
                              found.kind);
                    ++in_contact;
                }
                (void)Settler(torus, box, query.ignored).settle(scenario, found);
                ASSERT_EQ(encode_result(found),
                          encode_result(run_scenario(torus, box, scenario, query).result));
                runs += level == Level::Any ? 1 : 0;
            }
        }
    }
    EXPECT_GT(in_contact, runs / 10);
    EXPECT_LT(in_contact, runs * 9 / 10);
}

TEST(RunScenario, EachLevelContainsWhatItPromises) {
    const ObbTree sphere = make_tree(make_sphere(2));
    const Scenario scenario = make_scenario({Pose{}, translation_pose(0.9, 0.1, 0.2)}, 17);
    const auto expected = contact_pairs_brute_force(sphere.mesh(), sphere.mesh(), scenario.poses);
    ASSERT_GT(expected.size(), 10u);

    const auto any = run_scenario(sphere, sphere, scenario, query_of(Level::Any)).result;
    EXPECT_EQ(any.kind, ScenarioClass::Contact);
    EXPECT_EQ(any.pair_count, 0u);
    EXPECT_EQ(any.index, 17u);

    const auto count = run_scenario(sphere, sphere, scenario, query_of(Level::Count)).result;
    EXPECT_EQ(count.kind, ScenarioClass::Cross);
    EXPECT_EQ(count.pair_count, expected.size());
    EXPECT_TRUE(count.pairs.empty());

    const auto pairs = run_scenario(sphere, sphere, scenario, query_of(Level::Pairs)).result;
    EXPECT_EQ(pairs.pairs, expected);
    EXPECT_FALSE(pairs.is_cut());
    EXPECT_TRUE(pairs.points.empty());

    const auto contacts = run_scenario(sphere, sphere, scenario, query_of(Level::Contacts)).result;
    EXPECT_EQ(contacts.pairs, expected);
    ASSERT_EQ(contacts.point_offsets.size(), expected.size() + 1);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const std::uint32_t points = contacts.point_offsets[i + 1] - contacts.point_offsets[i];
        EXPECT_GE(points, 1u);
        const Vec3 first = sphere.mesh().corners(expected[i].a)[0];
        EXPECT_EQ(contacts.point_origins[i], first);
    }
    for (const Vec3& point : contacts.points) {
        EXPECT_LT(point.norm(), 0.6) << "shared points lie in the small triangle of A";
    }
}

TEST(RunScenario, AnyStopsAtTheFirstContact) {
    const ObbTree sphere = make_tree(make_sphere(4));
    const Scenario scenario = make_scenario({Pose{}, translation_pose(0.9, 0.1, 0.2)});
    const auto any = run_scenario(sphere, sphere, scenario, query_of(Level::Any)).statistics;
    const auto pairs = run_scenario(sphere, sphere, scenario, query_of(Level::Pairs)).statistics;
    EXPECT_GT(any.triangle_tests, 0u);
    EXPECT_LT(10 * any.triangle_tests, pairs.triangle_tests);
}

TEST(RunScenario, TheFirstStageChangesNoResult) {
    std::mt19937_64 random(9);
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 1, 1), 3));
    const ObbTree sphere = make_tree(make_sphere(2));
    for (int round = 0; round < 12; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        // Every third round slides a box along a box, where ties are the rule.
        const bool ties = round % 3 == 0;
        const ObbTree& b = ties ? box : sphere;
        const Pose pose = ties ? translation_pose(1, 0.25 * round, 0) : make_pose(random, 0.8);
        const Scenario scenario = make_scenario({Pose{}, pose});
        const Query query = query_of(Level::Contacts);
        const ScenarioRun first = ScenarioRunner(box, b, query).run(scenario);
        for (std::size_t i = 1; i < pair_stage_count; ++i) {
            const auto stage = static_cast<PairStage>(i);
            const ScenarioRun run = ScenarioRunner(box, b, query, stage).run(scenario);
            EXPECT_EQ(digest_of(run.result), digest_of(first.result)) << to_text(stage);
            EXPECT_EQ(run.statistics.decisions.total(), first.statistics.decisions.total());
            for (std::size_t before = 0; before < i; ++before) {
                EXPECT_EQ(run.statistics.decisions.settled[before], 0u) << to_text(stage);
            }
        }
    }
}

TEST(RunScenario, TheCostOfContainmentIsReportedSeparately) {
    const ObbTree box = make_tree(make_box(Vec3(2, 2, 2)));
    const ObbTree small = make_tree(make_box(Vec3(0.5, 0.5, 0.5)));
    const Scenario inside{};
    const Scenario across = make_scenario({Pose{}, translation_pose(1, 0.1, 0.1)});
    for (const Level level : {Level::Any, Level::Count}) {
        EXPECT_EQ(run_scenario(box, small, inside, query_of(level)).inside.scenarios, 1u);
        EXPECT_EQ(run_scenario(box, small, across, query_of(level)).inside.scenarios, 0u);
    }
}

TEST(RunScenario, AStoppedScenarioHasNoAnswer) {
    const ObbTree sphere = make_tree(make_sphere(4));
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 12));
    const Scenario in_place{};
    const Scenario stacked = make_scenario({Pose{}, translation_pose(0, 0, 2)});
    for (const Level level : levels) {
        SCOPED_TRACE(to_text(level));
        const Query query = query_of(level);
        for (const auto& [tree, scenario] :
             {std::pair(&sphere, &in_place), std::pair(&box, &stacked)}) {
            std::uint64_t checks = 0;
            std::uint64_t checks_max = std::numeric_limits<std::uint64_t>::max();
            const ScenarioRunner runner(
                *tree, *tree, query, PairStage::Float, [&] { return ++checks > checks_max; });
            const ScenarioRun whole = runner.run(*scenario);
            EXPECT_FALSE(whole.is_stopped);
            EXPECT_EQ(digest_of(whole.result),
                      digest_of(run_scenario(*tree, *tree, *scenario, query).result));
            const std::uint64_t checks_of_all = checks;
            EXPECT_GE(checks_of_all, level == Level::Any ? 1u : 10u);
            for (const std::uint64_t last :
                 {std::uint64_t{0}, checks_of_all / 2, checks_of_all - 1}) {
                checks = 0;
                checks_max = last;
                const ScenarioRun stopped = runner.run(*scenario);
                EXPECT_TRUE(stopped.is_stopped) << last;
                EXPECT_EQ(stopped.result.kind, ScenarioClass::Failed);
                EXPECT_TRUE(stopped.result.pairs.empty());
                EXPECT_LE(checks, last + 12) << "it went on";
            }
        }
    }
}

TEST(RunScenario, ASessionGivesTheResultsOfSingleRuns) {
    std::mt19937_64 random(11);
    const ObbTree sphere = make_tree(make_sphere(3));
    const ObbTree box = make_tree(make_gridded_box(Vec3(1, 1, 1), 4));
    std::vector<Scenario> scenarios;
    for (std::uint64_t i = 0; i < 50; ++i) {
        const auto place = [&] { return 0.25 * static_cast<double>(random() % 9) - 1; };
        scenarios.push_back(
            make_scenario({Pose{}, translation_pose(place(), place(), place())}, i));
    }
    for (const Level level : levels) {
        const Query query = query_of(level);
        const ScenarioRunner runner(sphere, box, query);
        ScenarioSession session(runner);
        for (const Scenario& scenario : scenarios) {
            EXPECT_EQ(digest_of(session.run(scenario).result),
                      digest_of(runner.run(scenario).result));
        }
    }
}

TEST(RunScenario, ALimitKeepsTheFirstPairsAndTheTrueCount) {
    const ObbTree sphere = make_tree(make_sphere(2));
    const Scenario scenario = make_scenario({Pose{}, translation_pose(0.9, 0.1, 0.2)});
    Query query = query_of(Level::Contacts);
    const auto all = run_scenario(sphere, sphere, scenario, query).result;
    query.limit_pairs = 4;
    const auto cut = run_scenario(sphere, sphere, scenario, query).result;
    EXPECT_TRUE(cut.is_cut());
    EXPECT_EQ(cut.pair_count, all.pairs.size());
    EXPECT_EQ(cut.kind, all.kind);
    EXPECT_TRUE(std::equal(cut.pairs.begin(), cut.pairs.end(), all.pairs.begin()));
    ASSERT_EQ(cut.pairs.size(), 4u);
    EXPECT_EQ(cut.points.size(), all.point_offsets[4]);
    query.limit_pairs = all.pairs.size();
    EXPECT_FALSE(run_scenario(sphere, sphere, scenario, query).result.is_cut());
}

TEST(RunScenario, ClassesOfBoxes) {
    const ObbTree box = make_tree(make_box(Vec3(2, 2, 2)));
    const ObbTree small = make_tree(make_box(Vec3(0.5, 0.5, 0.5)));
    const Level level = Level::Count;
    EXPECT_EQ(class_at(box, box, translation_pose(3, 0, 0), level), ScenarioClass::Separate);
    EXPECT_EQ(class_at(box, box, translation_pose(2, 0.3, 0.1), level), ScenarioClass::Touch);
    EXPECT_EQ(class_at(box, box, translation_pose(2, 2, 2), level), ScenarioClass::Touch);
    EXPECT_EQ(class_at(box, box, translation_pose(1.3, 0.4, 0.2), level), ScenarioClass::Cross);
    EXPECT_EQ(class_at(box, small, translation_pose(0.3, 0.1, 0), level), ScenarioClass::Inside);
    EXPECT_EQ(class_at(small, box, translation_pose(0.3, 0.1, 0), level), ScenarioClass::Inside);
    EXPECT_EQ(class_at(box, small, Pose{}, Level::Any), ScenarioClass::Inside);
    EXPECT_EQ(class_at(box, small, Pose{}, Level::Pairs), ScenarioClass::Inside);
}

TEST(RunScenario, OpenBodiesAreSurfacesOnly) {
    std::vector<Triangle> triangles = make_box(Vec3(2, 2, 2)).triangles();
    triangles.pop_back();
    const ObbTree open = make_tree(make_mesh(make_box(Vec3(2, 2, 2)).vertices(), triangles));
    const ObbTree small = make_tree(make_box(Vec3(0.5, 0.5, 0.5)));
    const auto result = run_scenario(open, small, Scenario{}, query_of(Level::Count)).result;
    EXPECT_EQ(result.kind, ScenarioClass::Separate);
    EXPECT_TRUE(result.surfaces_only);
    EXPECT_FALSE(Settler(open, small, {}).is_work(result));
    const auto closed = run_scenario(small, small, Scenario{}, query_of(Level::Count)).result;
    EXPECT_FALSE(closed.surfaces_only);
}

TEST(RunScenario, IgnoredPairsAreNoContacts) {
    const ObbTree box = make_tree(make_box(Vec3(2, 2, 2)));
    const Scenario scenario = make_scenario({Pose{}, translation_pose(1.3, 0.4, 0.2)});
    Query query = query_of(Level::Pairs);
    const auto all = run_scenario(box, box, scenario, query).result;
    const ContactPair& first = all.pairs.front();
    query.ignored = {{first.a, first.a + 1, 0, 12}};
    const auto some = run_scenario(box, box, scenario, query).result;
    EXPECT_LT(some.pair_count, all.pair_count);
    for (const ContactPair& pair : some.pairs) {
        EXPECT_NE(pair.a, first.a);
    }
    query.ignored = {{0, 12, 0, 12}};
    EXPECT_EQ(run_scenario(box, box, scenario, query).result.kind, ScenarioClass::Separate);
}

TEST(RunScenario, NoPairsOfSubtreesMeansSeparate) {
    for (const Level level : levels) {
        const ScenarioRun run = run_on_subtrees({}, Scenario{}, query_of(level));
        EXPECT_EQ(run.result.kind, ScenarioClass::Separate);
        EXPECT_EQ(run.statistics.box_tests, 0u);
        EXPECT_TRUE(decode_result(encode_result(run.result)));
    }
}

} // namespace cd::tests
