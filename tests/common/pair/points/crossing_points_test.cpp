// Proves that the points of many pairs at once are the exact ones, rounded once, on every SIMD
// target, in any batch; that their error bounds are needed; and that pairs of ordinary scenes have
// them.
#include "common/pair/points/crossing/crossing_points.hpp"

#include "common/pair/points/shared_points.hpp"
#include "tests/common/pair/points/middle_pairs.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, const Vec3& v) {
    for (int k = 0; k < 3; ++k) {
        bits.push_back(std::bit_cast<std::uint64_t>(v[k]));
    }
}

Bits bits_of(const Vec3& origin, std::span<const Vec3> points) {
    Bits bits;
    add(bits, origin);
    for (const Vec3& point : points) {
        add(bits, point);
    }
    return bits;
}

/// Returns the bits of the origin and points of each pair; none for pairs without an answer.
std::vector<Bits> found_together(CrossingPoints& crossings, std::span<const PairCorners> pairs) {
    std::vector<Bits> all;
    crossings.compute(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        all.push_back(crossings.is_proven(i) ? bits_of(crossings.origin(i), crossings.ends(i))
                                             : Bits());
    }
    return all;
}

Bits exact_bits(SharedPoints& exact, const PairCorners& pair) {
    const Vec3 origin = exact.origin(pair.a);
    return bits_of(origin, exact.points(pair.a, pair.b));
}

/// Returns the pair eight times, with its corners in other orders.
std::vector<PairCorners> in_all_orders(const PosedPair& c) {
    std::vector<PairCorners> all;
    for (std::size_t i = 0; i < CrossingPoints::pairs_max; ++i) {
        const auto order = [](const Corners& t, std::size_t first, bool is_mirrored) {
            return Corners{t[first % 3],
                           t[(first + (is_mirrored ? 2 : 1)) % 3],
                           t[(first + (is_mirrored ? 1 : 2)) % 3]};
        };
        all.push_back({order(c.a, i % 3, i % 2 == 0), order(c.b, i / 3, i % 4 < 2)});
    }
    return all;
}

/// Expects the same answers on every target, all equal to the exact path's. Returns the number of
/// answers on one target.
int expect_exact(const PosePair& poses, std::span<const PairCorners> pairs) {
    SharedPoints exact(poses, SharedPoints::Path::Exact);
    std::vector<Bits> first;
    int answers = 0;
    on_every_target([&](SimdTarget) {
        CrossingPoints crossings(poses);
        const std::vector<Bits> found = found_together(crossings, pairs);
        if (first.empty()) {
            first = found;
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                if (!found[i].empty()) {
                    ++answers;
                    EXPECT_EQ(found[i], exact_bits(exact, pairs[i])) << "pair " << i;
                }
            }
        }
        EXPECT_EQ(found, first);
    });
    return answers;
}

/// Makes a pair that often crosses, of triangles of sizes from `size` down to 1/1000 of it, far
/// from the bodies' origins and the world's.
PosedPair of_many_sizes(std::mt19937_64& random, double size, double far) {
    PosedPair c{random_corners(random, size), random_corners(random, size), {}};
    const double smaller = std::pow(10, uniform(random, -3, 0));
    Corners& small = random() % 2 == 0 ? c.a : c.b;
    for (Vec3& corner : small) {
        corner *= smaller;
    }
    const Vec3 to = random_point(random, far);
    const Pose pose = make_pose(random, far);
    const bool is_matrix = random() % 3 == 0;
    c.poses.a = c.poses.b = is_matrix ? make_matrix_pose(random, far) : pose;
    for (std::size_t i = 0; i < 3; ++i) {
        c.a[i] += to;
        c.b[i] += to;
    }
    return c;
}

std::map<std::string, PairMaker> crossing_makers() {
    std::map<std::string, PairMaker> all;
    all["two quaternions"] = [](auto& r) {
        return moved(
            {random_corners(r, 1), random_corners(r, 1), {make_pose(r, 1), make_pose(r, 1)}},
            Vec3::Zero());
    };
    all["two matrices"] = [](auto& r) {
        return moved({random_corners(r, 1),
                      random_corners(r, 1),
                      {make_matrix_pose(r, 1), make_matrix_pose(r, 1)}},
                     Vec3::Zero());
    };
    all["one unrotated"] = [](auto& r) {
        return moved({random_corners(r, 1), random_corners(r, 1), {Pose{}, make_pose(r, 1)}},
                     Vec3::Zero());
    };
    return all;
}

/// Returns the number of wrong answers.
int wrong_answers(const PairMaker& make, double bound_scale, std::uint64_t rounds) {
    const auto answer = [&](const PosedPair& c, const Vec3&) {
        CrossingPoints crossings(c.poses, bound_scale);
        const PairCorners pair{c.a, c.b};
        crossings.compute({&pair, 1});
        const auto ends = crossings.ends(0);
        return crossings.is_proven(0)
                   ? std::optional(PairPoints{crossings.origin(0), {ends.begin(), ends.end()}})
                   : std::nullopt;
    };
    return wrong_answers_of(make, answer, rounds);
}

} // namespace

TEST(CrossingPoints, AreTheExactOnesOnEveryTargetForHardPairsInAnyOrder) {
    int answers = 0;
    for (const auto& [name, make] : pair_makers()) {
        for (SeededRandom random : seeds(12, 500)) {
            const PosedPair c = make(random);
            answers += expect_exact(c.poses, in_all_orders(c));
            ASSERT_FALSE(testing::Test::HasFailure()) << name;
        }
    }
    EXPECT_GT(answers, 200);
}

TEST(CrossingPoints, AreTheExactOnesOnEveryTargetForTrianglesOfAllSizesAndPlaces) {
    for (const double size : {0x1p-1070, 0x1p-205, 0x1p-195, 1e-9, 1.0, 1e9, 0x1p199, 0x1p1000}) {
        for (const double far : {0.0, 1.0, 1e6}) {
            int answers = 0;
            for (SeededRandom random : seeds(25)) {
                const PosedPair c = of_many_sizes(random, size, far * size);
                answers += expect_exact(c.poses, in_all_orders(c));
                ASSERT_FALSE(testing::Test::HasFailure()) << size << " at " << far;
            }
            const bool is_in_range = size > 1e-20 && size < 1e20;
            EXPECT_TRUE(!is_in_range || answers > 10) << size << " at " << far;
        }
    }
}

TEST(CrossingPoints, AreTheExactOnesWherePosesOrFacesKeepAxes) {
    int answers = 0;
    for (SeededRandom random : seeds(300)) {
        PosedPair c{random_corners(random, 1), random_corners(random, 1), {}};
        const auto axis = static_cast<int>(random() % 3);
        Corners& flat = random.seed % 2 == 0 ? c.a : c.b;
        for (std::size_t k = 0; k < (random() % 2 == 0 ? 3 : 2); ++k) {
            flat[k][axis] = random() % 2 == 0 ? 0.3 : 0.375;
        }
        const std::array<Pose, 4> kept{
            Pose{},
            translation_pose(0.1, -2, 3),
            Pose::from_quaternion({1, 1, 0, 0}, Vec3(0.25, 0.5, 0)),
            Pose::from_quaternion({uniform(random, 0.1, 1), 0, 0, uniform(random, -1, 1)},
                                  Vec3::Zero())};
        const std::size_t which = random() % kept.size();
        Pose turned = make_pose(random, 0.1);
        if (random() % 2 == 0) {
            // Three quarters of a turn about x.
            turned = Pose::from_quaternion({1, -1, 0, 0}, Vec3(0.125, 0, 0));
        }
        (random() % 2 == 0 ? c.poses.a : c.poses.b) = kept[which];
        (random() % 2 == 0 ? c.poses.b : c.poses.a) = turned;
        answers += expect_exact(c.poses, in_all_orders(c));
        ASSERT_FALSE(testing::Test::HasFailure());
    }
    EXPECT_GT(answers, 200);
}

TEST(CrossingPoints, AnAnswerDoesNotDependOnTheOtherPairs) {
    std::mt19937_64 random(3);
    const PosePair poses{make_pose(random, 0.2), make_matrix_pose(random, 0.2)};
    CrossingPoints crossings(poses);
    int answers = 0;
    for (int round = 0; round < 100; ++round) {
        std::vector<PairCorners> pairs;
        for (std::size_t i = 0; i < 1 + random() % CrossingPoints::pairs_max; ++i) {
            pairs.push_back({random_corners(random, 1), random_corners(random, 1)});
        }
        const std::vector<Bits> all = found_together(crossings, pairs);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            ASSERT_EQ(found_together(crossings, std::span(pairs).subspan(i, 1)).front(), all[i]);
            answers += all[i].empty() ? 0 : 1;
        }
    }
    EXPECT_GT(answers, 30);
}

TEST(CrossingPoints, AreRightNearTheMiddleBetweenTwoDoublesOrNotGiven) {
    for (const auto& [name, make] : crossing_makers()) {
        EXPECT_EQ(wrong_answers(make, 1, 24), 0) << name;
    }
}

TEST(CrossingPoints, WouldBeWrongWithBoundsThatAreTooSmall) {
    for (const auto& [name, make] : crossing_makers()) {
        EXPECT_GT(wrong_answers(make, 0x1p-20, 96), 1) << name;
    }
}

TEST(CrossingPoints, AnOriginWouldBeWrongWithBoundsThatAreTooSmall) {
    for (const double bound_scale : {1.0, 0x1p-20}) {
        int wrong = 0;
        for (SeededRandom random : seeds(400)) {
            PosedPair c = moved(
                {random_corners(random, 1), random_corners(random, 1), {make_pose(random, 1), {}}},
                Vec3::Zero());
            const RationalPoint at = clipping_oracle_world(c.poses.a, c.a[0]);
            Vec3 by;
            for (std::size_t k = 0; k < 3; ++k) {
                by[static_cast<Eigen::Index>(k)] =
                    Rational(middle_near(at[k]) - at[k]).convert_to<double>();
            }
            c.poses.a = with_translation(c.poses.a, by);
            CrossingPoints crossings(c.poses, bound_scale);
            const PairCorners pair{c.a, c.b};
            crossings.compute({&pair, 1});
            const RationalPoint exact = clipping_oracle_world(c.poses.a, c.a[0]);
            for (std::size_t k = 0; crossings.is_proven(0) && k < 3; ++k) {
                const double value = crossings.origin(0)[static_cast<Eigen::Index>(k)];
                wrong += is_nearest_double(value, exact[k]) ? 0 : 1;
            }
        }
        if (bound_scale == 1) {
            EXPECT_EQ(wrong, 0);
        } else {
            EXPECT_GT(wrong, 5);
        }
    }
}

TEST(CrossingPoints, SharedPointsOfManyPairsAreThoseOfEachPair) {
    std::uint64_t together = 0;
    std::uint64_t others = 0;
    on_every_target([&](SimdTarget) {
        for (SeededRandom random : seeds(60)) {
            const Pose pose = random() % 2 == 0 ? make_pose(random, 2) : Pose{};
            SharedPoints exact({pose, pose}, SharedPoints::Path::Exact);
            SharedPoints any({pose, pose});
            std::vector<PairCorners> pairs;
            for (std::size_t i = 0; i < random() % 20; ++i) {
                PairCorners pair{lattice_corners(random, 4), lattice_corners(random, 4)};
                if (random() % 2 == 0) {
                    pair.b = random_corners(random, 2);
                }
                if (i > 0 && random() % 2 == 0) {
                    pair.a = pairs.back().a;
                }
                pairs.push_back(pair);
            }
            std::size_t i = 0;
            any.for_each(pairs, [&](const Vec3& origin, std::span<const Vec3> points) {
                ASSERT_LT(i, pairs.size());
                ASSERT_EQ(bits_of(origin, points), exact_bits(exact, pairs[i])) << i;
                ++i;
            });
            ASSERT_EQ(i, pairs.size());
            together += any.statistics().points_together;
            others += any.statistics().points_fast + any.statistics().points_exact;
        }
    });
    EXPECT_GT(together, 50u);
    EXPECT_GT(others, 50u);
}

TEST(CrossingPoints, NearlyAllCrossingPairsOfOrdinaryScenesHaveThem) {
    for (const bool is_unrotated : {false, true}) {
        std::mt19937_64 random(6);
        const PosePair poses{is_unrotated ? translation_pose(0.1, -2, 3) : make_pose(random, 0.3),
                             is_unrotated
                                 ? Pose::from_quaternion({0.8, 0.1, -0.3, 0.2}, Vec3(0.1, -2, 3))
                                 : make_pose(random, 0.3)};
        CrossingPoints crossings(poses);
        SharedPoints exact(poses, SharedPoints::Path::Exact);
        int crossing = 0;
        int answers = 0;
        for (int i = 0; i < 3'000; ++i) {
            PairCorners pair{random_corners(random, 1), random_corners(random, 1)};
            if (i % 2 == 0) {
                pair.a[0][i % 3] = pair.a[1][i % 3] = pair.a[2][i % 3] = 0.25;
            }
            crossing += exact.points(pair.a, pair.b).size() == 2 ? 1 : 0;
            crossings.compute({&pair, 1});
            answers += crossings.is_proven(0) ? 1 : 0;
        }
        EXPECT_GT(crossing, 300);
        EXPECT_GT(answers, crossing * 99 / 100) << is_unrotated;
    }
}

} // namespace cd::tests
