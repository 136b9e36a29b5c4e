// Proves that the margins of the wide descent suffice: it misses no triangles that touch in one
// point at the border of a box. Also proves that they are needed: with smaller margins such pairs
// are lost.

#include "common/distance/triangle_distance.hpp"
#include "common/geometry/reach.hpp"
#include "common/pair/triangle_pair.hpp"
#include "common/tree/wide/wide_descent.hpp"
#include "tests/common/tree/exact_box.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

/// Two bodies that touch only in one corner of a triangle each.
struct Brink {
    ObbTree a;
    ObbTree b;
    PosePair poses;
    std::uint32_t triangle_a = 0;
    std::uint32_t triangle_b = 0;
    Vec3 outwards = Vec3::Zero(); ///< From A to B in the world: along it they are apart elsewhere.
    double clearance = 0;         ///< The distance of the two corners.
};

using Aim = WideDescent::Aim;

/// A descent for the nearest pair compares projections on the direction in which the bodies part.
bool is_kept(const Brink& brink, double error_scale, Aim aim) {
    const WideView a = brink.a.view().wide;
    const WideView b = brink.b.view().wide;
    WideDescent descent(relative_pose(brink.poses), error_scale);
    descent.restart(relative_pose(brink.poses), body_reach(brink.poses, brink.clearance));
    descent.start(a, b, aim);
    descent.set_direction(brink.poses.a.rotation().transpose() * brink.outwards);
    while (!descent.is_done()) {
        for (const Candidate& pair : descent.next(256)) {
            if (a.triangles.ids[pair.a] == brink.triangle_a &&
                b.triangles.ids[pair.b] == brink.triangle_b) {
                return true;
            }
        }
    }
    return false;
}

using Brinks = std::vector<Brink>;

/// Counts touching bodies that the descent misses.
std::size_t lost_of(const Brinks& brinks, double error_scale, Aim aim = Aim::All) {
    return static_cast<std::size_t>(std::ranges::count_if(
        brinks, [&](const Brink& brink) { return !is_kept(brink, error_scale, aim); }));
}

/// Makes them with `maker` from many seeds and checks that they touch.
template <class Maker>
Brinks brinks_of(std::uint64_t rounds, const Maker& maker) {
    Brinks brinks;
    for (SeededRandom random : seeds(rounds)) {
        std::optional<Brink> brink = maker(random);
        if (!brink) {
            continue;
        }
        EXPECT_NE(TrianglePairTest(brink->poses)
                      .classify(brink->a.mesh().corners(brink->triangle_a),
                                brink->b.mesh().corners(brink->triangle_b)),
                  PairClass::Separate);
        brinks.push_back(std::move(*brink));
    }
    return brinks;
}

/// A rotation and a factor: it maps corners that are multiples of the factor to few bits.
struct Turn {
    Pose pose;
    double factor;
};

Turn any_turn(std::mt19937_64& random) {
    const auto small = [&] { return static_cast<double>(random() % 9) - 4; };
    switch (random() % 3) {
    case 0: { // Divided by its norm.
        const Quaternion q{1 + static_cast<double>(random() % 4), small(), small(), small()};
        return {Pose::from_quaternion(q, Vec3::Zero()),
                q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z};
    }
    case 1: { // A matrix of few bits, hardly skew.
        const Mat3 turn = make_pose(random, 1).rotation();
        return {Pose::from_matrix(turn.unaryExpr([](double entry) {
                    return std::nearbyint(0x1p26 * entry) / 0x1p26;
                }),
                                  Vec3::Zero()),
                1};
    }
    default:
        return {Pose{}, 1};
    }
}

/// Makes a rotation that only permutes axes.
Pose any_exchange(std::mt19937_64& random) {
    Mat3 matrix = Mat3::Zero();
    const int shift = static_cast<int>(random() % 3);
    for (int i = 0; i < 3; ++i) {
        matrix(i, (i + shift) % 3) = 1;
    }
    if (random() % 2 == 0) {
        matrix.row(0) = -matrix.row(0);
        matrix.row(1) = -matrix.row(1);
    }
    return Pose::from_matrix(matrix, Vec3::Zero());
}

/// Makes triangles with unshared corners around a position, all on a lattice.
Mesh lattice_soup(std::mt19937_64& random,
                  std::uint32_t count,
                  double size,
                  double factor,
                  double far,
                  int bits) {
    const double unit = std::exp2(std::floor(std::log2(size / factor)) - bits);
    const auto lattice = [&](double half_width) {
        return std::nearbyint(uniform(random, -half_width, half_width) / (unit * factor)) * unit *
               factor;
    };
    const Vec3 place(lattice(far), lattice(far), lattice(far));
    std::vector<Vec3> corners;
    for (std::uint32_t i = 0; i < 3 * count; ++i) {
        corners.push_back(place + Vec3(lattice(size), lattice(size), lattice(size)));
    }
    return make_soup(std::move(corners));
}

/// Returns the extreme vertex in a direction.
std::uint32_t last_along(const Mesh& mesh, const Vec3& direction) {
    std::uint32_t last = 0;
    for (std::uint32_t i = 1; i < mesh.vertices().size(); ++i) {
        if (direction.dot(mesh.vertices()[i] - mesh.vertices()[last]) > 0) {
            last = i;
        }
    }
    return last;
}

/// Returns the pose with that rotation that maps `from` to `to`, if doubles represent it.
std::optional<Pose> moved_to(const Pose& rotation, const Vec3& from, const ExactVec& to) {
    const ExactVec turned = exact_rotation(rotation) * exact(from);
    Vec3 translation;
    for (std::size_t k = 0; k < 3; ++k) {
        const Rational wanted = to[k] - turned[k];
        const auto rounded = static_cast<double>(wanted);
        if (Rational(rounded) != wanted) {
            return std::nullopt;
        }
        translation[static_cast<int>(k)] = rounded;
    }
    return with_translation(rotation, translation);
}

/// A body with a triangle whose plane is on the border of its box, to the last bits, on one side of
/// x.
struct SharpBody {
    Mesh mesh;
    double plane;
};

/// Makes three triangles across the x axis, the last one at `plane`.
Mesh across_x(double size, double plane) {
    std::vector<Vec3> corners;
    for (const double x : {0.0, size, plane}) {
        corners.insert(corners.end(),
                       {Vec3(x, -size, -size), Vec3(x, size, -size), Vec3(x, 0, size)});
    }
    return make_soup(std::move(corners));
}

/// Returns how far the last triangle's box extends beyond it on the x side `side`; nothing if the
/// box is not along x.
std::optional<Rational> slack_of(const Mesh& mesh, double plane, int side) {
    const ObbTree tree = make_tree(mesh);
    const WideView wide = tree.view().wide;
    const WideNode& node = wide.nodes[0];
    for (std::size_t k = 0; k < 3; ++k) {
        if (std::abs(node.columns[0][k]) != 1 || node.columns[1][k] != 0 ||
            node.columns[2][k] != 0) {
            continue;
        }
        std::size_t child = 0;
        while (wide.triangles.ids[child] != 2) {
            ++child;
        }
        const bool is_high = (node.columns[0][k] > 0) == (side > 0);
        const int byte = is_high ? node.high[k][child] : node.low[k][child];
        const Rational place =
            Rational(node.columns[0][k]) * (Rational(plane) - Rational(node.origin[0]));
        return abs(Rational(node.steps[k]) * byte - place);
    }
    return std::nullopt;
}

std::optional<SharpBody> sharp_body(std::mt19937_64& random, double size, int side) {
    // Between two planes more than a step apart the box jumps. Its slack falls to nothing towards
    // the jump and is nearly a step beyond it.
    double low = uniform(random, 0.1, 0.8) * size;
    double high = low + size / 200;
    const auto slack = [&](double plane) {
        return slack_of(across_x(size, plane), plane, side).value_or(Rational(size));
    };
    const double at_low = low;
    const Rational slack_at_low = slack(low);
    // Slack falls with the plane's position for side 1 and rises for side -1.
    for (int i = 0; i < 54; ++i) {
        const double middle = 0.5 * low + 0.5 * high;
        const Rational without_jump = slack_at_low - side * (Rational(middle) - Rational(at_low));
        const bool has_jumped = abs(slack(middle) - without_jump) > Rational(size / 1000);
        (has_jumped ? high : low) = middle;
    }
    const double plane = side > 0 ? low : high;
    if (slack(plane) > Rational(0x1p-40 * size)) {
        return std::nullopt;
    }
    return SharpBody{across_x(size, plane), plane};
}

/// A small and a far larger body share one corner and are otherwise apart along an axis of the
/// small one's frame: the larger one's errors are as large as the small one's steps. `far`: the
/// large one's distance from its origin, in its sizes; coordinates have `bits` bits.
std::optional<Brink> corner_on_corner(std::mt19937_64& random, double far, int bits) {
    const bool is_far = far > 0;
    const double ratio = std::ldexp(1.0, is_far ? 8 : static_cast<int>(random() % 12) + 8);
    const Turn turn_small = is_far ? Turn{any_exchange(random), 1} : any_turn(random);
    const Turn turn_large = any_turn(random);
    const auto triangles = [&] { return static_cast<std::uint32_t>(1 + random() % 4); };
    const Mesh small = lattice_soup(random, triangles(), 1, turn_small.factor, 0, bits);
    const Mesh large =
        lattice_soup(random, triangles(), ratio, turn_large.factor, far * ratio, bits);
    const ObbTree tree = make_tree(small);
    const auto& columns = tree.view().wide.nodes[0].columns;
    const auto k = random() % 3;
    const double sign = random() % 2 == 0 ? 1 : -1;
    const Vec3 axis(columns[0][k], columns[1][k], columns[2][k]);
    const Vec3 outwards = sign * (turn_small.pose.rotation() * axis);
    const std::uint32_t last = last_along(small, turn_small.pose.rotation().transpose() * outwards);
    const std::uint32_t first =
        last_along(large, -(turn_large.pose.rotation().transpose() * outwards));
    const ExactVec shared = exact_rotation(turn_small.pose) * exact(small.vertices()[last]);
    const auto pose = moved_to(turn_large.pose, large.vertices()[first], shared);
    if (!pose) {
        return std::nullopt;
    }
    if (random() % 2 == 0) {
        return Brink{
            tree, make_tree(large), {turn_small.pose, *pose}, last / 3, first / 3, outwards};
    }
    return Brink{make_tree(large), tree, {*pose, turn_small.pose}, first / 3, last / 3, -outwards};
}

/// A small body's corner touches a large one's triangle on the border of its box.
std::optional<Brink> corner_on_plane(std::mt19937_64& random) {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 8) + 12);
    const int side = random() % 2 == 0 ? 1 : -1;
    const auto large = sharp_body(random, size, side);
    if (!large) {
        return std::nullopt;
    }
    const Turn turn = any_turn(random);
    const Mesh small = lattice_soup(random, 1, 1, turn.factor, 0, 6);
    const Pose exchange = any_exchange(random);
    const Vec3 outwards = side * exchange.matrix().col(0);
    const std::uint32_t last = last_along(small, -(turn.pose.rotation().transpose() * outwards));
    const ExactVec shared = exact_rotation(turn.pose) * exact(small.vertices()[last]);
    const auto pose = moved_to(exchange, Vec3(large->plane, 0, 0), shared);
    if (!pose) {
        return std::nullopt;
    }
    if (random() % 2 == 0) {
        return Brink{make_tree(small), make_tree(large->mesh), {turn.pose, *pose}, 0, 2, -outwards};
    }
    return Brink{make_tree(large->mesh), make_tree(small), {*pose, turn.pose}, 2, 0, outwards};
}

/// Moves the bodies apart by a share of the smaller body's size. Leaves out those whose corners are
/// then farther apart than that, because of rounding.
Brinks moved_apart(const Brinks& brinks, double share) {
    Brinks moved;
    for (Brink brink : brinks) {
        brink.clearance = share;
        const Vec3 translation = brink.poses.b.translation() + share * brink.outwards;
        brink.poses.b = with_translation(brink.poses.b, translation);
        if (TriangleDistance(brink.poses)
                .is_within(brink.a.mesh().corners(brink.triangle_a),
                           brink.b.mesh().corners(brink.triangle_b),
                           brink.clearance)) {
            moved.push_back(std::move(brink));
        }
    }
    return moved;
}

/// Bodies that touch in one point. Made once for all targets.
struct AllBrinks {
    Brinks corners = brinks_of(600, [](auto& random) { return corner_on_corner(random, 0, 10); });
    /// Their corners exceed float precision.
    Brinks doubles = brinks_of(600, [](auto& random) { return corner_on_corner(random, 0, 28); });
    Brinks far = brinks_of(400, [](auto& random) { return corner_on_corner(random, 0x1p38, 3); });
    Brinks borders = brinks_of(250, corner_on_plane);
};

TEST(WideBounds, BodiesThatTouchAtTheBrinkAreNotLostButSomeAreWithSmallerMargins) {
    const AllBrinks all;
    EXPECT_GT(all.corners.size(), 400u);
    EXPECT_GT(all.doubles.size(), 300u);
    EXPECT_GT(all.far.size(), 200u);
    EXPECT_GT(all.borders.size(), 150u);
    for (const Brink& brink : all.doubles) {
        EXPECT_FALSE(brink.a.view().wide.triangles.doubles.empty());
        EXPECT_FALSE(brink.b.view().wide.triangles.doubles.empty());
    }
    on_every_target([&](SimdTarget target) {
        EXPECT_EQ(lost_of(all.corners, 1), 0u);
        EXPECT_EQ(lost_of(all.doubles, 1), 0u) << "corners that floats cannot hold";
        EXPECT_EQ(lost_of(all.far, 1), 0u) << "far from a body's origin";
        EXPECT_EQ(lost_of(all.borders, 1), 0u) << "on the border of a box";
        // If boxes are bytes on both sides, only those that end on whole steps are sharp.
        EXPECT_GT(lost_of(all.borders, 0), 0u);
        EXPECT_GT(lost_of(all.borders, -0.01), 50u);
        if (target == SimdTarget::Avx512 || target == SimdTarget::Avx2) {
            // The larger body's triangles are bounded by their corners.
            EXPECT_GT(lost_of(all.corners, 0), 50u);
            EXPECT_GT(lost_of(all.corners, 0.003), 0u);
            EXPECT_GT(lost_of(all.doubles, 0), 50u);
            EXPECT_GT(lost_of(all.doubles, 0.003), 0u);
        }
        for (const Brinks* brinks : {&all.corners, &all.doubles, &all.far, &all.borders}) {
            EXPECT_EQ(lost_of(*brinks, 1, Aim::Nearest), 0u) << "along a direction";
        }
        // Far from the origin a body's steps exceed the rounding errors, and none of these boxes
        // ends on a whole step: margins of 0 would suffice here, but not less.
        EXPECT_GT(lost_of(all.far, -0.02), 5u);
    });
}

TEST(WideBounds, MarginsAreNeededAlongADirectionThatPartsBodies) {
    const Brinks corners =
        brinks_of(600, [](auto& random) { return corner_on_corner(random, 0, 10); });
    on_every_target([&](SimdTarget target) {
        const std::size_t by_boxes = lost_of(corners, 0);
        const std::size_t with_direction = lost_of(corners, 0, Aim::Nearest);
        if (target == SimdTarget::Avx512 || target == SimdTarget::Avx2) {
            EXPECT_GT(with_direction, by_boxes + 20) << by_boxes;
        }
    });
}

TEST(WideBounds, CornersAsFarApartAsTheReachAreNotLostButSomeAreWithSmallerMargins) {
    const Brinks touching =
        brinks_of(600, [](auto& random) { return corner_on_corner(random, 0, 10); });
    for (const double share : {1e-3, 0.1}) {
        const Brinks brinks = moved_apart(touching, share);
        EXPECT_GT(brinks.size(), 100u);
        on_every_target([&](SimdTarget target) {
            EXPECT_EQ(lost_of(brinks, 1), 0u);
            EXPECT_EQ(lost_of(brinks, 1, Aim::Nearest), 0u);
            if (target == SimdTarget::Avx512 || target == SimdTarget::Avx2) {
                EXPECT_GT(lost_of(brinks, 0), 0u);
                EXPECT_GT(lost_of(brinks, 0.003, Aim::Nearest), 0u) << "along a direction";
            }
        });
    }
}

} // namespace

} // namespace cd::tests
