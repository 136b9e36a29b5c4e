// Proves that the comparison of shot lines finds missing and doubled hits, forgives another choice
// among triangles that share a point, and that the oracle refuses wrong hits of ours.
#include "bench/peers/shots/judge.hpp"

#include "bench/peers/shots/shot_scenes.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {
namespace {

using namespace cd::bench;

/// Our hits on line 0: triangles 1 and 2 share the first point, of which 1 crosses; 3 crosses at
/// the second point.
const std::vector<ShotHit> ours{{0, 1, 1.0, hit_flag::crosses | hit_flag::edge, 0},
                                {0, 2, 1.0, hit_flag::edge, 0},
                                {0, 3, 2.0, hit_flag::crosses, 0}};

HitErrors errors_of(const std::vector<std::uint32_t>& triangles) {
    std::vector<ShotHit> theirs;
    for (const std::uint32_t triangle : triangles) {
        theirs.push_back({0, triangle, 0, 0, 0});
    }
    return compare_hits(ours, theirs);
}

TEST(ShotJudge, OneHitAtEachCrossingIsRight) {
    EXPECT_TRUE(errors_of({1, 3}).is_none());
    EXPECT_TRUE(errors_of({3, 2}).is_none()) << "another triangle of the same point";
}

TEST(ShotJudge, CountsMissingAndDoubledHits) {
    EXPECT_EQ(errors_of({1}).missing, 1);
    EXPECT_EQ(errors_of({1}).doubled, 0);
    EXPECT_EQ(errors_of({1, 2, 3}).doubled, 1) << "both triangles of an edge";
    EXPECT_EQ(errors_of({1, 3, 3}).doubled, 1) << "a triangle that is told twice";
    EXPECT_EQ(errors_of({1, 3, 9}).doubled, 1) << "a triangle that the line does not meet";
    EXPECT_EQ(errors_of({9}).missing, 2);
}

TEST(ShotJudge, PointsOfOneRoundedDepthAreApartByRank) {
    const std::vector<ShotHit> close{{0, 1, 1.0, hit_flag::crosses, 0},
                                     {0, 2, 1.0, hit_flag::crosses, 1}};

    EXPECT_EQ(compare_hits(close, std::span(close).first(1)).missing, 1);
}

TEST(ShotJudge, HitsAreFoundByLine) {
    const HitsByLine hits({{2, 5, 1.0}, {0, 7, 3.0}, {2, 4, 0.5}}, 4);

    ASSERT_EQ(hits.lines(), 4);
    EXPECT_EQ(hits.of(0).size(), 1);
    EXPECT_TRUE(hits.of(1).empty());
    ASSERT_EQ(hits.of(2).size(), 2);
    EXPECT_EQ(hits.of(2)[0].triangle, 4) << "the nearest first";
    EXPECT_TRUE(hits.of(3).empty());
}

/// What our engine finds on a sphere with lines through its vertices, and on a grid.
TEST(ShotJudge, TheOracleAgreesWithOursAndRefusesChangedHits) {
    const ShotTarget sphere{"sphere", share(as_floats(make_sphere(2)))};
    for (const ShotScene& scene :
         {grid_scene(sphere, 50), vertex_scene(sphere, 60), edge_scene(sphere, 60)}) {
        SCOPED_TRACE(scene.kind);
        EXPECT_TRUE(scene.is_closed);
        EXPECT_EQ(world_lines(scene).size(), scene.line_count());
        std::vector<ShotHit> found;
        const auto body = our_shots().make_body();
        body->load(scene);
        body->shoot(found);
        const HitsByLine hits(found, scene.line_count());
        const std::vector<PosedLine> lines = posed_lines(scene);
        std::uint64_t met = 0;
        for (std::uint32_t line = 0; line < hits.lines(); ++line) {
            const auto mine = hits.of(line);
            ASSERT_TRUE(is_right(*scene.mesh, lines[line], mine, {})) << line;
            if (!mine.empty()) {
                ++met;
                EXPECT_FALSE(is_right(*scene.mesh, lines[line], mine.subspan(1), mine));
                std::vector<ShotHit> changed(mine.begin(), mine.end());
                changed[0].flags ^= hit_flag::crosses;
                EXPECT_FALSE(is_right(*scene.mesh, lines[line], changed, {}));
            }
        }
        EXPECT_GE(met, 20) << "lines that meet the sphere";
    }
}

} // namespace
} // namespace cd::tests
