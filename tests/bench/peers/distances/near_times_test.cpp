// Proves that searches with a clearance are timed round by round, and the float stage of their
// decisions on every SIMD target with the candidates that the clearance gives.
#include "bench/peers/distances/near_times.hpp"

#include "bench/accuracy/suites/sources.hpp"
#include "common/geometry/simd_target.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {
namespace {

using namespace cd::bench;

TEST(NearTimes, MeasuresEveryTargetOnTheSameCandidates) {
    const Scene scene = torus_scene(4);
    const SimdTarget before = simd_target();

    const std::vector<NearFloats> rows = measure_near_floats(scene, 0.01, 2);

    ASSERT_EQ(rows.size(), available_simd_targets().size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].target, to_text(available_simd_targets()[i]));
        EXPECT_EQ(rows[i].candidates, rows[0].candidates);
        EXPECT_GT(rows[i].candidate_ns, 0);
        EXPECT_LT(10 * rows[i].unknown, rows[i].candidates);
    }
    EXPECT_EQ(simd_target(), before);
}

TEST(NearTimes, TakesMoreCandidatesWithALargerClearance) {
    const Scene scene = torus_scene(4);

    const std::vector<NearFloats> less = measure_near_floats(scene, 0.001, 1);
    const std::vector<NearFloats> more = measure_near_floats(scene, 0.1, 1);

    EXPECT_GT(less[0].candidates, 0);
    EXPECT_GT(more[0].candidates, less[0].candidates);
}

TEST(NearTimes, TheMedianRoundIsNoQuickerThanTheQuickest) {
    const Scene scene = torus_scene(4);
    NearQueries queries(scene, 0.01);

    queries.run(3);
    queries.run(2);

    EXPECT_EQ(queries.rounds(), 5);
    EXPECT_GT(queries.quickest_round(), 0);
    EXPECT_GE(queries.median_round(), queries.quickest_round());
}

} // namespace
} // namespace cd::tests
