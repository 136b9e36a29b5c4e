// Keys and motions for tests.
#pragma once

#include "common/motion/motion.hpp"
#include "common/motion/motion_keys.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace cd::tests {

/// Returns the pose of a body that is turned about an axis of length 1.
[[nodiscard]] inline Pose
turned_pose(double degrees, const Vec3& axis, const Vec3& place = Vec3::Zero()) {
    const double half = degrees * (3.14159265358979323846 / 360);
    const Vec3 v = std::sin(half) * axis;
    return Pose::from_quaternion({std::cos(half), v.x(), v.y(), v.z()}, place);
}

/// Returns a pose that is moved but not turned.
[[nodiscard]] inline Pose moved_pose(const Vec3& place) {
    return Pose::from_quaternion({}, place);
}

/// Rounds both keys, which must be valid, and makes the motion between them.
[[nodiscard]] inline Motion
make_motion(const PosePair& from, const PosePair& to, const BodyRadii& radii, double resolution) {
    const auto keys = round_keys(std::array{from, to}, radii, resolution);
    EXPECT_TRUE(keys) << (keys ? "" : keys.error().detail);
    const auto& rounded = keys.value().keys;
    const auto motion = Motion::create(rounded[0], rounded[1], radii, resolution);
    EXPECT_TRUE(motion) << (motion ? "" : motion.error().detail);
    return motion.value();
}

/// Returns a random axis of length 1, within roundings.
[[nodiscard]] inline Vec3 random_axis(std::mt19937_64& random) {
    Vec3 axis;
    do {
        axis = random_point(random, 1);
    } while (axis.norm() < 0.1 || axis.norm() > 1);
    return axis / axis.norm();
}

/// Returns a key that differs from `pose`, which has a quaternion, by a turn and a move in the
/// world.
[[nodiscard]] inline Pose
key_after(const Pose& pose, double degrees, const Vec3& axis, const Vec3& move) {
    const Pose turn = turned_pose(degrees, axis);
    return Pose::from_quaternion(turn.quaternion() * pose.quaternion(), pose.translation() + move);
}

} // namespace cd::tests
