#include "common/geometry/shared_points.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace cd {

namespace {

/// Drops points that equal the one before them, and a last that equals the first.
std::vector<Vec3> without_repeats(const std::vector<Vec3>& points) {
    std::vector<Vec3> distinct;
    for (const Vec3& point : points) {
        if (distinct.empty() || point != distinct.back()) {
            distinct.push_back(point);
        }
    }
    while (distinct.size() > 1 && distinct.front() == distinct.back()) {
        distinct.pop_back();
    }
    return distinct;
}

/// The point of triangle abc nearest to p: Ericson, Real-Time Collision Detection, section 5.1.5.
Vec3 nearest_on_triangle(const Vec3& p, const Corners& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = ab.dot(p - a);
    const double d2 = ac.dot(p - a);
    if (d1 <= 0 && d2 <= 0) {
        return a;
    }
    const double d3 = ab.dot(p - b);
    const double d4 = ac.dot(p - b);
    if (d3 >= 0 && d4 <= d3) {
        return b;
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        return a + ab * (d1 / (d1 - d3));
    }
    const double d5 = ab.dot(p - c);
    const double d6 = ac.dot(p - c);
    if (d6 >= 0 && d5 <= d6) {
        return c;
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        return a + ac * (d2 / (d2 - d6));
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    const double sum = va + vb + vc;
    return a + ab * (vb / sum) + ac * (vc / sum);
}

/// Where the edges of a triangle are nearest to the other one, for pairs whose shared point the
/// constructions below do not find: of all corners, the one closest to the other triangle.
Vec3 closest_corner(const Corners& a, const Corners& b) {
    Vec3 best = a[0];
    double best_distance = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Corners& corners, const Corners& other) {
        for (const Vec3& corner : corners) {
            const double distance = (nearest_on_triangle(corner, other) - corner).squaredNorm();
            if (distance < best_distance) {
                best_distance = distance;
                best = corner;
            }
        }
    };
    consider(a, b);
    consider(b, a);
    return best;
}

/// The part of a convex polygon on the inner side of each edge of a triangle: Sutherland and
/// Hodgman, Reentrant polygon clipping (1974), against planes through the edges along `normal`.
std::vector<Vec3> clip(std::vector<Vec3> polygon, const Corners& triangle, const Vec3& normal) {
    for (std::size_t i = 0; i < 3 && !polygon.empty(); ++i) {
        const Vec3& from = triangle[i];
        const Vec3 inward = normal.cross(triangle[(i + 1) % 3] - from);
        std::vector<Vec3> kept;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vec3& here = polygon[k];
            const Vec3& next = polygon[(k + 1) % polygon.size()];
            const double side = inward.dot(here - from);
            const double next_side = inward.dot(next - from);
            if (side >= 0) {
                kept.push_back(here);
            }
            if ((side > 0 && next_side < 0) || (side < 0 && next_side > 0)) {
                kept.emplace_back(here + (next - here) * (side / (side - next_side)));
            }
        }
        polygon = std::move(kept);
    }
    return polygon;
}

/// The two ends of what a triangle's plane cuts out of another triangle, ordered along `line`.
std::optional<std::array<Vec3, 2>>
cut_by_plane(const Corners& triangle, const Vec3& normal, const Vec3& on_plane, const Vec3& line) {
    std::array<double, 3> side{};
    for (std::size_t i = 0; i < 3; ++i) {
        side[i] = normal.dot(triangle[i] - on_plane);
    }
    std::optional<std::array<Vec3, 2>> ends;
    const auto add = [&](const Vec3& point) {
        if (!ends) {
            ends = {point, point};
        } else if (line.dot(point) < line.dot((*ends)[0])) {
            (*ends)[0] = point;
        } else if (line.dot(point) > line.dot((*ends)[1])) {
            (*ends)[1] = point;
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (side[i] == 0) {
            add(triangle[i]);
        }
        if ((side[i] > 0 && side[j] < 0) || (side[i] < 0 && side[j] > 0)) {
            add(triangle[i] + (triangle[j] - triangle[i]) * (side[i] / (side[i] - side[j])));
        }
    }
    return ends;
}

/// The overlap of both triangles' cuts on the line that their planes share.
std::vector<Vec3>
on_common_line(const Corners& a, const Corners& b, const Vec3& na, const Vec3& nb) {
    const Vec3 line = na.cross(nb);
    const auto on_a = cut_by_plane(a, nb, b[0], line);
    const auto on_b = cut_by_plane(b, na, a[0], line);
    if (!on_a || !on_b) {
        return {};
    }
    const Vec3& low = line.dot((*on_a)[0]) < line.dot((*on_b)[0]) ? (*on_b)[0] : (*on_a)[0];
    const Vec3& high = line.dot((*on_b)[1]) < line.dot((*on_a)[1]) ? (*on_b)[1] : (*on_a)[1];
    // Rounding may swap ends that are nearly one point.
    if (!(line.dot(low) < line.dot(high))) {
        return {low};
    }
    return {low, high};
}

/// A triangle without area against one with: the crossing of its plane, or what lies in it.
std::vector<Vec3> of_segment(const Corners& segment, const Corners& triangle, const Vec3& normal) {
    const auto cut = cut_by_plane(segment, normal, triangle[0], Vec3::Zero());
    const bool lies_in_plane = std::all_of(segment.begin(), segment.end(), [&](const Vec3& corner) {
        return normal.dot(corner - triangle[0]) == 0;
    });
    if (lies_in_plane) {
        return clip({segment[0], segment[1], segment[2]}, triangle, normal);
    }
    return cut ? std::vector<Vec3>{(*cut)[0]} : std::vector<Vec3>{};
}

/// The longest edge of a triangle without area: all of it.
std::array<Vec3, 2> longest_edge(const Corners& corners) {
    std::array<Vec3, 2> longest{corners[0], corners[1]};
    for (std::size_t i = 1; i < 3; ++i) {
        const Vec3& from = corners[i];
        const Vec3& to = corners[(i + 1) % 3];
        if ((to - from).squaredNorm() > (longest[1] - longest[0]).squaredNorm()) {
            longest = {from, to};
        }
    }
    return longest;
}

/// Where two segments that are not parallel cross; nothing for parallel ones.
std::vector<Vec3> of_segments(const Corners& a, const Corners& b) {
    const auto [a0, a1] = longest_edge(a);
    const auto [b0, b1] = longest_edge(b);
    const Vec3 direction_b = b1 - b0;
    const Vec3 n = (a1 - a0).cross(direction_b);
    const double along = (b0 - a0).cross(direction_b).dot(n) / n.squaredNorm();
    if (!std::isfinite(along)) {
        return {};
    }
    return {a0 + (a1 - a0) * std::clamp(along, 0.0, 1.0)};
}

bool are_nearly_parallel(const Vec3& na, const Vec3& nb) {
    return na.cross(nb).squaredNorm() <= 1e-24 * na.squaredNorm() * nb.squaredNorm();
}

std::vector<Vec3> construct(const Corners& a, const Corners& b, PairClass kind) {
    const Vec3 na = (a[1] - a[0]).cross(a[2] - a[0]);
    const Vec3 nb = (b[1] - b[0]).cross(b[2] - b[0]);
    const bool a_has_area = na != Vec3::Zero();
    const bool b_has_area = nb != Vec3::Zero();
    if (!a_has_area && !b_has_area) {
        return of_segments(a, b);
    }
    if (!a_has_area) {
        return of_segment(a, b, nb);
    }
    if (!b_has_area) {
        return of_segment(b, a, na);
    }
    if (kind == PairClass::Coplanar || are_nearly_parallel(na, nb)) {
        return clip({a[0], a[1], a[2]}, b, nb);
    }
    return on_common_line(a, b, na, nb);
}

bool all_finite(const std::vector<Vec3>& points) {
    return std::all_of(
        points.begin(), points.end(), [](const Vec3& point) { return point.allFinite(); });
}

} // namespace

std::vector<Vec3> approximate_shared_points(const Corners& a, const Corners& b, PairClass kind) {
    std::vector<Vec3> points = without_repeats(construct(a, b, kind));
    if (points.empty() || !all_finite(points)) {
        points = {closest_corner(a, b)};
    }
    return points;
}

} // namespace cd
