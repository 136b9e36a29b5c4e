// Proves that the decision about two triangles is exact: on random pairs and on every kind of hard
// one it equals an oracle in rational arithmetic, and it does not depend on the order of bodies and
// corners.
#include "common/geometry/triangle_pair.hpp"

#include "tests/support/oracle.hpp"
#include "tests/support/shapes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>

namespace cd::tests {

namespace {

struct Case {
    Corners a;
    Corners b;
    PosePair poses;
};

using Maker = std::function<Case(std::mt19937_64&)>;

Corners random_corners(std::mt19937_64& random, double half_width) {
    return {random_point(random, half_width),
            random_point(random, half_width),
            random_point(random, half_width)};
}

Vec3 lattice_point(std::mt19937_64& random, int reach) {
    const auto coordinate = [&] {
        return static_cast<double>(
            static_cast<int>(random() % (2 * static_cast<unsigned>(reach) + 1)) - reach);
    };
    const double x = coordinate();
    const double y = coordinate();
    const double z = coordinate();
    return {x, y, z};
}

Corners lattice_corners(std::mt19937_64& random, int reach) {
    return {
        lattice_point(random, reach), lattice_point(random, reach), lattice_point(random, reach)};
}

/// A point of a triangle, rounded: a vertex of B put there touches A nominally.
Vec3 point_on(std::mt19937_64& random, const Corners& t) {
    const double s = uniform(random, 0, 1);
    const double r = uniform(random, 0, 1 - s);
    return t[0] + s * (t[1] - t[0]) + r * (t[2] - t[0]);
}

Vec3 nudged(std::mt19937_64& random, Vec3 p) {
    for (int axis = 0; axis < 3; ++axis) {
        const double infinity = std::numeric_limits<double>::infinity();
        if (random() % 2 == 0) {
            p[axis] = std::nextafter(p[axis], random() % 2 == 0 ? infinity : -infinity);
        }
    }
    return p;
}

Corners scaled(Corners t, double factor) {
    for (Vec3& corner : t) {
        corner *= factor;
    }
    return t;
}

Corners flat(Corners t) {
    for (Vec3& corner : t) {
        corner.z() = 0;
    }
    return t;
}

PosePair both_posed(std::mt19937_64& random, double reach) {
    return {make_pose(random, reach), make_pose(random, reach)};
}

Pose quarter_turns(std::mt19937_64& random) {
    Mat3 rotation = Mat3::Identity();
    for (std::uint64_t i = 0; i < 1 + random() % 3; ++i) {
        const int axis = static_cast<int>(random() % 3);
        Mat3 turn = Mat3::Zero();
        turn(axis, axis) = 1;
        turn((axis + 1) % 3, (axis + 2) % 3) = -1;
        turn((axis + 2) % 3, (axis + 1) % 3) = 1;
        rotation = Mat3(rotation * turn);
    }
    return Pose::from_matrix(rotation, lattice_point(random, 2));
}

std::map<std::string, Maker> makers() {
    std::map<std::string, Maker> all;
    all["random"] = [](auto& r) { return Case{random_corners(r, 1), random_corners(r, 1), {}}; };
    all["random, both posed"] = [](auto& r) {
        return Case{random_corners(r, 1), random_corners(r, 1), both_posed(r, 0.3)};
    };
    all["random, matrix poses"] = [](auto& r) {
        return Case{random_corners(r, 1),
                    random_corners(r, 1),
                    {make_matrix_pose(r, 0.3), make_matrix_pose(r, 0.3)}};
    };
    all["lattice: ties and degenerate ones"] = [](auto& r) {
        return Case{lattice_corners(r, 2), lattice_corners(r, 2), {}};
    };
    all["lattice in one plane"] = [](auto& r) {
        return Case{flat(lattice_corners(r, 3)), flat(lattice_corners(r, 3)), {}};
    };
    all["lattice under quarter turns"] = [](auto& r) {
        return Case{
            lattice_corners(r, 2), lattice_corners(r, 2), {quarter_turns(r), quarter_turns(r)}};
    };
    all["one pose for both: shared vertices"] = [](auto& r) {
        Case c{random_corners(r, 1), random_corners(r, 1), {}};
        c.poses.a = c.poses.b = make_pose(r, 10);
        c.b[0] = c.a[r() % 3];
        if (r() % 2 == 0) {
            c.b[1] = c.a[r() % 3];
        }
        return c;
    };
    all["vertex on face, one ulp off"] = [](auto& r) {
        Case c{random_corners(r, 1), random_corners(r, 1), {}};
        c.b[0] = nudged(r, point_on(r, c.a));
        return c;
    };
    all["slivers and needles"] = [](auto& r) {
        Case c{random_corners(r, 1), random_corners(r, 1), both_posed(r, 0.1)};
        c.a[2] = c.a[0] + 0.5 * (c.a[1] - c.a[0]) + random_point(r, 1e-12);
        c.b[1] = c.b[0] + random_point(r, 1e-9);
        return c;
    };
    all["degenerate to segments and points"] = [](auto& r) {
        Case c{lattice_corners(r, 2), lattice_corners(r, 2), {}};
        c.a[1] = c.a[0];
        if (r() % 3 == 0) {
            c.b[2] = 2 * c.b[1] - c.b[0];
        }
        if (r() % 5 == 0) {
            c.a[2] = c.a[0];
        }
        return c;
    };
    all["nearly coplanar"] = [](auto& r) {
        Case c{flat(random_corners(r, 1)), flat(random_corners(r, 1)), {}};
        for (Vec3& corner : c.b) {
            corner.z() = uniform(r, -1, 1) * std::ldexp(1.0, -30 - static_cast<int>(r() % 24));
        }
        return c;
    };
    all["tiny"] = [](auto& r) {
        return Case{scaled(lattice_corners(r, 2), 1e-20), scaled(lattice_corners(r, 2), 1e-20), {}};
    };
    all["denormal"] = [](auto& r) {
        return Case{
            scaled(lattice_corners(r, 2), 0x1p-1074), scaled(lattice_corners(r, 2), 0x1p-1074), {}};
    };
    all["huge"] = [](auto& r) {
        return Case{
            scaled(random_corners(r, 1), 0x1p400), scaled(lattice_corners(r, 1), 0x1p400), {}};
    };
    all["far away, small features"] = [](auto& r) {
        Case c{scaled(lattice_corners(r, 2), 1e-3), scaled(lattice_corners(r, 2), 1e-3), {}};
        for (Corners* t : {&c.a, &c.b}) {
            for (Vec3& corner : *t) {
                corner += Vec3(1e7, -2e7, 3e6);
            }
        }
        return c;
    };
    all["far poses that cancel"] = [](auto& r) {
        Case c{random_corners(r, 1), random_corners(r, 1), both_posed(r, 0.2)};
        const Vec3 far(1e7, 1e7, 1e7);
        c.poses.a = Pose::from_quaternion(c.poses.a.quaternion(), c.poses.a.translation() + far);
        c.poses.b = Pose::from_quaternion(c.poses.b.quaternion(), c.poses.b.translation() + far);
        return c;
    };
    all["quaternions of any norm"] = [](auto& r) {
        Case c{lattice_corners(r, 2), lattice_corners(r, 2), {}};
        const auto small = [&] { return static_cast<double>(1 + r() % 3); };
        c.poses.a = Pose::from_quaternion({small(), 0, 0, small()}, lattice_point(r, 1));
        c.poses.b = Pose::from_quaternion({small() * 1e-9, 0, small() * 1e-9, 0}, Vec3::Zero());
        return c;
    };
    return all;
}

} // namespace

TEST(TrianglePair, EqualsTheOracleOnEveryKindOfPair) {
    constexpr std::uint64_t rounds = 250;
    std::map<PairClass, int> seen;
    for (const auto& [name, make] : makers()) {
        for (std::uint64_t seed = 0; seed < rounds; ++seed) {
            std::mt19937_64 random(seed);
            const Case c = make(random);
            const PairClass expected = oracle_class(c.a, c.b, c.poses);
            TrianglePairTest test(c.poses);
            ASSERT_EQ(test.classify(c.a, c.b), expected) << name << ", seed " << seed;
            ASSERT_EQ(test.touches(c.a, c.b), expected != PairClass::Separate)
                << name << ", seed " << seed;
            ++seen[expected];
        }
    }
    // Agreement means little where a class never came up.
    EXPECT_EQ(seen.size(), 4u);
    for (const auto& [kind, count] : seen) {
        EXPECT_GT(count, 50) << static_cast<int>(kind);
    }
}

TEST(TrianglePair, DoesNotDependOnTheOrderOfBodiesAndCorners) {
    for (const auto& [name, make] : makers()) {
        for (std::uint64_t seed = 1000; seed < 1060; ++seed) {
            std::mt19937_64 random(seed);
            const Case c = make(random);
            const PairClass expected = TrianglePairTest(c.poses).classify(c.a, c.b);
            const Corners turned{c.a[1], c.a[2], c.a[0]};
            const Corners flipped{c.b[1], c.b[0], c.b[2]};
            EXPECT_EQ(TrianglePairTest(c.poses).classify(turned, flipped), expected)
                << name << ", seed " << seed;
            const PosePair swapped{c.poses.b, c.poses.a};
            EXPECT_EQ(TrianglePairTest(swapped).classify(c.b, c.a), expected)
                << name << ", seed " << seed;
        }
    }
}

TEST(TrianglePair, SharedPointsAreFiniteAndNearBothTriangles) {
    for (const std::string name : {"random",
                                   "random, both posed",
                                   "lattice: ties and degenerate ones",
                                   "lattice in one plane",
                                   "degenerate to segments and points"}) {
        const Maker make = makers().at(name);
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            std::mt19937_64 random(seed);
            const Case c = make(random);
            TrianglePairTest test(c.poses);
            const PairClass kind = test.classify(c.a, c.b);
            if (kind == PairClass::Separate) {
                continue;
            }
            const std::vector<Vec3> points = test.shared_points(c.a, c.b, kind);
            ASSERT_FALSE(points.empty()) << name << ", seed " << seed;
            ASSERT_LE(points.size(), 6u) << name << ", seed " << seed;
            // A point that both share is within rounding of both planes.
            const Vec3 origin = test.point_origin(c.a);
            for (const auto& [corners, pose] :
                 {std::pair{c.a, c.poses.a}, std::pair{c.b, c.poses.b}}) {
                const Vec3 normal =
                    pose.rotation() * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
                const Vec3 on_plane = pose.apply(corners[0]) - origin;
                for (const Vec3& point : points) {
                    ASSERT_TRUE(point.allFinite()) << name << ", seed " << seed;
                    EXPECT_LE(std::abs(normal.dot(point - on_plane)), 1e-9 * (1 + normal.norm()))
                        << name << ", seed " << seed;
                }
            }
        }
    }
}

TEST(TrianglePair, CrossingTrianglesShareASegment) {
    const Corners flat_one{Vec3(-1, -1, 0), Vec3(3, -1, 0), Vec3(-1, 3, 0)};
    const Corners upright{Vec3(0, 0, -1), Vec3(1, 0, -1), Vec3(0, 0, 1)};
    TrianglePairTest test(PosePair{});

    ASSERT_EQ(test.classify(flat_one, upright), PairClass::Proper);
    const auto points = test.shared_points(flat_one, upright, PairClass::Proper);

    ASSERT_EQ(points.size(), 2u);
    const double length = (points[1] - points[0]).norm();
    EXPECT_NEAR(length, 0.5, 1e-15);
}

TEST(TrianglePair, CoplanarOverlapIsAPolygon) {
    const Corners a{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const Corners b{Vec3(1, 1, 0), Vec3(5, 1, 0), Vec3(1, 5, 0)};
    TrianglePairTest test(PosePair{});

    ASSERT_EQ(test.classify(a, b), PairClass::Coplanar);
    EXPECT_EQ(test.shared_points(a, b, PairClass::Coplanar).size(), 3u);
}

TEST(TrianglePair, OrdinaryPairsAreDecidedInDouble) {
    std::mt19937_64 random(7);
    TrianglePairTest test(both_posed(random, 0.3));
    for (int i = 0; i < 10'000; ++i) {
        static_cast<void>(test.touches(random_corners(random, 1), random_corners(random, 1)));
    }
    EXPECT_EQ(test.statistics().by_double + test.statistics().by_exact, 10'000u);
    EXPECT_LE(test.statistics().by_exact, 5u);
}

} // namespace cd::tests
