// Proves that each stage of the decision returns only true answers: on every kind of hard pair and
// from any stage on, the answer is the oracle's; that the bounds of the double and double-double
// stages are needed; and that pairs settle in the expected stages.
#include "common/pair/poses/plain_poses.hpp"
#include "tests/common/pair/pair_batch.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/proven_class.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace cd::tests {

namespace {

constexpr std::array later_stages{PairStage::Double,
                                  PairStage::Lattice,
                                  PairStage::DoubleDouble,
                                  PairStage::WideInteger,
                                  PairStage::Arbitrary};

PairClass from_stage(PairStage first, const PosedPair& c) {
    return TrianglePairTest(c.poses, first).classify(c.a, c.b);
}

/// Counts what doubles prove.
template <class Maker>
Proofs double_proofs(const Maker& make, double bound_scale) {
    return proofs_of(
        make, [&](const PosedPair& c) { return proven_in_double(c.poses, c.a, c.b, bound_scale); });
}

/// Writes one rotation in two ways that double-double rounds differently, for triangles that share
/// a corner, an edge or a plane; B is moved by far less than doubles resolve.
PosedPair tie_that_is_moved_a_little(std::mt19937_64& random) {
    const auto digit = [&] { return static_cast<double>(random() % 2001) - 1000; };
    const Quaternion q{digit(), digit(), digit(), 1 + digit() * digit()};
    const double factor = 3 + 2 * static_cast<double>(random() % 5);
    const auto shift = [&] {
        return random() % 2 == 0
                   ? 0
                   : std::ldexp(digit() / 1000, -95 - static_cast<int>(random() % 20));
    };
    PosedPair c;
    c.a = random() % 2 == 0 ? random_corners(random, 1) : lattice_corners(random, 3);
    c.b = random() % 2 == 0 ? random_corners(random, 1) : lattice_corners(random, 3);
    for (std::size_t shared = random() % 3; shared-- > 0;) {
        c.b[random() % 3] = c.a[shared];
    }
    c.poses.a = Pose::from_quaternion(q, Vec3::Zero());
    c.poses.b = Pose::from_quaternion({factor * q.w, factor * q.x, factor * q.y, factor * q.z},
                                      Vec3(shift(), shift(), shift()));
    return c;
}

} // namespace

TEST(PairStages, AllGiveTheOraclesAnswerOnEveryKindOfPair) {
    for (const auto& [name, make] : pair_makers()) {
        for (std::uint64_t seed = 5000; seed < 5060; ++seed) {
            SCOPED_TRACE(testing::Message() << name << ", seed " << seed);
            std::mt19937_64 random(seed);
            const PosedPair c = make(random);
            const PairClass expected = oracle_class(c.a, c.b, c.poses);
            for (const PairStage first : later_stages) {
                ASSERT_EQ(from_stage(first, c), expected) << to_text(first);
            }
            const auto in_double = proven_in_double(c.poses, c.a, c.b);
            ASSERT_EQ(in_double.value_or(expected), expected);
            const auto in_double_double = proven_in_double_double(c.poses, c.a, c.b);
            ASSERT_EQ(in_double_double.value_or(expected), expected);
        }
    }
}

TEST(PairStages, TheBoundsOfDoubleAreNeeded) {
    const Proofs proofs = double_proofs(nearly_touching, 1);
    EXPECT_EQ(proofs.wrong, 0);
    // Most pairs are near the limit of what can be proven.
    EXPECT_GT(proofs.right, 20'000 / 5);
    EXPECT_LT(proofs.right, 20'000 * 4 / 5);
    EXPECT_GT(double_proofs(nearly_touching, 0.03).wrong, 10);
}

TEST(PairStages, DoublesProveTiesAlongTheAxisOfATurnAndOnlyThose) {
    const Proofs proofs = double_proofs(turned_about_an_axis, 1);
    EXPECT_EQ(proofs.wrong, 0);
    EXPECT_GT(proofs.right, 10'000);
    EXPECT_GT(double_proofs(turned_about_an_axis, 0.03).wrong, 10);
}

TEST(PairStages, TurnsAboutAnAxisGetTheOraclesAnswer) {
    for (SeededRandom random : seeds(1000)) {
        const PosedPair c = turned_about_an_axis(random);
        const PairClass expected = oracle_class(c.a, c.b, c.poses);
        for (const PairStage first : later_stages) {
            ASSERT_EQ(from_stage(first, c), expected) << to_text(first);
        }
    }
}

TEST(PairStages, TinyAndHugeValuesAreNotTakenForZero) {
    expect_zero_is_not_assumed(turned_about_an_axis, [](const PosedPair& c) {
        return proven_in_double(c.poses, c.a, c.b);
    });
    expect_zero_is_not_assumed(turned_about_an_axis, [](const PosedPair& c) {
        return std::optional(from_stage(PairStage::Double, c));
    });
}

TEST(PairStages, TheBoundsOfDoubleDoubleAreNeeded) {
    const auto proofs_with = [](double bound_scale) {
        return proofs_of(tie_that_is_moved_a_little, [&](const PosedPair& c) {
            return proven_in_double_double(c.poses, c.a, c.b, bound_scale);
        });
    };
    const Proofs proofs = proofs_with(1);
    EXPECT_EQ(proofs.wrong, 0);
    EXPECT_GT(proofs.right, 5'000);
    // Bounds by largest components are thousands of times the observed errors, at no cost: nominal
    // touches are further still from a tie.
    EXPECT_GT(proofs_with(0x1p-15).wrong, 10);
}

TEST(PairStages, IntegersDecideAsUnlimitedOnesWhereverTheyReach) {
    // Coordinates with exponents as far apart as `spread` need every number of words in turn, and
    // finally more than exist.
    int beyond = 0;
    for (int spread = 0; spread < 1200; spread += 3) {
        SCOPED_TRACE(testing::Message() << "spread " << spread);
        std::mt19937_64 random(static_cast<std::uint64_t>(spread));
        PosedPair c{lattice_corners(random, 2), lattice_corners(random, 2), {}};
        for (Corners* corners : {&c.a, &c.b}) {
            for (Vec3& corner : *corners) {
                const int axis = static_cast<int>(random() % 3);
                corner[axis] += std::ldexp(static_cast<double>(random() % 3), -spread);
                corner = Vec3(corner * std::ldexp(1.0, static_cast<int>(random() % 2) * -spread));
            }
        }
        if (spread % 2 == 0) {
            c.poses = {make_matrix_pose(random, 1), make_pose(random, 1)};
        }
        const auto decided = decided_in_integers(c.poses, c.a, c.b);
        const PairClass expected = ExactTrianglePair(c.poses).classify(c.a, c.b);
        ASSERT_EQ(decided.value_or(expected), expected);
        ASSERT_EQ(expected, oracle_class(c.a, c.b, c.poses));
        beyond += decided ? 0 : 1;
    }
    EXPECT_GT(beyond, 0);
    EXPECT_LT(beyond, 200);
}

TEST(PairStages, EarlierPairsChangeNoAnswer) {
    // Use one test object for many pairs, of all scales.
    std::mt19937_64 random(17);
    const PosePair poses{translation_pose(0.1, 0, 3), translation_pose(-0.7, 1e-3, 0)};
    TrianglePairTest test(poses, PairStage::Lattice);
    for (int round = 0; round < 600; ++round) {
        const double step =
            std::ldexp(round % 3 == 0 ? 0.1 : 1.0, static_cast<int>(random() % 90) - 70);
        PosedPair c{lattice_corners(random, 3), lattice_corners(random, 3), poses};
        for (Corners* corners : {&c.a, &c.b}) {
            for (Vec3& corner : *corners) {
                corner *= step;
            }
        }
        ASSERT_EQ(test.classify(c.a, c.b), oracle_class(c.a, c.b, poses)) << round;
    }
    EXPECT_EQ(test.statistics()[PairStage::Lattice], 600u);
}

TEST(PairStages, NeitherScaleNorAxesNorOrderChangeAnAnswer) {
    for (const auto& [name, make] : pair_makers()) {
        for (std::uint64_t seed = 7000; seed < 7040; ++seed) {
            SCOPED_TRACE(testing::Message() << name << ", seed " << seed);
            std::mt19937_64 random(seed);
            const PosedPair c = make(random);
            const PairClass expected = oracle_class(c.a, c.b, c.poses);
            const PosedPair swapped{
                {c.b[2], c.b[0], c.b[1]}, {c.a[1], c.a[0], c.a[2]}, {c.poses.b, c.poses.a}};
            ASSERT_EQ(from_stage(PairStage::Float, swapped), expected);
            for (const PairStage first : later_stages) {
                ASSERT_EQ(from_stage(first, swapped), expected) << to_text(first);
                if (c.poses == PosePair{}) {
                    PosedPair turned = c;
                    for (Corners* corners : {&turned.a, &turned.b}) {
                        for (Vec3& x : *corners) {
                            x = Vec3(x.y(), -x.z(), x.x());
                        }
                    }
                    ASSERT_EQ(from_stage(first, turned), expected) << to_text(first);
                }
            }
        }
    }
}

TEST(PairStages, DoublesProveTiesOfFacesAlongTheAxes) {
    // A face of one box on a face of another, in coordinates that no double represents.
    const Corners lid{Vec3(0.1, 0.1, 0.3), Vec3(0.7, 0.1, 0.3), Vec3(0.7, 0.7, 0.3)};
    const Corners floor{Vec3(0.3, 0.2, 0.3), Vec3(0.9, 0.2, 0.3), Vec3(0.9, 0.8, 0.3)};
    const Corners wall{Vec3(0.6, 0.2, 0.3), Vec3(0.6, 0.5, 0.3), Vec3(0.6, 0.5, 0.9)};

    EXPECT_EQ(proven_in_double({}, lid, floor), PairClass::Coplanar);
    EXPECT_EQ(proven_in_double({}, lid, wall), PairClass::Touch);
}

TEST(PairStages, EachPairCountsForTheHighestStageThatItNeeded) {
    const Corners a{Vec3(0.1, 0.2, 0.3), Vec3(1.3, 0.4, 0.9), Vec3(0.2, 1.7, 0.6)};
    const Corners same{a[1], a[2], Vec3(3, 3, 3)};
    std::mt19937_64 random(5);
    const Pose turned = make_pose(random, 1);
    const auto settles_in =
        [](PairStage stage, const PosePair& poses, const Corners& l, const Corners& r) {
            TrianglePairTest test(poses);
            static_cast<void>(test.classify(l, r));
            return test.statistics()[stage] == 1 && test.statistics().total() == 1;
        };

    EXPECT_TRUE(settles_in(
        PairStage::Double, {turned, Pose{}}, a, {Vec3(28, 0, 0), Vec3(29, 0, 0), Vec3(28, 1, 1)}));
    // A corner on the other's face, up to roundings.
    const Pose other = make_pose(random, 1);
    const Vec3 inside = other.rotation().transpose() *
                        (turned.apply(Vec3((a[0] + a[1] + a[2]) / 3)) - other.translation());
    EXPECT_TRUE(settles_in(PairStage::DoubleDouble,
                           {turned, other},
                           a,
                           {inside, inside + Vec3(1, 0, 0), inside + Vec3(0, 1, 0.1)}));
    // A tie of four corners, invisible on any three axes.
    EXPECT_TRUE(settles_in(PairStage::Lattice, {}, a, {a[0] + a[1] - a[2], a[2], a[1]}));
    EXPECT_TRUE(settles_in(PairStage::Lattice, {turned, turned}, a, {a[1], a[0], a[2]}));
    // The body's position is unchanged, but its quaternion is twice as long.
    const Quaternion q = turned.quaternion();
    const Pose longer =
        Pose::from_quaternion({2 * q.w, 2 * q.x, 2 * q.y, 2 * q.z}, turned.translation());
    EXPECT_TRUE(settles_in(PairStage::WideInteger, {turned, longer}, a, same));
    Corners spread = a;
    spread[1].x() = 0x1p1000;
    spread[2].x() = 0x1p-1074;
    EXPECT_TRUE(settles_in(PairStage::Arbitrary, {turned, longer}, spread, spread));
}

TEST(PairStages, SkippedStagesSettleNothing) {
    for (SeededRandom random : seeds(300)) {
        const PosedPair c = nearly_touching(random);
        for (const PairStage first : later_stages) {
            TrianglePairTest test(c.poses, first);
            static_cast<void>(test.classify(c.a, c.b));
            ASSERT_EQ(test.statistics().total(), 1u);
            for (std::size_t stage = 0; stage < static_cast<std::size_t>(first); ++stage) {
                ASSERT_EQ(test.statistics().settled[stage], 0u) << to_text(first);
            }
        }
    }
}

TEST(PairStages, PlainPosesKeepEveryAnswer) {
    for (const auto& [name, make] : pair_makers()) {
        for (SeededRandom random : seeds(30, 9000)) {
            const PosedPair c = make(random);
            EXPECT_EQ(oracle_class(c.a, c.b, plain_poses(c.poses)), oracle_class(c.a, c.b, c.poses))
                << name;
        }
    }
}

TEST(PairStages, PosesWithoutEffectBecomeTheIdentity) {
    std::mt19937_64 random(1);
    const Pose turned = make_pose(random, 5);
    EXPECT_EQ(plain_poses({turned, turned}), PosePair{});
    // Flattened bodies must stay flat.
    const Pose flat = Pose::from_matrix(Vec3(1, 1, 0).asDiagonal(), Vec3::Zero());
    EXPECT_EQ(plain_poses({flat, flat}), (PosePair{flat, flat}));

    // A short rotation leaves a translation that doubles represent.
    const auto by_345 = [](double x, double y, double z) {
        return Pose::from_quaternion({3, 0, 0, 1}, Vec3(x, y, z));
    };
    EXPECT_EQ(plain_poses({by_345(5, 0, 0), by_345(15, 5, 1)}),
              (PosePair{Pose{}, translation_pose(11, -2, 1)}));
    EXPECT_EQ(plain_poses({by_345(5, 0, 0), by_345(6, 0, 1)}).b.kind(), Pose::Kind::Quaternion);

    const double half = 0.70710678118654752;
    const Pose quarter = Pose::from_quaternion({half, 0, 0, half}, Vec3(1, 2, 3));
    const PosePair plain = plain_poses({translation_pose(1, 1, 1), quarter});
    EXPECT_EQ(plain.a, Pose{});
    EXPECT_EQ(plain.b.kind(), Pose::Kind::Matrix);
    EXPECT_EQ(plain.b.translation(), Vec3(0, 1, 2));
    EXPECT_EQ(Vec3(plain.b.matrix() * Vec3(1, 0, 0)), Vec3(0, 1, 0));
}

} // namespace cd::tests
