// Axis-aligned bounding boxes (AABB), for sizes and for the first step of the broad phase.
#pragma once

#include "common/geometry/types.hpp"

#include <limits>
#include <span>

namespace cd {

/// The smallest closed box around all points added so far; empty without points.
struct Aabb {
    Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 max = Vec3::Constant(-std::numeric_limits<double>::infinity());

    void add(const Vec3& point) {
        min = min.cwiseMin(point);
        max = max.cwiseMax(point);
    }
    [[nodiscard]] bool is_empty() const { return !(min.x() <= max.x()); }
    [[nodiscard]] Vec3 size() const { return is_empty() ? Vec3(Vec3::Zero()) : Vec3(max - min); }
    [[nodiscard]] Vec3 center() const { return 0.5 * min + 0.5 * max; }
    [[nodiscard]] double diagonal() const { return size().stableNorm(); }
};

[[nodiscard]] inline Aabb bounding_box(std::span<const Vec3> points) {
    Aabb box;
    for (const Vec3& point : points) {
        box.add(point);
    }
    return box;
}

/// Returns true if two closed boxes share no point. A NaN bound separates no boxes.
[[nodiscard]] inline bool are_apart(const Aabb& a, const Aabb& b) {
    return a.max.x() < b.min.x() || a.min.x() > b.max.x() || a.max.y() < b.min.y() ||
           a.min.y() > b.max.y() || a.max.z() < b.min.z() || a.min.z() > b.max.z();
}

} // namespace cd
