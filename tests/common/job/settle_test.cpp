// Proves that a scenario's class does not depend on the order of bodies, the level, a limit of
// pairs or the cut of the trees; that containment is tested only where needed; that results with
// ignored pairs agree with an exact oracle; and that open bodies and undecided answers are not
// settled.

#include "common/job/settle.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/support/exact_solid.hpp"
#include "tests/support/lattice_solids.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cd::tests {

namespace {

ScenarioRun run(const ObbTree& a,
                const ObbTree& b,
                const PosePair& poses,
                const Query& query = query_of(Level::Pairs)) {
    return run_scenario(a, b, make_scenario(poses), query);
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

TEST(Settle, TheClassDependsOnTheBodiesAlone) {
    int refined = 0;
    int inside = 0;
    for (SeededRandom random : seeds(400)) {
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
                  result.pair_count == 0 ? result.kind : ScenarioClass::Contact);
        refined += result.kind == ScenarioClass::Cross && !has_proper_pair(result) ? 1 : 0;
        inside += result.kind == ScenarioClass::Inside ? 1 : 0;
    }
    EXPECT_GT(refined, 20);
    EXPECT_GT(inside, 5);
}

TEST(Settle, ScenariosThatNeedNoContainmentCostNothing) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 4));
    const SettleStatistics nothing;
    const InsideStatistics apart = run(box, box, {Pose{}, translation_pose(9, 0, 0)}).inside;
    EXPECT_EQ(apart.scenarios, 1u);
    EXPECT_EQ(apart.work, nothing);
    EXPECT_EQ(apart.seconds, 0) << "the clock was read";
    EXPECT_EQ(run(box, box, {Pose{}, translation_pose(0.3, 0.2, 0.1)}).inside.work, nothing)
        << "cross";
    const PosePair stacked{Pose{}, translation_pose(0, 0, 2)};
    EXPECT_EQ(run(box, box, stacked, query_of(Level::Any)).inside.work, nothing) << "any";
    const SettleStatistics touching = run(box, box, stacked).inside.work;
    EXPECT_GT(touching.points, 0u);
    EXPECT_GT(touching.ray_box_tests, touching.points);
    EXPECT_GT(touching.ray_triangle_tests, touching.points);
    EXPECT_EQ(touching.searches, 0u);
    // Nothing is searched twice, except pairs cut by a limit.
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
    EXPECT_FALSE(Settler(open, closed, {}).is_work(with_open));
    EXPECT_EQ(run(closed, open, same).result.kind, ScenarioClass::Touch);
}

TEST(Settle, IgnoredPairsDecideNothing) {
    const ObbTree box = make_tree(make_gridded_box(Vec3(2, 2, 2), 2));
    const auto count = static_cast<std::uint32_t>(box.mesh().triangles().size());
    const PosePair crossing{Pose{}, translation_pose(1, 1, 1)};
    Query query = query_of(Level::Pairs);
    EXPECT_EQ(class_of(box, box, crossing, query), ScenarioClass::Cross);
    query.ignored = {{0, count, 0, count}};
    EXPECT_EQ(class_of(box, box, crossing, query), ScenarioClass::Separate);
    // Half of B's triangles may be inside A. Whatever pairs remain, levels and limit agree.
    query.ignored = {{0, count, 0, count / 2}};
    const ScenarioClass some = class_of(box, box, crossing, query);
    query.limit_pairs = 1;
    EXPECT_EQ(class_of(box, box, crossing, query), some);
    query.level = Level::Count;
    EXPECT_EQ(class_of(box, box, crossing, query), some);
}

TEST(Settle, ContainmentIsDecidedForPartsThatAreNotIgnored) {
    // A car of a body and a wheel over ground; contacts of wheel and ground are ignored.
    const ObbTree ground = make_tree(make_box(Vec3(20, 20, 4)));
    const ObbTree car = make_tree(join({translated(make_box(Vec3(4, 2, 1)), Vec3(0, 0, 2)),
                                        translated(make_box(Vec3(1, 1, 1)), Vec3(0, 0, 0))}));
    Query query = query_of(Level::Any);
    query.ignored = {{0, 12, 12, 24}};
    EXPECT_EQ(class_of(ground, car, {Pose{}, translation_pose(0, 0, 1)}, query),
              ScenarioClass::Separate);
    EXPECT_EQ(class_of(ground, car, {Pose{}, Pose{}}, query), ScenarioClass::Contact);
    EXPECT_EQ(class_of(ground, car, {Pose{}, translation_pose(0, 0, -2.2)}, query),
              ScenarioClass::Inside);
    EXPECT_FALSE(run(ground, car, {Pose{}, Pose{}}, query).result.insides_skipped);
    // The remaining ground bounds no solid.
    query.ignored = {{0, 3, 12, 24}};
    EXPECT_TRUE(
        run(ground, car, {Pose{}, translation_pose(0, 0, 9)}, query).result.insides_skipped);
}

/// Makes boxes with integer coordinates, the k-th congruent to `residues[k]` modulo 8, at least 8 *
/// `least` large.
Mesh random_boxes(std::mt19937_64& random, const std::vector<int>& residues, int least) {
    std::vector<Mesh> boxes;
    const auto eights = [&](int from, int to) {
        return 8 * (from + static_cast<int>(random() % static_cast<unsigned>(to - from)));
    };
    for (const int residue : residues) {
        const auto length = [&] { return eights(least, 2 * least + 2); };
        const Vec3 size(length(), length(), length());
        const auto place = [&] { return eights(-6, 4) + residue; };
        const Vec3 low(place(), place(), place());
        boxes.push_back(translated(make_box(size), low + size / 2));
    }
    return join(boxes);
}

/// Returns whole boxes of 12 triangles, or one box and a part of another.
IgnoredRange random_ignored(std::mt19937_64& random) {
    const auto range = [&] {
        const auto begin = static_cast<std::uint32_t>(12 * (random() % 3));
        const auto length = static_cast<std::uint32_t>(random() % 8 == 0 ? 1 + random() % 24 : 12);
        return std::pair(begin, std::min(begin + length, 36u));
    };
    const auto [a_begin, a_end] = range();
    const auto [b_begin, b_end] = range();
    return {a_begin, a_end, b_begin, b_end};
}

/// Applies the rule to one body's triangles one by one, in exact numbers.
struct TrianglesInside {
    bool any = false;
    bool any_skipped = false;

    template <class IsIgnored>
    void look_at(const std::vector<ExactTriangle>& inner,
                 const std::vector<ExactTriangle>& outer,
                 const IsIgnored& is_ignored) {
        for (std::uint32_t i = 0; i < inner.size(); ++i) {
            std::vector<ExactTriangle> meets;
            std::array<int, 3> of_box{};
            for (std::uint32_t j = 0; j < outer.size(); ++j) {
                if (!is_ignored(i, j)) {
                    meets.push_back(outer[j]);
                    ++of_box[j / 12];
                }
            }
            if (std::ranges::any_of(of_box, [](int count) { return count % 12 != 0; })) {
                any_skipped = true;
            } else {
                any = any || ExactSolid(meets).place({inner[i][0], 1}) == PointPlace::Inside;
            }
        }
    }
};

TEST(Settle, ContainmentWithIgnoredPairsEqualsTheOracle) {
    int inside = 0;
    int separate = 0;
    int skipped = 0;
    for (SeededRandom random : seeds(600)) {
        // The bodies share no coordinate, however B is turned.
        const ObbTree a = make_tree(random_boxes(random, {0, 1, 7}, 6));
        const ObbTree b = make_tree(random_boxes(random, {3, 4, 5}, 1));
        const PosePair poses{Pose{}, random_motion(random, 1, false).pose()};
        Query query = query_of(Level::Pairs);
        for (std::uint64_t i = 1 + random() % 7; i > 0; --i) {
            query.ignored.push_back(random_ignored(random));
        }
        const ScenarioResult result = run(a, b, poses, query).result;
        const ExactWorld world = exact_world(a.mesh().vertices(), b.mesh().vertices(), poses);
        const auto exact_a = triangles_of(a.mesh(), world.a);
        const auto exact_b = triangles_of(b.mesh(), world.b);
        TrianglesInside expected;
        expected.look_at(exact_a, exact_b, [&](std::uint32_t i, std::uint32_t j) {
            return is_ignored(query.ignored, i, j);
        });
        expected.look_at(exact_b, exact_a, [&](std::uint32_t i, std::uint32_t j) {
            return is_ignored(query.ignored, j, i);
        });
        ASSERT_EQ(result.insides_skipped, expected.any_skipped);
        skipped += expected.any_skipped ? 1 : 0;
        if (result.pair_count > 0) {
            continue;
        }
        ASSERT_EQ(result.kind, expected.any ? ScenarioClass::Inside : ScenarioClass::Separate);
        inside += expected.any ? 1 : 0;
        separate += expected.any ? 0 : 1;
        for (const Level level : {Level::Any, Level::Count, Level::Contacts}) {
            query.level = level;
            ASSERT_EQ(class_of(a, b, poses, query), result.kind);
        }
        for (IgnoredRange& range : query.ignored) {
            range = {range.b_begin, range.b_end, range.a_begin, range.a_end};
        }
        ASSERT_EQ(class_of(b, a, {poses.b, poses.a}, query), result.kind);
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(separate, 20);
    EXPECT_GT(skipped, 20);
}

TEST(Settle, TooManyIgnoredPairsSkipContainment) {
    const ObbTree box = make_tree(make_box(Vec3(2, 2, 2)));
    const ObbTree small = make_tree(make_box(Vec3(1, 1, 1)));
    Query query = query_of(Level::Count);
    query.ignored.assign(limits::inside_ignored_max, {0, 1, 0, 0});
    EXPECT_EQ(class_of(box, small, {}, query), ScenarioClass::Inside);
    query.ignored.push_back({0, 1, 0, 0});
    const ScenarioResult result = run(box, small, {}, query).result;
    EXPECT_EQ(result.kind, ScenarioClass::Separate);
    EXPECT_TRUE(result.insides_skipped);
}

TEST(Settle, UndecidedStaysUndecided) {
    const ObbTree box = make_tree(make_box(Vec3(2, 2, 2)));
    ScenarioResult result;
    result.kind = ScenarioClass::Undecided;
    const Settler settler(box, box, {});
    EXPECT_FALSE(settler.is_work(result));
    EXPECT_EQ(settler.settle(Scenario{}, result).scenarios, 0u);
    EXPECT_EQ(result.kind, ScenarioClass::Undecided);
}

} // namespace cd::tests
