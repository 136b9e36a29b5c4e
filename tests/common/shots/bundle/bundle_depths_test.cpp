// Proves that depths of bundles are those of SegmentHit, rounded once, and that the bounds are
// needed.
#include "common/shots/bundle/bundle_depths.hpp"

#include "common/shots/segment_hit.hpp"
#include "tests/support/bundle_cases.hpp"
#include "tests/support/distance_oracle.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/shot_oracle.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cd::tests {

namespace {

/// Returns the block of one triangle, in floats if they hold it.
TriangleBlockArrays block_of(const Corners& t) {
    const std::vector<Vec3> vertices(t.begin(), t.end());
    const Triangle triangle{0, 1, 2};
    const std::uint32_t id = 0;
    TriangleBlockArrays blocks(precision_of(vertices));
    blocks.add({&triangle, 1}, {&id, 1}, vertices);
    return blocks;
}

/// Returns the depth of one line and triangle.
double depth_of(BundleDepths& depths, const Corners& t, std::uint32_t place) {
    const PassedTriangle passed;
    std::vector<double> found;
    depths.find(block_of(t).view(), {&passed, 1}, {&place, 1}, found);
    return found.at(0);
}

struct Judged {
    int proven = 0;
    int unproven = 0;
    int wrong = 0;
};

/// Calls `judge(triangle, line, depth)` for the lines of a case that pass through a triangle's
/// inside.
template <class Judge>
void for_each_depth(const BundleCase& c, double bound_scale, const Judge& judge) {
    const ObbTree tree = make_tree(mesh_of(c.lines));
    ParallelLines lines;
    if (tree.view().wide.nodes.empty() || !lines.assign(tree.view().wide) ||
        !BundleDepths::suits(c.poses)) {
        return;
    }
    BundleDepths depths(bound_scale);
    depths.restart(c.poses, lines);
    SegmentHit exact(c.poses, HitStage::Integer);
    for (std::uint32_t place = 0; place < lines.slots().size(); ++place) {
        const Segment& line = c.lines[tree.view().wide.triangles.ids[lines.slots()[place]]];
        for (std::uint32_t i = 0; i < c.body.triangles().size(); ++i) {
            const Corners t = c.body.corners(i);
            const auto flags = exact.flags(t, line);
            if (flags && (*flags & hit_flag::crosses) != 0 &&
                (*flags & (hit_flag::edge | hit_flag::corner)) == 0) {
                judge(t, line, depth_of(depths, t, place));
            }
        }
    }
}

void count(const BundleCase& c, double bound_scale, Judged& judged) {
    for_each_depth(c, bound_scale, [&](const Corners& t, const Segment& line, double depth) {
        if (std::isnan(depth)) {
            ++judged.unproven;
            return;
        }
        const auto truth = oracle_hit(t, line, c.poses);
        const mpq_class exact = truth->lambda * mpq_class(oracle_length(line));
        ++judged.proven;
        judged.wrong += depth == oracle_nearest(exact) ? 0 : 1;
    });
}

Judged judged_depths(double bound_scale, std::uint64_t rounds) {
    Judged judged;
    for (const std::string& kind : bundle_kinds()) {
        for (SeededRandom random : seeds(rounds)) {
            count(make_bundle_case(kind, random), bound_scale, judged);
        }
    }
    for (SeededRandom random : seeds(20 * rounds)) {
        BundleCase c{make_sphere(1), {}, {make_pose(random, 0.3), make_pose(random, 0.3)}};
        c.lines = grid_lines(random, random() % 3, {4, 4}, 0.3, 1, {3, -3});
        count(c, bound_scale, judged);
    }
    return judged;
}

} // namespace

TEST(BundleDepths, AreRoundedOnce) {
    const Judged judged = judged_depths(1, raised(5));
    EXPECT_EQ(judged.wrong, 0);
    EXPECT_GT(judged.proven, 2000);
    EXPECT_LT(judged.unproven, judged.proven / 10);
}

TEST(BundleDepths, BoundsThatAreScaledDownAreCaught) {
    EXPECT_GT(judged_depths(0x1p-26, 5).wrong, 0);
}

TEST(BundleDepths, MidwayBetweenTwoDoublesIsRoundedToEven) {
    // The way from 16 to 1 + 2^-52 takes one bit more than a double has.
    int midway = 0;
    for (const double step : {0x1p-52, 0x1p-50, 0x3p-52}) {
        for (const bool is_turned : {false, true}) {
            const double x = 1 + step;
            BundleCase c{make_mesh({Vec3(x, -1, -1), Vec3(x, 1, -1), Vec3(x, 0, 1)}, {{0, 1, 2}}),
                         {{Vec3(16, 0.1, 0.2), Vec3(-16, 0.1, 0.2)}},
                         {}};
            if (is_turned) {
                c.poses.a = c.poses.b = Pose::from_quaternion({1, 1, 0, 0}, Vec3(4, 0.5, -1));
            }
            for_each_depth(c, 1, [&](const Corners& t, const Segment& line, double depth) {
                const auto truth = oracle_hit(t, line, c.poses);
                EXPECT_EQ(depth, oracle_nearest(truth->lambda * mpq_class(32)));
                ++midway;
            });
        }
    }
    EXPECT_EQ(midway, 6);
}

TEST(BundleDepths, AreTheSameOnEveryTarget) {
    std::mt19937_64 random(1);
    BundleCase c{make_sphere(2), {}, {make_pose(random, 0.3), make_pose(random, 0.3)}};
    c.lines = grid_lines(random, 0, {5, 5}, 0.3, 1, {3, -3});
    std::vector<double> expected;
    for_each_depth(
        c, 1, [&](const Corners&, const Segment&, double depth) { expected.push_back(depth); });
    EXPECT_GT(expected.size(), 20u);
    on_every_target([&](SimdTarget) {
        std::vector<double> found;
        for_each_depth(
            c, 1, [&](const Corners&, const Segment&, double depth) { found.push_back(depth); });
        EXPECT_EQ(found, expected);
    });
}

TEST(BundleDepths, ManyAreFoundAtOnce) {
    std::mt19937_64 random(1);
    const ObbTree tree = make_tree(mesh_of(grid_lines(random, 0, {8, 8}, 0.1, 0, {3, -3})));
    ParallelLines lines;
    ASSERT_TRUE(lines.assign(tree.view().wide));
    BundleDepths depths;
    depths.restart({}, lines);
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        TriangleBlockArrays blocks(precision);
        std::vector<PassedTriangle> triangles;
        std::vector<std::uint32_t> places;
        std::vector<double> expected;
        for (std::uint32_t i = 0; i < 20 * block_size; ++i) {
            const double x = -2 + 0.0078125 * i;
            // The plane rises by 1 from y = -9 to 9.
            const std::vector<Vec3> t{Vec3(x, -9, -9), Vec3(x + 1, 9, -9), Vec3(x + 0.5, 0, 18)};
            const Triangle triangle{0, 1, 2};
            const std::uint32_t slot = block_size * blocks.add({&triangle, 1}, {&i, 1}, t);
            triangles.push_back({slot, static_cast<std::uint32_t>(places.size()), 0});
            // One to 64 lines pass through each triangle.
            for (std::uint32_t place = 0; place <= i * i % (i % 3 == 0 ? 64 : 3); ++place) {
                places.push_back((place + i) % 64);
                expected.push_back(depth_of(depths, {t[0], t[1], t[2]}, places.back()));
            }
        }
        std::vector<double> found{7};
        depths.find(blocks.view(), triangles, places, found);
        EXPECT_GT(expected.size(), 5 * DepthsOfMany::lines_most);
        expected.insert(expected.begin(), 7);
        EXPECT_EQ(found, expected);
    }
}

} // namespace cd::tests
