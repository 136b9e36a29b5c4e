// Proves that hits of lines are decided exactly, whatever the first stage: on random and on hard
// cases all answers equal those of rationals.
#include "common/shots/segment_hit.hpp"

#include "tests/support/hard_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/shot_cases.hpp"
#include "tests/support/shot_oracle.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

constexpr std::array all_stages{
    HitStage::Double, HitStage::DoubleDouble, HitStage::Integer, HitStage::Exact};

std::vector<LineHit> truth_of(const ShotCase& c) {
    return rounded_hits(oracle_hits(c.triangles, c.line, c.poses), c.line);
}

void expect_equal(std::span<const LineHit> found, const std::vector<LineHit>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        SCOPED_TRACE(i);
        ASSERT_EQ(found[i].triangle, expected[i].triangle);
        ASSERT_EQ(found[i].flags, expected[i].flags);
        ASSERT_EQ(found[i].depth, expected[i].depth);
        ASSERT_EQ(found[i].rank, expected[i].rank);
    }
}

void expect_truth(const ShotCase& c, HitStage first) {
    SCOPED_TRACE(to_text(first));
    const std::vector<LineHit> truth = truth_of(c);
    SegmentHit engine(c.poses, first);
    expect_equal(engine.hits(c.triangles, c.line), truth);
    for (std::size_t i = 0; i < std::min<std::size_t>(c.triangles.size(), 12); ++i) {
        const auto flags = engine.flags(c.triangles[i], c.line);
        const auto hit = std::find_if(
            truth.begin(), truth.end(), [&](const LineHit& each) { return each.triangle == i; });
        ASSERT_EQ(flags.has_value(), hit != truth.end());
        ASSERT_TRUE(!flags || *flags == hit->flags);
    }
}

/// One of the triangles under the pose of the identity.
std::size_t crossings(SegmentHit& engine, const std::vector<Corners>& triangles, Segment line) {
    const std::span<const LineHit> hits = engine.hits(triangles, line);
    return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [](const LineHit& hit) {
        return (hit.flags & hit_flag::crosses) != 0;
    }));
}

} // namespace

class SegmentHitTest : public testing::TestWithParam<std::string> {};

TEST_P(SegmentHitTest, AllAnswersAreExactWhateverTheFirstStage) {
    const ShotMaker make = shot_makers().at(GetParam());
    for (SeededRandom random : seeds(raised(12))) {
        const ShotCase c = make(random);
        for (const HitStage first : all_stages) {
            expect_truth(c, first);
        }
        if (HasFatalFailure()) {
            return;
        }
    }
}

TEST(SegmentHit, TheCasesHoldHitsOfEveryKind) {
    std::array<int, 32> seen{};
    for (const auto& [name, make] : shot_makers()) {
        for (SeededRandom random : seeds(40)) {
            for (const OracleHit& hit : [&] {
                     const ShotCase c = make(random);
                     return oracle_hits(c.triangles, c.line, c.poses);
                 }()) {
                ++seen[hit.flags];
            }
        }
    }
    for (const int facing : {hit_flag::front, hit_flag::back}) {
        EXPECT_GT(seen[static_cast<std::size_t>(facing | hit_flag::crosses)], 100);
        for (const int border : {hit_flag::edge, hit_flag::corner}) {
            EXPECT_GT(seen[static_cast<std::size_t>(facing | border)], 10);
            EXPECT_GT(seen[static_cast<std::size_t>(facing | border | hit_flag::crosses)], 10);
        }
    }
    EXPECT_GT(seen[hit_flag::edge], 10);
    EXPECT_GT(seen[hit_flag::corner], 10);
    EXPECT_GT(seen[0], 10); // A segment that starts inside a face and lies in its plane.
}

TEST(SegmentHit, ChainedSegmentsCrossOnce) {
    int in_plane = 0;
    for (SeededRandom random : seeds(raised(400))) {
        const Corners t = lattice_corners(random, 3);
        const Vec3 middle = 0.25 * (t[0] + t[1]) + 0.5 * t[2];
        const Vec3 step = lattice_point(random, 3);
        const PosePair poses{make_pose(random, 2), {}};
        SegmentHit engine({poses.a, poses.a});
        const std::size_t whole = crossings(engine, {t}, {middle - 2 * step, middle + 2 * step});
        const std::size_t chained = crossings(engine, {t}, {middle - 2 * step, middle}) +
                                    crossings(engine, {t}, {middle, middle + 2 * step});
        EXPECT_EQ(chained, whole);
        EXPECT_EQ(crossings(engine, {t}, {middle - 2 * step, middle}), 0u);
        in_plane += static_cast<int>(whole);
    }
    EXPECT_GT(in_plane, 100);
}

TEST(SegmentHit, ASharedEdgeIsCrossedInOneOfTwoTriangles) {
    int crossed = 0;
    for (SeededRandom random : seeds(raised(400))) {
        // The triangles lie on different sides of the plane through the edge and the line.
        const Vec3 a = lattice_point(random, 3);
        const Vec3 b = lattice_point(random, 3);
        const Vec3 step = lattice_point(random, 3);
        const Vec3 middle = 0.5 * (a + b);
        const Vec3 normal = (b - a).cross(step);
        const Vec3 c = lattice_point(random, 4);
        const Vec3 d = lattice_point(random, 4);
        if (!(normal.dot(c - a) > 0 && normal.dot(d - a) < 0)) {
            continue;
        }
        SegmentHit engine({});
        const Segment line{middle - 9 * step, middle + 9 * step};
        const std::vector<Corners> both{{a, b, c}, {b, a, d}};
        EXPECT_EQ(engine.hits(both, line).size(), 2u);
        EXPECT_EQ(crossings(engine, both, line), 1u);
        ++crossed;
    }
    EXPECT_GT(crossed, 20);
}

TEST(SegmentHit, LeavingComesBeforeEnteringAtOneDepth) {
    const Corners entered{Vec3(-1, -1, 0), Vec3(-1, 1, 0), Vec3(1, 0, 0)};
    const Corners left{Vec3(-1, -1, 0), Vec3(1, 0, 0), Vec3(-1, 1, 0)};
    SegmentHit engine({});
    const auto hits = engine.hits(std::vector{entered, left}, {Vec3(0, 0, -1), Vec3(0, 0, 3)});
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].triangle, 1u);
    EXPECT_EQ(hits[0].flags, hit_flag::back | hit_flag::crosses);
    EXPECT_EQ(hits[1].flags, hit_flag::front | hit_flag::crosses);
    EXPECT_EQ(hits[0].depth, 1.0);
    EXPECT_EQ(hits[1].rank, 0);
}

TEST(SegmentHit, RestartForgetsThePoses) {
    std::mt19937_64 random(8);
    SegmentHit reused({});
    for (int i = 0; i < 50; ++i) {
        const ShotCase c = shot_makers().at("random triangles")(random);
        reused.restart(c.poses);
        EXPECT_EQ(reused.statistics(), HitStatistics());
        expect_equal(reused.hits(c.triangles, c.line), truth_of(c));
    }
}

TEST(SegmentHit, CheapStagesDecideOrdinaryHits) {
    std::mt19937_64 random(9);
    HitStatistics statistics;
    std::size_t hits = 0;
    for (int i = 0; i < 200; ++i) {
        const ShotCase c = shot_makers().at("random triangles")(random);
        SegmentHit engine(c.poses);
        hits += engine.hits(c.triangles, c.line).size();
        statistics += engine.statistics();
    }
    EXPECT_EQ(statistics.decisions[0], 2000u);
    EXPECT_EQ(statistics.depths[static_cast<std::size_t>(HitStage::DoubleDouble)], hits);
}

INSTANTIATE_TEST_SUITE_P(,
                         SegmentHitTest,
                         testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const auto& [name, make] : shot_makers()) {
                                 names.push_back(name);
                             }
                             return names;
                         }()),
                         [](const auto& of) {
                             std::string name = of.param;
                             std::replace_if(
                                 name.begin(),
                                 name.end(),
                                 [](char c) { return std::isalnum(c) == 0; },
                                 '_');
                             return name;
                         });

} // namespace cd::tests
