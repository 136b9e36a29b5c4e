// Proves that no answer about a corpus pair is wrong: 200,000 pairs over three ranges of seeds,
// through every interface, SIMD target, first stage, and order of bodies and corners.
#include "common/pair/triangle_pair.hpp"
#include "tests/corpus/categories.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

constexpr std::uint64_t pairs_of_a_range = 1100;
constexpr std::array<std::uint64_t, 3> ranges{0, 1'000'000, std::uint64_t{1} << 40};

struct KnownPair {
    PosedPair pair;
    PairClass expected = PairClass::Separate;
    std::uint64_t seed = 0;
};

std::vector<KnownPair> known_pairs(const std::string& category, std::uint64_t first) {
    std::vector<KnownPair> known;
    for (std::uint64_t seed = first; seed < first + pairs_of_a_range; ++seed) {
        PosedPair pair = corpus_pair(category, seed);
        const PairClass expected = oracle_class(pair.a, pair.b, pair.poses);
        known.push_back({std::move(pair), expected, seed});
    }
    return known;
}

/// Collects the triangles of several pairs.
struct Batch {
    static constexpr std::uint32_t orders = 4;

    std::vector<Vec3> vertices_a;
    std::vector<Vec3> vertices_b;
    std::vector<Triangle> triangles_a;
    std::vector<Triangle> triangles_b;
    std::vector<Candidate> candidates;

    /// Adds the pair with its corners as given and reordered, so that one kind fills a batch.
    void add(const PosedPair& pair) {
        const auto put = [](const Corners& corners, auto& vertices, auto& triangles) {
            const auto first = static_cast<std::uint32_t>(vertices.size());
            vertices.insert(vertices.end(), corners.begin(), corners.end());
            triangles.push_back({first, first + 1, first + 2});
            triangles.push_back({first + 2, first + 1, first});
            return static_cast<std::uint32_t>(triangles.size()) - 2;
        };
        const std::uint32_t a = put(pair.a, vertices_a, triangles_a);
        const std::uint32_t b = put(pair.b, vertices_b, triangles_b);
        for (std::uint32_t i = 0; i < orders; ++i) {
            candidates.push_back({a + i % 2, b + i / 2});
        }
    }
    [[nodiscard]] TriangleSpan a() const { return {vertices_a, triangles_a}; }
    [[nodiscard]] TriangleSpan b() const { return {vertices_b, triangles_b}; }
};

/// Groups pairs of equal poses, for the longest possible batches.
std::vector<std::vector<KnownPair>> by_poses(const std::vector<KnownPair>& known) {
    std::vector<std::vector<KnownPair>> groups(1);
    for (const KnownPair& one : known) {
        if (one.pair.poses == PosePair{}) {
            groups.front().push_back(one);
        } else if (groups.size() > 1 && groups.back().front().pair.poses == one.pair.poses) {
            groups.back().push_back(one);
        } else {
            groups.push_back({one});
        }
    }
    return groups;
}

void expect_batches_right(const std::vector<KnownPair>& group, PairStage first) {
    if (group.empty()) {
        return;
    }
    Batch batch;
    for (const KnownPair& one : group) {
        batch.add(one.pair);
    }
    TrianglePairTest test(group.front().pair.poses, first);
    const std::span<const PairClass> found = test.classify(batch.a(), batch.b(), batch.candidates);
    ASSERT_EQ(found.size(), batch.candidates.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i], group[i / Batch::orders].expected)
            << "seed " << group[i / Batch::orders].seed;
    }
}

} // namespace

class PairTruth : public testing::TestWithParam<std::string> {};

TEST_P(PairTruth, SinglePairsMatchTheOracle) {
    for (const std::uint64_t range : ranges) {
        for (const KnownPair& one : known_pairs(GetParam(), range)) {
            const auto& [a, b, poses] = one.pair;
            ASSERT_EQ(TrianglePairTest(poses).classify(a, b), one.expected) << one.seed;
            const PosePair swapped{poses.b, poses.a};
            ASSERT_EQ(TrianglePairTest(swapped).classify(b, a), one.expected) << one.seed;
        }
    }
}

TEST_P(PairTruth, BatchedPairsMatchTheOracle) {
    for (const std::uint64_t range : ranges) {
        for (const auto& group : by_poses(known_pairs(GetParam(), range))) {
            expect_batches_right(group, PairStage::Float);
        }
    }
}

TEST_P(PairTruth, AnswersDoNotDependOnTheFirstStage) {
    const std::vector<KnownPair> known = known_pairs(GetParam(), ranges[0]);
    const std::vector<KnownPair> some(known.begin(), known.begin() + 200);
    for (std::size_t stage = 0; stage < pair_stage_count; ++stage) {
        SCOPED_TRACE(testing::Message() << "first stage " << stage);
        for (const auto& group : by_poses(some)) {
            expect_batches_right(group, static_cast<PairStage>(stage));
        }
    }
}

TEST_P(PairTruth, WithEverySimdTarget) {
    const std::vector<KnownPair> known = known_pairs(GetParam(), ranges[2]);
    const std::vector<KnownPair> some(known.begin(), known.begin() + 400);
    on_every_target([&](SimdTarget) {
        for (const auto& group : by_poses(some)) {
            expect_batches_right(group, PairStage::Float);
        }
    });
}

TEST_P(PairTruth, ATouchIsFoundJustWhereThereIsOne) {
    for (const KnownPair& one : known_pairs(GetParam(), ranges[1])) {
        Batch batch;
        batch.add(one.pair);
        TrianglePairTest test(one.pair.poses);
        ASSERT_EQ(test.find_touch(batch.a(), batch.b(), batch.candidates).has_value(),
                  one.expected != PairClass::Separate)
            << one.seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, PairTruth, testing::ValuesIn(pair_categories()), test_name);

} // namespace cd::tests
