// Proves that the error bounds of the stages of hits are sufficient and needed: what a stage proves
// is true, and is not always true if the bounds are scaled down.
#include "common/shots/segment_length.hpp"
#include "common/shots/stages/double/double_hit.hpp"
#include "common/shots/stages/double_double/double_double_depth.hpp"
#include "tests/support/distance_oracle.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/shot_cases.hpp"
#include "tests/support/shot_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

/// Number of answers, and of those that are wrong.
struct Judged {
    int proven = 0;
    int wrong = 0;
};

/// Calls `judge(case, triangle, the truth)` for the triangles of all kinds of cases.
template <class Judge>
void for_each_triangle(std::uint64_t rounds, const Judge& judge) {
    for (const auto& [name, make] : shot_makers()) {
        for (SeededRandom random : seeds(rounds)) {
            const ShotCase c = make(random);
            for (std::size_t i = 0; i < std::min<std::size_t>(c.triangles.size(), 10); ++i) {
                judge(c, c.triangles[i], oracle_hit(c.triangles[i], c.line, c.poses));
            }
        }
    }
}

Judged judged_decisions(double bound_scale, std::uint64_t rounds) {
    Judged judged;
    for_each_triangle(rounds, [&](const ShotCase& c, const Corners& t, const auto& truth) {
        const auto made = DoubleHit(c.poses, bound_scale).decide(t, c.line);
        if (!made || made->how == HitDecision::How::InPlane) {
            return;
        }
        ++judged.proven;
        const bool is_hit = made->how == HitDecision::How::Through;
        const bool is_right =
            is_hit == truth.has_value() && (!is_hit || made->flags == truth->flags);
        judged.wrong += is_right ? 0 : 1;
    });
    return judged;
}

Judged judged_depths(double bound_scale, std::uint64_t rounds) {
    Judged judged;
    for_each_triangle(rounds, [&](const ShotCase& c, const Corners& t, const auto& truth) {
        constexpr int through = hit_flag::front | hit_flag::back;
        if (!truth || (truth->flags & through) == 0) {
            return;
        }
        const double length = oracle_length(c.line);
        DoubleDoubleDepth stage(c.poses, bound_scale);
        stage.set_line(c.line, length);
        if (const auto depth = stage.depth(t)) {
            ++judged.proven;
            judged.wrong += *depth == oracle_nearest(truth->lambda * mpq_class(length)) ? 0 : 1;
        }
    });
    return judged;
}

} // namespace

TEST(HitBounds, WhatDoublesProveIsTrue) {
    const Judged judged = judged_decisions(1, raised(10));
    EXPECT_EQ(judged.wrong, 0);
    EXPECT_GT(judged.proven, 500);
}

TEST(HitBounds, RoundedDepthsAreTrue) {
    const Judged judged = judged_depths(1, raised(20));
    EXPECT_EQ(judged.wrong, 0);
    EXPECT_GT(judged.proven, 200);
}

TEST(HitBounds, BoundsThatAreScaledDownAreCaught) {
    EXPECT_GT(judged_decisions(0.03, 20).wrong, 0);
    EXPECT_GT(judged_depths(0x1p-22, 20).wrong, 0);
}

TEST(SegmentLength, IsRoundedOnce) {
    int irrational = 0;
    for (SeededRandom random : seeds(raised(3000))) {
        const double scale = std::ldexp(1.0, static_cast<int>(random() % 2040) - 1060);
        const bool is_whole = random() % 3 == 0;
        const Vec3 p = is_whole ? lattice_point(random, 9) : random_point(random, 1);
        const Vec3 q = is_whole ? lattice_point(random, 9) : random_point(random, 1);
        const Segment line{scale * p, scale * q};
        ASSERT_EQ(segment_length(line), oracle_length(line)) << line.p << line.q;
        irrational += is_whole ? 0 : 1;
    }
    EXPECT_GT(irrational, 1000);
    EXPECT_EQ(segment_length({Vec3(1, 2, 3), Vec3(1, 2, 3)}), 0.0);
    EXPECT_EQ(segment_length({Vec3(0, 1, 0), Vec3(0, 1, -7)}), 7.0);
    EXPECT_EQ(segment_length({Vec3(1e308, 0, 0), Vec3(-1e308, 0, 0)}),
              std::numeric_limits<double>::max());
}

} // namespace cd::tests
