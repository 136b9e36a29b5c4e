// Points and poses in Bullet's floats.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <LinearMath/btTransform.h>

namespace cd::bench {

[[nodiscard]] inline btVector3 bullet_vector(const Vec3& p) {
    return {
        static_cast<btScalar>(p.x()), static_cast<btScalar>(p.y()), static_cast<btScalar>(p.z())};
}

[[nodiscard]] inline btTransform bullet_transform(const Pose& pose) {
    const Mat3 r = pose.rotation();
    const auto entry = [&](int i, int j) { return static_cast<btScalar>(r(i, j)); };
    return btTransform(btMatrix3x3(entry(0, 0),
                                   entry(0, 1),
                                   entry(0, 2),
                                   entry(1, 0),
                                   entry(1, 1),
                                   entry(1, 2),
                                   entry(2, 0),
                                   entry(2, 1),
                                   entry(2, 2)),
                       bullet_vector(pose.translation()));
}

} // namespace cd::bench
