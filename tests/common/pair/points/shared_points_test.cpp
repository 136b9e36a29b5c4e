// Proves that shared points are the corners of the exact intersection, each rounded once and
// correctly, in an order that follows from the intersection alone; and that fast and exact path
// give equal bits.
#include "common/pair/points/shared_points.hpp"

#include "tests/support/clipping_oracle.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <string>

namespace cd::tests {

namespace {

void expect_rounded(const Vec3& rounded, const RationalPoint& exact) {
    for (std::size_t k = 0; k < 3; ++k) {
        const double value = rounded[static_cast<Eigen::Index>(k)];
        EXPECT_TRUE(is_nearest_double(value, exact[k])) << value << ", component " << k;
    }
}

RationalPoint relative_to(const Vec3& origin, const RationalPoint& point) {
    return {point[0] - Rational(origin.x()),
            point[1] - Rational(origin.y()),
            point[2] - Rational(origin.z())};
}

/// Returns the number of points.
std::size_t expect_correct(SharedPoints& shared, const PosedPair& c) {
    const Vec3 origin = shared.origin(c.a);
    expect_rounded(origin, clipping_oracle_world(c.poses.a, c.a[0]));
    const std::vector<RationalPoint> expected = clipping_oracle_points(c.a, c.b, c.poses);
    const std::span<const Vec3> points = shared.points(c.a, c.b);
    EXPECT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < std::min(points.size(), expected.size()); ++i) {
        expect_rounded(points[i], relative_to(origin, expected[i]));
    }
    return points.size();
}

using Bits = std::vector<std::uint64_t>;

Bits bits_of(SharedPoints& shared, const PosedPair& c) {
    Bits bits;
    const auto add = [&](const Vec3& v) {
        for (int k = 0; k < 3; ++k) {
            bits.push_back(std::bit_cast<std::uint64_t>(v[k]));
        }
    };
    add(shared.origin(c.a));
    for (const Vec3& point : shared.points(c.a, c.b)) {
        add(point);
    }
    return bits;
}

/// Adds kinds to those shared with other tests.
std::map<std::string, PairMaker> all_makers() {
    std::map<std::string, PairMaker> all = pair_makers();
    all["needles, both posed"] = [](auto& r) {
        PosedPair c = nearly_touching(r);
        c.a[2] = c.a[1] + random_point(r, 1e-9);
        c.b[1] = c.b[0] + random_point(r, 1e-7);
        return c;
    };
    all["almost in one plane, both posed"] = [](auto& r) {
        PosedPair c{random_corners(r, 1), {}, {}};
        c.poses.a = c.poses.b = make_pose(r, 3);
        const Vec3 p = c.a[1] - c.a[0];
        const Vec3 q = c.a[2] - c.a[0];
        for (Vec3& corner : c.b) {
            corner = c.a[0] + uniform(r, -1, 1) * p + uniform(r, -1, 1) * q +
                     random_point(r, std::ldexp(1.0, -40 - static_cast<int>(r() % 14)));
        }
        return c;
    };
    all["small, far in the bodies and in the world"] = [](auto& r) {
        PosedPair c = nearly_touching(r);
        const Vec3 far(3e5, 5e6, 12);
        c.poses.b = Pose::from_quaternion({0.8, 0.1, -0.3, 0.2}, far);
        c.poses.a = c.poses.b;
        for (std::size_t i = 0; i < 3; ++i) {
            c.b[i] = 1e-3 * (c.a[(i + 1) % 3] + c.b[i]) + far;
            c.a[i] = 1e-3 * c.a[i] + far;
        }
        return c;
    };
    all["stars of five and six points"] = [](auto& r) {
        PosedPair c{{Vec3(-3, -2, 1), Vec3(3, -2, 1), Vec3(0, 4, 1)},
                    {Vec3(-3, 2, 1), Vec3(3, 2, 1), Vec3(0, r() % 2 == 0 ? -1 : -4, 1)},
                    {}};
        c.poses.a = c.poses.b = make_pose(r, 5);
        for (Corners* t : {&c.a, &c.b}) {
            std::swap((*t)[0], (*t)[r() % 3]);
        }
        return c;
    };
    return all;
}

} // namespace

TEST(SharedPoints, AreTheExactOnesRoundedOnceOnEveryKindOfPair) {
    std::array<int, 7> seen{}; // Pairs by number of points.
    for (const auto& [name, make] : all_makers()) {
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            SCOPED_TRACE(testing::Message() << name << ", seed " << seed);
            std::mt19937_64 random(seed);
            const PosedPair c = make(random);
            SharedPoints shared(c.poses);
            ++seen.at(expect_correct(shared, c));
            ASSERT_FALSE(HasFailure());
        }
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        EXPECT_GT(seen[i], 10) << i << " points";
    }
}

TEST(SharedPoints, BothPathsGiveTheSameBits) {
    PointStatistics total;
    for (const auto& [name, make] : all_makers()) {
        for (SeededRandom random : seeds(400, 1000)) {
            const PosedPair c = make(random);
            SharedPoints any(c.poses);
            SharedPoints exact(c.poses, SharedPoints::Path::Exact);
            ASSERT_EQ(bits_of(any, c), bits_of(exact, c)) << name;
            EXPECT_EQ(exact.statistics().points_fast, 0u);
            EXPECT_EQ(exact.statistics().origins_fast, 0u);
            total.points_fast += any.statistics().points_fast;
            total.points_exact += any.statistics().points_exact;
            total.origins_fast += any.statistics().origins_fast;
            total.origins_exact += any.statistics().origins_exact;
        }
    }
    EXPECT_GT(total.points_fast, 500u);
    EXPECT_GT(total.points_exact, 500u);
    EXPECT_GT(total.origins_fast, 500u);
    EXPECT_GT(total.origins_exact, 500u);
}

TEST(SharedPoints, DoNotDependOnEarlierPairs) {
    std::mt19937_64 random(5);
    const PosePair poses{make_pose(random, 0.2), make_matrix_pose(random, 0.2)};
    SharedPoints one_for_all(poses);
    std::array<Corners, 3> triangles{};
    for (Corners& t : triangles) {
        t = random_corners(random, 1);
    }
    for (int round = 0; round < 3000; ++round) {
        const PosedPair c{triangles[random() % 3], random_corners(random, 1), poses};
        SharedPoints fresh(poses);
        ASSERT_EQ(bits_of(one_for_all, c), bits_of(fresh, c)) << round;
    }
}

TEST(SharedPoints, OrdinaryPairsTakeTheFastPath) {
    std::mt19937_64 random(6);
    SharedPoints shared({make_pose(random, 0.3), make_pose(random, 0.3)});
    std::uint64_t meeting = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Corners a = random_corners(random, 1);
        const Corners b = random_corners(random, 1);
        meeting += shared.points(a, b).empty() ? 0 : 1;
    }
    EXPECT_GT(meeting, 500u);
    EXPECT_EQ(shared.statistics().points_exact, 0u);
    EXPECT_EQ(shared.statistics().origins_exact, 0u);
}

TEST(SharedPoints, FacesAtRightAnglesToAnAxisTakeTheFastPathToo) {
    // As for an unrotated vehicle: the intersection has a component that is exactly 0.
    std::mt19937_64 random(7);
    PointStatistics total;
    std::uint64_t meeting = 0;
    for (int i = 0; i < 3'000; ++i) {
        PosedPair c{random_corners(random, 1), random_corners(random, 1), {}};
        const int axis = i % 3;
        // Share the whole face, or one edge.
        for (std::size_t k = 0; k < (i % 4 < 2 ? 3 : 2); ++k) {
            c.a[k][axis] = 0.3;
        }
        c.poses.b = make_pose(random, 0.1);
        if (i % 2 == 0) {
            c.poses.a = translation_pose(0.1, -2, 3);
        }
        SharedPoints any(c.poses);
        SharedPoints exact(c.poses, SharedPoints::Path::Exact);
        ASSERT_EQ(bits_of(any, c), bits_of(exact, c)) << i;
        meeting += any.points(c.a, c.b).empty() ? 0 : 1;
        // Each pair is asked for twice.
        total.points_fast += any.statistics().points_fast / 2;
    }
    EXPECT_GT(meeting, 300u);
    EXPECT_GT(total.points_fast, meeting * 4 / 5);
}

TEST(SharedPoints, PairsThatTouchTakeTheFastPathToo) {
    // Corners on faces, edges and corners, and coplanar overlaps: as for bodies in contact, under
    // equal poses or none.
    std::mt19937_64 random(8);
    std::uint64_t fast = 0;
    std::uint64_t meeting = 0;
    for (int i = 0; i < 2'000; ++i) {
        PosedPair c{lattice_corners(random, 4), lattice_corners(random, 4), {}};
        for (std::size_t k = 0; k < 3; ++k) {
            c.a[k].z() = 1;
            c.b[k].z() = k == 0 || i % 2 == 0 ? 1 : 3;
        }
        if (i % 4 < 2) {
            c.poses.a = c.poses.b = i % 3 == 0 ? make_matrix_pose(random, 2) : make_pose(random, 2);
        } else if (i % 3 != 0) {
            c.poses.a = translation_pose(0.1, -2, 3);
            c.poses.b = c.poses.a;
        }
        SharedPoints any(c.poses);
        SharedPoints exact(c.poses, SharedPoints::Path::Exact);
        ASSERT_EQ(bits_of(any, c), bits_of(exact, c)) << i;
        if (exact.points(c.a, c.b).empty()) {
            continue;
        }
        ++meeting;
        fast += any.statistics().points_fast;
    }
    EXPECT_GT(meeting, 500u);
    EXPECT_GT(fast, meeting * 8 / 10); // Some are degenerate.
}

TEST(SharedPoints, ANearlyRightAngleIsNotTakenForOne) {
    // A quarter turn about z, plus a turn about x whose square is lost in double-doubles: the
    // corner's true x is some 1e-40.
    const double half = std::sqrt(0.5);
    const Pose pose = Pose::from_quaternion({half, 1e-20, 0, half}, Vec3::Zero());
    const PosedPair c{{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
                      {Vec3(1, 0, 0), Vec3(2, 1, 0), Vec3(2, 0, 1)},
                      {pose, pose}};
    SharedPoints any(c.poses);
    SharedPoints exact(c.poses, SharedPoints::Path::Exact);
    EXPECT_GT(exact.origin(c.a).x(), 0);
    EXPECT_EQ(bits_of(any, c), bits_of(exact, c));
}

TEST(SharedPoints, AnOriginAtWholeNumbersOrZeroIsItself) {
    SharedPoints shared(PosePair{});
    const Corners a{Vec3(0, -3, 0.5), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const Vec3 origin = shared.origin(a);
    EXPECT_EQ(origin, a[0]);
    EXPECT_FALSE(std::signbit(origin.x()));
}

TEST(SharedPoints, BeyondTheRangeOfDoubleTheyAreTheLargest) {
    constexpr double most = std::numeric_limits<double>::max();
    const Corners a{Vec3(most, 0, 0), Vec3(-most, 0, 0), Vec3(0, most, 0)};
    SharedPoints shared({Pose::from_matrix(2 * Mat3::Identity(), Vec3::Zero()),
                         Pose::from_matrix(2 * Mat3::Identity(), Vec3::Zero())});
    EXPECT_EQ(shared.origin(a), Vec3(most, 0, 0));
    for (const Vec3& point : shared.points(a, a)) {
        EXPECT_TRUE(point.allFinite());
    }
}

} // namespace cd::tests
