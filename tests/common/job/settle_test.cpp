// Proves that a scenario's class does not depend on which body is A, on the level, on a limit of
// pairs nor on how the trees were cut; that it pays for insides only where it must; and that open
// bodies, ignored pairs and undecided answers are left alone.

#include "common/job/settle.hpp"

#include "common/job/run_scenario.hpp"
#include "common/tree/build.hpp"
#include "tests/support/lattice_solids.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {

namespace {

ObbTree make_tree(Mesh mesh) {
    ThreadPool pool(1);
    return build_tree(share(std::move(mesh)), BuildOptions{}, pool);
}

Scenario make_scenario(const Pose& a, const Pose& b) {
    Scenario scenario;
    scenario.poses = {a, b};
    return scenario;
}

Query query_of(Level level, std::uint64_t limit_pairs = 0) {
    Query query;
    query.level = level;
    query.limit_pairs = limit_pairs;
    return query;
}

ScenarioRun run(const ObbTree& a,
                const ObbTree& b,
                const PosePair& poses,
                const Query& query = query_of(Level::Pairs)) {
    return run_scenario(a, b, make_scenario(poses.a, poses.b), query);
}

ScenarioClass class_of(const ObbTree& a,
                       const ObbTree& b,
                       const PosePair& poses,
                       const Query& query = query_of(Level::Pairs)) {
    return run(a, b, poses, query).result.kind;
}

bool has_proper_pair(const ScenarioResult& result) {
    return std::any_of(result.pairs.begin(), result.pairs.end(), [](const ContactPair& pair) {
        return pair.kind == PairClass::Proper;
    });
}

} // namespace

TEST(Settle, TheClassIsThatOfTheBodiesAlone) {
    int refined = 0;
    int inside = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        const CubeSolid solid_a = random_cubes(random, 1 + static_cast<int>(random() % 3), 6);
        const CubeSolid solid_b = random_cubes(random, 1 + static_cast<int>(random() % 3), 2);
        const ObbTree a = make_tree(solid_a.mesh);
        const ObbTree b = make_tree(solid_b.mesh);
        const LatticeMotion motion_a = random_motion(random, 1, false);
        const LatticeMotion motion_b = random_motion(random, 4, false);
        const PosePair poses{motion_a.pose(), motion_b.pose()};
        const ScenarioResult result = run(a, b, poses).result;
        const bool meets = interiors_meet(solid_a, motion_a, solid_b, motion_b);
        ASSERT_EQ(result.kind,
                  result.pair_count == 0 ? meets ? ScenarioClass::Inside : ScenarioClass::Separate
                  : meets                ? ScenarioClass::Cross
                                         : ScenarioClass::Touch);
        ASSERT_EQ(class_of(b, a, {poses.b, poses.a}), result.kind);
        ASSERT_EQ(class_of(a, b, poses, query_of(Level::Count)), result.kind);
        ASSERT_EQ(class_of(a, b, poses, query_of(Level::Contacts)), result.kind);
        ASSERT_EQ(class_of(a, b, poses, query_of(Level::Pairs, 1)), result.kind);
        ASSERT_EQ(class_of(a, b, poses, query_of(Level::Any)),
                  result.pair_count == 0 ? ScenarioClass::Separate : ScenarioClass::Contact);
        refined += result.kind == ScenarioClass::Cross && !has_proper_pair(result) ? 1 : 0;
        inside += result.kind == ScenarioClass::Inside ? 1 : 0;
    }
    EXPECT_GT(refined, 20);
    EXPECT_GT(inside, 5);
}

TEST(Settle, OrdinaryScenariosPayNothing) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 4));
    const SettleStatistics nothing;
    EXPECT_EQ(run(box, box, {Pose{}, translation_pose(9, 0, 0)}).inside.work, nothing) << "apart";
    EXPECT_EQ(run(box, box, {Pose{}, translation_pose(0.3, 0.2, 0.1)}).inside.work, nothing)
        << "cross";
    const PosePair stacked{Pose{}, translation_pose(0, 0, 2)};
    EXPECT_EQ(run(box, box, stacked, query_of(Level::Any)).inside.work, nothing) << "any";
    const SettleStatistics touching = run(box, box, stacked).inside.work;
    EXPECT_GT(touching.points, 0u);
    EXPECT_GT(touching.ray_box_tests, touching.points);
    EXPECT_GT(touching.ray_triangle_tests, touching.points);
    EXPECT_EQ(touching.searches, 0u);
    // Nothing is searched twice, but for pairs that a limit has cut.
    EXPECT_EQ(run(box, box, stacked, query_of(Level::Count)).inside.work.searches, 0u);
    EXPECT_EQ(run(box, box, stacked, query_of(Level::Pairs, 3)).inside.work.searches, 1u);
}

TEST(Settle, OpenBodiesAreSurfacesOnlyAndNotRefined) {
    const Mesh box = make_box(Vec3(2, 2, 2));
    std::vector<Triangle> triangles = box.triangles();
    triangles.pop_back();
    const ObbTree open = make_tree(make_mesh(box.vertices(), triangles));
    const ObbTree closed = make_tree(box);
    const PosePair same{};
    EXPECT_EQ(class_of(closed, closed, same), ScenarioClass::Cross);
    const ScenarioResult with_open = run(open, closed, same).result;
    EXPECT_EQ(with_open.kind, ScenarioClass::Touch);
    EXPECT_TRUE(with_open.surfaces_only);
    EXPECT_FALSE(settling_is_work(open, closed, with_open));
    EXPECT_EQ(run(closed, open, same).result.kind, ScenarioClass::Touch);
}

TEST(Settle, WhatIsIgnoredMakesNoClaim) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 2));
    const auto count = static_cast<std::uint32_t>(box.mesh().triangles().size());
    const PosePair crossing{Pose{}, translation_pose(1, 1, 1)};
    Query query = query_of(Level::Pairs);
    EXPECT_EQ(class_of(box, box, crossing, query), ScenarioClass::Cross);
    query.ignored = {{0, count, 0, count}};
    EXPECT_EQ(class_of(box, box, crossing, query), ScenarioClass::Separate);
    // Half of B's triangles may stick in A. Whatever is left, the levels and the limit agree.
    query.ignored = {{0, count, 0, count / 2}};
    const ScenarioClass some = class_of(box, box, crossing, query);
    query.limit_pairs = 1;
    EXPECT_EQ(class_of(box, box, crossing, query), some);
    query.level = Level::Count;
    EXPECT_EQ(class_of(box, box, crossing, query), some);
}

TEST(Settle, UndecidedStaysUndecided) {
    const ObbTree box = make_tree(make_box(Vec3(2, 2, 2)));
    ScenarioResult result;
    result.kind = ScenarioClass::Undecided;
    EXPECT_FALSE(settling_is_work(box, box, result));
    const Scenario scenario = make_scenario(Pose{}, Pose{});
    EXPECT_EQ(settle_class(box, box, scenario, query_of(Level::Pairs), result), SettleStatistics{});
    EXPECT_EQ(result.kind, ScenarioClass::Undecided);
}

} // namespace cd::tests
