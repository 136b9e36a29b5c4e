// Proves that the decision on two triangles is exact: on random pairs and every kind of hard pair
// it equals an oracle in rational arithmetic, independent of the order of bodies and corners.
#include "common/pair/triangle_pair.hpp"

#include "tests/support/hard_pairs.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/pair_points.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace cd::tests {

namespace {

/// Returns a point's distance from a closed triangle, segment or point: inside its prism the
/// distance from its plane, otherwise that from an edge.
double distance(const Vec3& p, const Corners& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    bool inside = normal.norm() > 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = t[(i + 1) % 3] - t[i];
        inside = inside && normal.cross(edge).dot(p - t[i]) >= 0;
        const double length = edge.squaredNorm();
        const double along = length > 0 ? std::clamp(edge.dot(p - t[i]) / length, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, (t[i] + along * edge - p).norm());
    }
    return inside ? std::min(nearest, std::abs(normal.dot(p - t[0])) / normal.norm()) : nearest;
}

} // namespace

TEST(TrianglePair, EqualsTheOracleOnEveryKindOfPair) {
    constexpr std::uint64_t rounds = 150;
    std::map<PairClass, int> seen;
    for (const auto& [name, make] : pair_makers()) {
        for (SeededRandom random : seeds(rounds)) {
            const PosedPair c = make(random);
            const PairClass expected = oracle_class(c.a, c.b, c.poses);
            TrianglePairTest test(c.poses);
            ASSERT_EQ(test.classify(c.a, c.b), expected) << name;
            ++seen[expected];
        }
    }
    // Every class must occur, or agreement proves little.
    EXPECT_EQ(seen.size(), 4u);
    for (const auto& [kind, count] : seen) {
        EXPECT_GT(count, 50) << static_cast<int>(kind);
    }
}

TEST(TrianglePair, NumbersOfEveryMagnitudeAreDecidedExactly) {
    for (SeededRandom random : seeds(24)) {
        PosedPair c{lattice_corners(random, 2), lattice_corners(random, 2), {}};
        for (Corners* t : {&c.a, &c.b}) {
            for (Vec3& corner : *t) {
                for (int axis = 0; axis < 3; ++axis) {
                    const int exponent = static_cast<int>(random() % 3) * 1040 - 1060;
                    corner[axis] = std::ldexp(corner[axis], exponent);
                }
            }
        }
        if (random.seed % 8 == 0) {
            c.poses.a = Pose::from_quaternion({0x1p1000, 0, 0x1p-1074, 0x1p1000}, Vec3::Zero());
        }
        const PairClass expected = oracle_class(c.a, c.b, c.poses);
        TrianglePairTest test(c.poses);
        ASSERT_EQ(test.classify(c.a, c.b), expected);
        if (expected != PairClass::Separate) {
            for (const Vec3& point : points_of(test, c.a, c.b).points) {
                EXPECT_TRUE(point.allFinite());
            }
        }
    }
}

TEST(TrianglePair, SharedPointsLieOnBothTriangles) {
    for (const auto& [name, make] : pair_makers()) {
        // Doubles in world axes cannot place these kinds' points to 1e-9.
        const bool is_ill_conditioned = name == "slivers and needles" ||
                                        name == "nearly coplanar" || name == "huge" ||
                                        name.starts_with("far") || name == "one large, one small";
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            SCOPED_TRACE(testing::Message() << name << ", seed " << seed);
            std::mt19937_64 random(seed);
            const PosedPair c = make(random);
            TrianglePairTest test(c.poses);
            const PairClass kind = test.classify(c.a, c.b);
            if (kind == PairClass::Separate) {
                continue;
            }
            const auto [origin, points] = points_of(test, c.a, c.b);
            ASSERT_FALSE(points.empty());
            ASSERT_LE(points.size(), 6u);
            Corners a;
            Corners b;
            for (std::size_t i = 0; i < 3; ++i) {
                a[i] = c.poses.a.apply(c.a[i]) - origin;
                b[i] = c.poses.b.apply(c.b[i]) - origin;
            }
            for (const Vec3& point : points) {
                ASSERT_TRUE(point.allFinite());
                if (!is_ill_conditioned) {
                    EXPECT_LE(distance(point, a), 1e-9);
                    EXPECT_LE(distance(point, b), 1e-9);
                }
            }
        }
    }
}

TEST(TrianglePair, SharedPointsAreThoseOfTheIntersection) {
    struct Case {
        const char* what;
        PairClass kind;
        Corners a;
        Corners b;
        std::size_t points;
        double x_min; ///< Relative to A's first corner.
        double x_max;
    };
    const Corners floor{Vec3(-4, -4, 0), Vec3(8, -4, 0), Vec3(-4, 8, 0)};
    for (const Case& c : {
             Case{"crossing triangles share a segment",
                  PairClass::Proper,
                  {Vec3(-1, -1, 0), Vec3(3, -1, 0), Vec3(-1, 3, 0)},
                  {Vec3(0, 0, -1), Vec3(1, 0, -1), Vec3(0, 0, 1)},
                  2,
                  1,
                  1.5},
             Case{"a coplanar overlap is a polygon",
                  PairClass::Coplanar,
                  {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)},
                  {Vec3(1, 1, 0), Vec3(5, 1, 0), Vec3(1, 5, 0)},
                  3,
                  1,
                  3},
             Case{"segments on one line share a segment",
                  PairClass::Touch,
                  {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 0, 0)},
                  {Vec3(9, 0, 0), Vec3(3, 0, 0), Vec3(3, 0, 0)},
                  2,
                  3,
                  4},
             Case{"an edge that lies on a face is shared",
                  PairClass::Touch,
                  floor,
                  {Vec3(-9, 0, 0), Vec3(9, 0, 0), Vec3(0, 0, 5)},
                  2,
                  0,
                  8},
         }) {
        SCOPED_TRACE(c.what);
        TrianglePairTest test(PosePair{});
        ASSERT_EQ(test.classify(c.a, c.b), c.kind);
        const auto points = points_of(test, c.a, c.b).points;
        ASSERT_EQ(points.size(), c.points);
        const auto [least, most] =
            std::ranges::minmax(points, {}, [](const Vec3& p) { return p.x(); });
        EXPECT_NEAR(least.x(), c.x_min, 1e-15);
        EXPECT_NEAR(most.x(), c.x_max, 1e-15);
    }
}

TEST(TrianglePair, FloatsAloneCountOpenPairsAsTouching) {
    const std::vector<Vec3> vertices{{0, 0, 0},
                                     {4, 0, 0},
                                     {0, 4, 0}, // A triangle of A.
                                     {1, 1, -1},
                                     {1, 1, 1},
                                     {2, 1, 1}, // Crosses it.
                                     {9, 9, 9},
                                     {9, 8, 9},
                                     {8, 9, 9}, // Is far away.
                                     {0, 0, 0x1p-40},
                                     {4, 0, 0x1p-40},
                                     {0, 4, 0x1p-40}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
    const TriangleSpan span{vertices, triangles};
    const std::vector<Candidate> candidates{{0, 1}, {0, 2}, {0, 3}};
    TrianglePairTest floats({}, PairStage::Float, PairDecision::FloatsOnly);
    const auto kinds = floats.classify(span, span, candidates);
    EXPECT_EQ(std::vector(kinds.begin(), kinds.end()),
              (std::vector{PairClass::Proper, PairClass::Separate, PairClass::Touch}));
    EXPECT_EQ(floats.statistics().total(), 2u) << "the open pair is not settled";
    TrianglePairTest exact({});
    EXPECT_NE(exact.classify(span, span, candidates)[2], PairClass::Touch);
}

TEST(TrianglePair, OrdinaryPairsAreDecidedInDouble) {
    std::mt19937_64 random(7);
    TrianglePairTest test({make_pose(random, 0.3), make_pose(random, 0.3)});
    for (int i = 0; i < 10'000; ++i) {
        static_cast<void>(test.classify(random_corners(random, 1), random_corners(random, 1)));
    }
    EXPECT_EQ(test.statistics().total(), 10'000u);
    EXPECT_GE(test.statistics()[PairStage::Double], 9'995u);
}

} // namespace cd::tests
