#include "client/import/polygon_cut.hpp"

#include "common/core/limits/client.hpp"
#include "common/pair/numbers/orientation.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace cd {

namespace {

using Point = PlanePoint;

/// Newell's normal of a polygon (`sum`, as long as twice the area), and the sum of the absolute
/// values of its terms (`sizes`), which gives a plane even if the area is zero.
struct Normal {
    Vec3 sum = Vec3::Zero();
    Vec3 sizes = Vec3::Zero();
};

Normal normal_of(std::span<const Vec3> corners) {
    Normal normal;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vec3 from_first = corners[i] - corners[0];
        const Vec3 twice_area = from_first.cross(corners[i + 1] - corners[0]);
        normal.sum += twice_area;
        normal.sizes += twice_area.cwiseAbs();
    }
    return normal;
}

/// True if the two angles between the diagonal and the sides at this corner sum to more than 180
/// degrees: cos a + cos b < 0. At most one corner of a plane quadrilateral is concave.
bool is_concave(std::span<const Vec3> quad, std::uint32_t corner) {
    const Vec3 right = quad[(corner + 1) % 4] - quad[corner];
    const Vec3 diagonal = quad[(corner + 2) % 4] - quad[corner];
    const Vec3 left = quad[(corner + 3) % 4] - quad[corner];
    return left.dot(diagonal) * right.norm() + right.dot(diagonal) * left.norm() < 0;
}

} // namespace

std::span<const Triangle> PolygonCutter::cut(std::span<const Vec3> corners) {
    triangles_.clear();
    tests_ = 0;
    project(corners);
    if (corners.size() == 4) {
        cut_quad(corners);
    } else {
        cut_ears();
    }
    return triangles_;
}

/// Projects the corners onto a coordinate plane, oriented so that the polygon is counterclockwise.
void PolygonCutter::project(std::span<const Vec3> corners) {
    const Normal normal = normal_of(corners);
    Eigen::Index axis = 0;
    normal.sizes.maxCoeff(&axis);
    Eigen::Index first = (axis + 1) % 3;
    Eigen::Index second = (axis + 2) % 3;
    if (normal.sum[axis] < 0) {
        std::swap(first, second);
    }
    points_.clear();
    for (const Vec3& corner : corners) {
        points_.push_back({corner[first], corner[second]});
    }
}

int PolygonCutter::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation(points_[a], points_[b], points_[c]);
}

/// Adds the two triangles of the fan around a corner, unless one has the wrong orientation.
void PolygonCutter::try_quad(std::uint32_t start) {
    const std::uint32_t right = (start + 1) % 4;
    const std::uint32_t opposite = (start + 2) % 4;
    const std::uint32_t left = (start + 3) % 4;
    if (turn(start, right, opposite) >= 0 && turn(start, opposite, left) >= 0) {
        triangles_ = {{start, right, opposite}, {start, opposite, left}};
    }
}

void PolygonCutter::cut_quad(std::span<const Vec3> corners) {
    std::uint32_t start = 0;
    while (start < 4 && !is_concave(corners, start)) {
        ++start;
    }
    start %= 4;
    try_quad(start);
    if (triangles_.empty()) {
        try_quad((start + 1) % 4);
    }
}

void PolygonCutter::cut_ears() {
    const auto size = static_cast<std::uint32_t>(points_.size());
    next_.resize(size);
    previous_.resize(size);
    is_convex_.resize(size);
    for (std::uint32_t i = 0; i < size; ++i) {
        next_[i] = (i + 1) % size;
        previous_[i] = (i + size - 1) % size;
    }
    for (std::uint32_t i = 0; i < size; ++i) {
        classify(i);
    }
    const std::uint64_t tests_max = limits::polygon_tests_per_corner_max * size;
    std::uint32_t left = size;
    std::uint32_t tried = 0;
    bool takes_straight = false; // True while no ear is left: cuts off straight corners too.
    std::uint32_t corner = 0;
    while (left > 3 && tests_ <= tests_max) {
        const bool is_straight =
            takes_straight && turn(previous_[corner], corner, next_[corner]) == 0;
        if (is_straight || is_ear(corner)) {
            triangles_.push_back({previous_[corner], corner, next_[corner]});
            unlink(corner);
            --left;
            tried = 0;
            takes_straight = false;
        } else if (++tried == left) {
            if (takes_straight) {
                break;
            }
            tried = 0;
            takes_straight = true;
        }
        corner = next_[corner];
    }
    if (left > 3) {
        triangles_.clear();
        return;
    }
    add_last(corner);
}

bool PolygonCutter::is_ear(std::uint32_t corner) {
    if (is_convex_[corner] == 0) {
        return false;
    }
    const Triangle ear{previous_[corner], corner, next_[corner]};
    for (std::uint32_t i = next_[ear[2]]; i != ear[0]; i = next_[i]) {
        ++tests_;
        if (is_convex_[i] == 0 && contains(ear, i)) {
            return false;
        }
    }
    return true;
}

/// True if a corner is inside an ear or on an edge of it, but not at one of its corners.
bool PolygonCutter::contains(const Triangle& ear, std::uint32_t corner) const {
    const Point& point = points_[corner];
    const bool is_at_corner =
        std::any_of(ear.begin(), ear.end(), [&](std::uint32_t i) { return points_[i] == point; });
    return !is_at_corner && turn(ear[0], ear[1], corner) >= 0 &&
           turn(ear[1], ear[2], corner) >= 0 && turn(ear[2], ear[0], corner) >= 0;
}

void PolygonCutter::classify(std::uint32_t corner) {
    is_convex_[corner] = turn(previous_[corner], corner, next_[corner]) > 0 ? 1 : 0;
}

void PolygonCutter::unlink(std::uint32_t corner) {
    const std::uint32_t before = previous_[corner];
    const std::uint32_t after = next_[corner];
    next_[before] = after;
    previous_[after] = before;
    classify(before);
    classify(after);
}

/// Adds the triangle of the last three corners, unless its orientation is wrong.
void PolygonCutter::add_last(std::uint32_t corner) {
    Triangle last{corner, next_[corner], previous_[corner]};
    std::rotate(last.begin(), std::min_element(last.begin(), last.end()), last.end());
    if (turn(last[0], last[1], last[2]) < 0) {
        triangles_.clear();
        return;
    }
    triangles_.push_back(last);
}

} // namespace cd
