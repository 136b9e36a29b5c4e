// Proves that float verdicts are true, on ordinary and hard pairs and on those that a search finds
// around the bounds; that smaller bounds fail; and that verdicts are equal bits on every SIMD
// target and in any batch.
#include "common/pair/stages/float/float_triangle_pair.hpp"

#include "tests/common/pair/pair_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

std::vector<FloatVerdict> verdicts_of(const FloatTrianglePair& test, const Batch& batch) {
    std::vector<FloatVerdict> verdicts(batch.candidates.size());
    test.classify(batch.a(), batch.b(), batch.candidates, verdicts);
    return verdicts;
}

FloatVerdict verdict_of(const PosedPair& pair, double bound_scale = 1) {
    Batch batch;
    batch.add(pair.a, pair.b);
    return verdicts_of(FloatTrianglePair(pair.poses, bound_scale), batch).front();
}

/// Unknown is always true.
bool is_true(FloatVerdict verdict, const PosedPair& pair) {
    if (verdict == FloatVerdict::Unknown) {
        return true;
    }
    const PairClass kind = ExactTrianglePair(pair.poses).classify(pair.a, pair.b);
    return kind == (verdict == FloatVerdict::Separate ? PairClass::Separate : PairClass::Proper);
}

struct SearchCounts {
    int decided = 0;
    int wrong = 0;
};

/// Moves nearly touching triangles by small steps through the distances at which floats become
/// certain: errors are largest there relative to the bounds.
SearchCounts search_around_bounds(std::uint64_t seed, int pairs, double bound_scale) {
    std::mt19937_64 random(seed);
    SearchCounts counts;
    for (int i = 0; i < pairs; ++i) {
        const PosedPair start = nearly_touching(random);
        const Vec3 direction = random_point(random, 1);
        for (int exponent = -32; exponent < -16; ++exponent) {
            PosedPair moved = start;
            const double step = std::ldexp(uniform(random, -2, 2), exponent);
            for (Vec3& corner : moved.b) {
                corner += step * direction;
            }
            const FloatVerdict verdict = verdict_of(moved, bound_scale);
            counts.decided += verdict == FloatVerdict::Unknown ? 0 : 1;
            counts.wrong += is_true(verdict, moved) ? 0 : 1;
        }
    }
    return counts;
}

Batch random_batch(std::mt19937_64& random, std::size_t size) {
    Batch batch;
    for (std::size_t i = 0; i < size; ++i) {
        batch.add(random_corners(random, 1), random_corners(random, 1));
    }
    return batch;
}

} // namespace

TEST(FloatTrianglePairs, OnlyProveWhatIsTrueOfHardPairs) {
    for (const auto& [name, make] : pair_makers()) {
        SCOPED_TRACE(name);
        std::mt19937_64 random(11);
        for (int i = 0; i < 400; ++i) {
            const PosedPair pair = make(random);
            ASSERT_TRUE(is_true(verdict_of(pair), pair)) << "pair " << i;
        }
    }
}

TEST(FloatTrianglePairs, OnlyProveWhatIsTrueAroundTheirBounds) {
    const SearchCounts counts = search_around_bounds(12, 1500, 1);
    EXPECT_EQ(counts.wrong, 0);
    // The search crossed the bounds.
    EXPECT_GT(counts.decided, 1500 * 16 / 4);
    EXPECT_LT(counts.decided, 1500 * 16 * 3 / 4);
}

TEST(FloatTrianglePairs, BoundsScaledDownAreCaught) {
    EXPECT_GT(search_around_bounds(12, 1500, 0.03).wrong, 0);
}

TEST(FloatTrianglePairs, EveryTargetGivesTheSameVerdicts) {
    std::mt19937_64 random(13);
    std::vector<std::pair<PosePair, Batch>> all;
    for (const auto& [name, make] : pair_makers()) {
        for (int i = 0; i < 40; ++i) {
            const PosedPair pair = make(random);
            all.push_back({pair.poses, {}});
            all.back().second.add(pair.a, pair.b);
            for (int other = 0; other < 16; ++other) {
                const PosedPair moved = make(random);
                all.back().second.add(moved.a, moved.b);
            }
        }
    }
    for (int i = 0; i < 2000; ++i) {
        const PosedPair pair = nearly_touching(random);
        all.push_back({pair.poses, {}});
        for (int exponent = -30; exponent < -17; ++exponent) {
            const Vec3 step = random_point(random, std::ldexp(1.0, exponent));
            all.back().second.add(pair.a, {pair.b[0] + step, pair.b[1] + step, pair.b[2] + step});
        }
    }
    const auto run = [&] {
        std::vector<FloatVerdict> verdicts;
        for (const auto& [poses, batch] : all) {
            const auto some = verdicts_of(FloatTrianglePair(poses), batch);
            verdicts.insert(verdicts.end(), some.begin(), some.end());
        }
        return verdicts;
    };
    const std::vector<FloatVerdict> expected = run();
    on_every_target([&](SimdTarget) { EXPECT_EQ(run(), expected); });
}

TEST(FloatTrianglePairs, AVerdictDoesNotDependOnTheBatch) {
    on_every_target([](SimdTarget) {
        std::mt19937_64 random(14);
        const PosePair poses{make_pose(random, 0.3), make_pose(random, 0.3)};
        const FloatTrianglePair test(poses);
        const Batch batch = random_batch(random, 200);
        const auto expected = verdicts_of(test, batch);
        for (std::size_t size = 0; size <= batch.candidates.size(); ++size) {
            // One extra element shows that nothing is written past the end.
            std::vector<FloatVerdict> verdicts(size + 1, FloatVerdict{77});
            const auto begin = batch.candidates.end() - static_cast<std::ptrdiff_t>(size);
            test.classify(batch.a(),
                          batch.b(),
                          {begin, batch.candidates.end()},
                          std::span(verdicts).first(size));
            EXPECT_TRUE(std::equal(expected.end() - static_cast<std::ptrdiff_t>(size),
                                   expected.end(),
                                   verdicts.begin()));
            EXPECT_EQ(verdicts.back(), FloatVerdict{77});
        }
    });
}

TEST(FloatTrianglePairs, SharedCornersAndRepeatedTrianglesAreAllowed) {
    std::mt19937_64 random(15);
    const Mesh sphere = make_sphere(2);
    const TriangleSpan span{sphere.vertices(), sphere.triangles()};
    const PosePair poses{make_pose(random, 0.3), make_pose(random, 0.3)};
    const FloatTrianglePair test(poses);
    std::vector<Candidate> candidates;
    for (int i = 0; i < 500; ++i) {
        candidates.push_back({static_cast<std::uint32_t>(random() % span.triangles.size()),
                              static_cast<std::uint32_t>(random() % span.triangles.size())});
        candidates.resize(candidates.size() + random() % 3, candidates.back());
    }
    std::vector<FloatVerdict> verdicts(candidates.size());
    test.classify(span, span, candidates, verdicts);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const PosedPair pair{
            span.corners_at(candidates[i].a), span.corners_at(candidates[i].b), poses};
        EXPECT_EQ(verdicts[i], verdict_of(pair));
    }
}

TEST(FloatTrianglePairs, OrdinaryPairsAreDecided) {
    std::mt19937_64 random(16);
    const FloatTrianglePair test({make_pose(random, 0.3), make_pose(random, 0.3)});
    const auto verdicts = verdicts_of(test, random_batch(random, 20'000));
    const auto count = [&](FloatVerdict verdict) {
        return std::count(verdicts.begin(), verdicts.end(), verdict);
    };
    EXPECT_LE(count(FloatVerdict::Unknown), 20);
    EXPECT_GT(count(FloatVerdict::Separate), 4'000);
    EXPECT_GT(count(FloatVerdict::Proper), 2'000);
}

TEST(FloatTrianglePairs, FarFromTheOriginTheyDecideAsWell) {
    std::mt19937_64 random(17);
    const Vec3 far(5e5, -4e6, 100); // Metres of a map grid.
    Batch batch = random_batch(random, 2'000);
    for (std::vector<Vec3>* vertices : {&batch.vertices_a, &batch.vertices_b}) {
        std::ranges::for_each(*vertices, [&](Vec3& vertex) { vertex += far; });
    }
    const auto verdicts = verdicts_of(FloatTrianglePair(PosePair{}), batch);
    EXPECT_LE(std::count(verdicts.begin(), verdicts.end(), FloatVerdict::Unknown), 2);
}

TEST(FloatTrianglePairs, MirroredPosesAreDecidedCorrectly) {
    std::mt19937_64 random(18);
    Mat3 mirror = Mat3::Identity();
    mirror(1, 1) = -1;
    mirror(0, 2) = 0.25;
    const PosePair poses{Pose::from_matrix(mirror, Vec3(0.1, 0, 0)), make_pose(random, 0.3)};
    int decided = 0;
    for (int i = 0; i < 500; ++i) {
        const PosedPair pair{random_corners(random, 1), random_corners(random, 1), poses};
        const FloatVerdict verdict = verdict_of(pair);
        decided += verdict == FloatVerdict::Unknown ? 0 : 1;
        EXPECT_TRUE(is_true(verdict, pair));
    }
    EXPECT_GE(decided, 498);
}

TEST(FloatTrianglePairs, NothingIsKnownBeyondTheRangeOfFloats) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const Corners a{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const Corners b{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 2)};
    const Corners c{Vec3(0.2, 0.2, -1), Vec3(0.3, 0.2, 1), Vec3(0.2, 0.3, 1)};
    ASSERT_EQ(verdict_of({a, b, {}}), FloatVerdict::Separate);
    ASSERT_EQ(verdict_of({a, c, {}}), FloatVerdict::Proper);
    on_every_target([&](SimdTarget) {
        for (const double bad : {nan, infinity, -infinity, 1e308, -1e308, 1e39, 1e30, 1e12}) {
            for (const Corners& other : {b, c}) {
                for (std::size_t place = 0; place < 18; ++place) {
                    PosedPair pair{a, other, {}};
                    Corners& spoilt = place < 9 ? pair.a : pair.b;
                    spoilt[place % 9 / 3][static_cast<int>(place % 3)] = bad;
                    EXPECT_EQ(verdict_of(pair), FloatVerdict::Unknown) << bad << " at " << place;
                }
            }
        }
        for (const double scale : {1e-15, 1e-40, 0x1p-1074, 1e15, 1e40, 0x1p1000}) {
            PosedPair pair{a, b, {}};
            for (Corners* corners : {&pair.a, &pair.b}) {
                for (Vec3& corner : *corners) {
                    corner *= scale;
                }
            }
            EXPECT_EQ(verdict_of(pair), FloatVerdict::Unknown) << scale;
        }
    });
}

TEST(FloatTrianglePairs, NothingIsKnownUnderPosesWithoutBounds) {
    const Corners a{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const Corners b{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 2)};
    Mat3 flat = Mat3::Identity();
    flat(2, 2) = 0;
    const Pose plain;
    for (const PosePair& poses :
         {PosePair{Pose::from_matrix(flat, Vec3::Zero()), plain},
          PosePair{Pose::from_matrix(Mat3::Identity() * 1e-300, Vec3::Zero()), plain},
          PosePair{plain, Pose::from_matrix(Mat3::Identity() * 1e300, Vec3::Zero())},
          PosePair{plain, translation_pose(1e300, 0, 0)}}) {
        EXPECT_EQ(verdict_of({a, b, poses}), FloatVerdict::Unknown);
    }
}

TEST(FloatTrianglePairs, TheyDecideFirstAndChangeNoAnswer) {
    std::mt19937_64 random(19);
    const PosePair poses{make_pose(random, 0.3), make_pose(random, 0.3)};
    const Batch batch = random_batch(random, 3'000);
    TrianglePairTest with(poses);
    TrianglePairTest without(poses, PairStage::Double);
    const auto kinds = with.classify(batch.a(), batch.b(), batch.candidates);
    const auto expected = without.classify(batch.a(), batch.b(), batch.candidates);

    EXPECT_TRUE(std::equal(kinds.begin(), kinds.end(), expected.begin(), expected.end()));
    EXPECT_EQ(with.statistics().total(), 3'000u);
    EXPECT_GE(with.statistics()[PairStage::Float], 2'990u);
    EXPECT_EQ(without.statistics()[PairStage::Float], 0u);
}

TEST(FloatTrianglePairs, AProofOfContactSkipsTheOtherStages) {
    const Corners a{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const Corners through{Vec3(0.2, 0.2, -1), Vec3(0.3, 0.2, 1), Vec3(0.2, 0.3, 1)};
    Batch batch;
    for (int i = 0; i < 8; ++i) { // A smaller batch would start with doubles.
        batch.add(a, a);          // Floats cannot prove anything here.
    }
    batch.add(a, through);
    TrianglePairTest test(PosePair{});

    EXPECT_EQ(test.find_touch(batch.a(), batch.b(), batch.candidates), 8u);
    EXPECT_EQ(test.statistics().total(), test.statistics()[PairStage::Float]);
}

} // namespace cd::tests
