#include "common/motion/body_path.hpp"

#include "common/core/errors.hpp"
#include "common/motion/key_grid.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

/// With a smaller scalar product of unit quaternions, the turn is within 2e-6 rad of 180 degrees.
constexpr double product_min = 0x1p-20;

bool is_key(const Pose& pose) {
    if (pose.kind() != Pose::Kind::Quaternion || !pose.is_finite()) {
        return false;
    }
    const double square = dot(pose.quaternion(), pose.quaternion());
    return square >= 0.5 && square <= 2;
}

} // namespace

double dot(const Quaternion& l, const Quaternion& r) {
    return ((l.w * r.w + l.x * r.x) + l.y * r.y) + l.z * r.z;
}

Result<BodyPath> path_between(const Pose& from, const Pose& to) {
    if (!is_key(from) || !is_key(to)) {
        return bad_input("a key of a motion is a finite position and a quaternion of norm 1");
    }
    const Quaternion& q0 = from.quaternion();
    const Quaternion& q1 = to.quaternion();
    const double product = dot(q0, q1);
    if (!(std::abs(product) >= product_min)) {
        return bad_input("two keys of a motion are turned by 180 degrees against each other; "
                         "insert a key between them");
    }
    const Quaternion near = product > 0 ? q1 : Quaternion{-q1.w, -q1.x, -q1.y, -q1.z};
    return BodyPath{q0, near, from.translation(), to.translation()};
}

bool has_exact_poses(const BodyPath& path, unsigned bits) {
    const KeyGrid grid{bits, std::max(grid_exponent(path.c0), grid_exponent(path.c1))};
    return grid.holds(Pose::from_quaternion(path.q0, path.c0)) &&
           grid.holds(Pose::from_quaternion(path.q1, path.c1));
}

Pose pose_at(const BodyPath& path, double tau) {
    const double rest = 1 - tau;
    const auto between = [&](double from, double to) { return rest * from + tau * to; };
    const Quaternion& q0 = path.q0;
    const Quaternion& q1 = path.q1;
    return Pose::from_quaternion(
        {between(q0.w, q1.w), between(q0.x, q1.x), between(q0.y, q1.y), between(q0.z, q1.z)},
        {between(path.c0.x(), path.c1.x()),
         between(path.c0.y(), path.c1.y()),
         between(path.c0.z(), path.c1.z())});
}

} // namespace cd
