// Batches of pairs and what a stage proves about pairs, for tests of the stages.
#pragma once

#include "common/pair/stages/arbitrary/exact_triangle_pair.hpp"
#include "common/pair/triangle_pair.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace cd::tests {

/// Triangles with unshared corners, and the pairs to test.
struct Batch {
    std::vector<Vec3> vertices_a;
    std::vector<Vec3> vertices_b;
    std::vector<Triangle> triangles;
    std::vector<Candidate> candidates;

    void add(const Corners& a, const Corners& b) {
        const auto place = static_cast<std::uint32_t>(triangles.size());
        triangles.push_back({3 * place, 3 * place + 1, 3 * place + 2});
        vertices_a.insert(vertices_a.end(), a.begin(), a.end());
        vertices_b.insert(vertices_b.end(), b.begin(), b.end());
        candidates.push_back({place, place});
    }
    [[nodiscard]] TriangleSpan a() const { return {vertices_a, triangles}; }
    [[nodiscard]] TriangleSpan b() const { return {vertices_b, triangles}; }
};

/// Number of pairs that a stage classified rightly, wrongly, and as contact.
struct Proofs {
    int right = 0;
    int wrong = 0;
    int of_contact = 0;
};

/// Compares what `decide` returns for 20,000 pairs, where it returns a class, with the exact stage.
template <class Maker, class Decide>
[[nodiscard]] Proofs proofs_of(const Maker& make, const Decide& decide) {
    Proofs proofs;
    for (SeededRandom random : seeds(20'000)) {
        const PosedPair c = make(random);
        if (const std::optional<PairClass> decided = decide(c)) {
            const bool is_right = *decided == ExactTrianglePair(c.poses).classify(c.a, c.b);
            ++(is_right ? proofs.right : proofs.wrong);
            proofs.of_contact += *decided != PairClass::Separate ? 1 : 0;
        }
    }
    return proofs;
}

/// Expects `decide` to be right, where it returns a class, on pairs of tiny and huge numbers, whose
/// products underflow.
template <class Maker, class Decide>
void expect_zero_is_not_assumed(const Maker& make, const Decide& decide) {
    int touching = 0;
    for (SeededRandom random : seeds(3000)) {
        PosedPair c = random.seed % 2 == 0 ? make(random)
                                           : PosedPair{lattice_corners(random, 2),
                                                       lattice_corners(random, 2),
                                                       {Pose(), translation_pose(0, 1, 0)}};
        scale_far_apart(random, c);
        const PairClass expected = ExactTrianglePair(c.poses).classify(c.a, c.b);
        ASSERT_EQ(decide(c).value_or(expected), expected);
        touching += expected == PairClass::Separate ? 0 : 1;
    }
    EXPECT_GT(touching, 100);
}

} // namespace cd::tests
