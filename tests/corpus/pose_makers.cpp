#include "tests/corpus/pair_makers.hpp"
#include "tests/support/shapes.hpp"

#include <array>
#include <utility>

namespace cd::tests {

namespace {

/// Returns the rotation matrix about an axis with this sine and cosine.
Mat3 turn_about(int axis, double sine, double cosine) {
    Mat3 turn = Mat3::Zero();
    turn(axis, axis) = 1;
    turn((axis + 1) % 3, (axis + 1) % 3) = cosine;
    turn((axis + 2) % 3, (axis + 2) % 3) = cosine;
    turn((axis + 1) % 3, (axis + 2) % 3) = -sine;
    turn((axis + 2) % 3, (axis + 1) % 3) = sine;
    return turn;
}

Quaternion quaternion_about(int axis, double sine, double cosine) {
    return {cosine, axis == 0 ? sine : 0, axis == 1 ? sine : 0, axis == 2 ? sine : 0};
}

/// Cosine and sine of 90, 45 and 22.5 degrees as programs compute them.
constexpr double cosine_of_half_pi = 6.123233995736766e-17;
constexpr double root_of_half = 0.70710678118654757;
constexpr double cosine_of_eighth_pi = 0.92387953251128674;
constexpr double sine_of_eighth_pi = 0.38268343236508977;

Pose quarter_turn(std::mt19937_64& random, bool exact) {
    const int axis = static_cast<int>(random() % 3);
    const double sine = random() % 2 == 0 ? 1 : -1;
    const Vec3 offset = lattice_point(random, 2);
    if (random() % 2 == 0) {
        return Pose::from_matrix(turn_about(axis, sine, exact ? 0 : cosine_of_half_pi), offset);
    }
    // Any two equal parts make the turn exact; a last digit off in one makes it rounded.
    const double half = exact ? 1 : root_of_half;
    const double other = exact ? 1 : 0.70710678118654746;
    return Pose::from_quaternion(quaternion_about(axis, sine * half, other), offset);
}

Pose eighth_turn(std::mt19937_64& random) {
    const int axis = static_cast<int>(random() % 3);
    const double sine = random() % 2 == 0 ? 1 : -1;
    const Vec3 offset = lattice_point(random, 2);
    if (random() % 2 == 0) {
        return Pose::from_matrix(turn_about(axis, sine * root_of_half, root_of_half), offset);
    }
    const Quaternion q = quaternion_about(axis, sine * sine_of_eighth_pi, cosine_of_eighth_pi);
    return Pose::from_quaternion(q, offset);
}

PosedPair lattice_pair(std::mt19937_64& random) {
    return {lattice_corners(random, 2), lattice_corners(random, 2), {}};
}

/// Diagonal lattice edges, turned by 45 degrees, are nominally along its axes.
PosedPair under_eighth_turns(std::mt19937_64& random) {
    PosedPair pair = lattice_pair(random);
    pair.poses.b = eighth_turn(random);
    if (random() % 2 == 0) {
        pair.poses.a = eighth_turn(random);
    }
    return pair;
}

PosedPair under_quarter_turns(std::mt19937_64& random, bool exact) {
    PosedPair pair = lattice_pair(random);
    pair.poses.b = quarter_turn(random, exact);
    if (random() % 2 == 0) {
        pair.poses.a = quarter_turn(random, exact);
    }
    return pair;
}

/// Writes one rotation in two ways: the bodies touch as if unturned.
PosedPair written_twice(std::mt19937_64& random) {
    PosedPair pair = lattice_pair(random);
    const Vec3 offset = random_point(random, 10);
    if (random() % 2 == 0) {
        const Quaternion q = make_pose(random, 0).quaternion();
        pair.poses = {Pose::from_quaternion(q, offset),
                      Pose::from_quaternion({-2 * q.w, -2 * q.x, -2 * q.y, -2 * q.z}, offset)};
    } else {
        const int axis = static_cast<int>(random() % 3);
        pair.poses = {Pose::from_matrix(turn_about(axis, 1, 0), offset),
                      Pose::from_quaternion(quaternion_about(axis, 3, 3), offset)};
    }
    return pair;
}

/// Integer quaternions are exact rational rotations, such as those of 3-4-5 triangles.
PosedPair rational_turns(std::mt19937_64& random) {
    PosedPair pair = lattice_pair(random);
    const auto whole_pose = [&] {
        const auto entry = [&] { return static_cast<double>(random() % 5) - 2; };
        Quaternion q;
        q.x = entry();
        q.y = entry();
        q.z = entry();
        q.w = entry() + 3;
        return Pose::from_quaternion(q, lattice_point(random, 2));
    };
    pair.poses.a = whole_pose();
    pair.poses.b = random() % 2 == 0 ? whole_pose() : pair.poses.a;
    return pair;
}

/// Exact contacts within one body, moved apart and back by rounded poses of both kinds.
PosedPair touching_but_posed(std::mt19937_64& random) {
    PosedPair pair{random_corners(random, 1), random_corners(random, 1), {}};
    pair.b[0] = point_on(random, pair.a);
    pair.poses.a = make_pose(random, 1);
    pair.poses.b = Pose::from_matrix(pair.poses.a.rotation(), pair.poses.a.translation());
    return shuffled(random, pair);
}

} // namespace

void add_pose_makers(PairMakers& makers) {
    makers["quarter turns, exact"] = [](auto& r) { return under_quarter_turns(r, true); };
    makers["quarter turns, rounded"] = [](auto& r) { return under_quarter_turns(r, false); };
    makers["eighth turns, rounded"] = under_eighth_turns;
    makers["one rotation written in two ways"] = written_twice;
    makers["rational rotations"] = rational_turns;
    makers["a quaternion and its rounded matrix"] = touching_but_posed;
}

} // namespace cd::tests
