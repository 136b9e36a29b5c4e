#include "common/geometry/shared_points.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace cd {

namespace {

constexpr std::size_t points_max = 6; ///< Corners of what two triangles can share.

/// Coordinates are scaled to at most 1, so this is what some roundings can move a point.
constexpr double rounding_reach = 0x1p-48;

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

/// Clipping along an edge that rounding has bent can make more corners than there are; neighbours
/// are then within rounding of each other, and one of the closest goes.
void merge_surplus(std::vector<Vec3>& points) {
    while (points.size() > points_max) {
        std::size_t closest = 0;
        double closest_distance = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double distance = (points[(i + 1) % points.size()] - points[i]).squaredNorm();
            if (distance < closest_distance) {
                closest_distance = distance;
                closest = i;
            }
        }
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(closest));
    }
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

/// The point of segment p0 p1 nearest to segment q0 q1: Ericson, section 5.1.9.
Vec3 nearest_on_segment(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
    const Vec3 d1 = p1 - p0;
    const Vec3 d2 = q1 - q0;
    const Vec3 r = p0 - q0;
    const double a = d1.squaredNorm();
    const double e = d2.squaredNorm();
    if (a == 0) {
        return p0;
    }
    const double c = d1.dot(r);
    const double b = d1.dot(d2);
    const double f = d2.dot(r);
    const double denominator = a * e - b * b;
    double s = denominator > 0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    const double t = e > 0 ? std::clamp((b * s + f) / e, 0.0, 1.0) : 0.0;
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
    return p0 + d1 * s;
}

/// A point of one triangle that is nearest to the other, for pairs whose shared points rounding
/// hides from the constructions below. Two triangles are nearest at a corner of one or on an edge
/// of each.
Vec3 nearest_point(const Corners& a, const Corners& b) {
    Vec3 best = a[0];
    double best_distance = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Vec3& point, const Corners& other) {
        const double distance = (nearest_on_triangle(point, other) - point).squaredNorm();
        if (distance < best_distance) {
            best_distance = distance;
            best = point;
        }
    };
    for (const Vec3& corner : a) {
        consider(corner, b);
    }
    for (const Vec3& corner : b) {
        consider(corner, a);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            consider(nearest_on_segment(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]), b);
        }
    }
    return best;
}

/// n.(x - on), or 0 where rounding could have made it.
double side_of(const Vec3& x, const Vec3& normal, const Vec3& on) {
    const double side = normal.dot(x - on);
    return std::abs(side) <= rounding_reach * normal.norm() ? 0 : side;
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
            const double side = side_of(here, inward, from);
            const double next_side = side_of(next, inward, from);
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
        side[i] = side_of(triangle[i], normal, on_plane);
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

/// The two ends of points on a line.
std::vector<Vec3> ends_along(const Vec3& direction, const std::vector<Vec3>& points) {
    const auto before = [&](const Vec3& l, const Vec3& r) {
        return direction.dot(l) < direction.dot(r);
    };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), before);
    return points.empty() ? std::vector<Vec3>{} : std::vector<Vec3>{*low, *high};
}

/// A triangle without area against one with: the crossing of its plane, or what lies in it.
std::vector<Vec3> of_segment(const Corners& segment, const Corners& triangle, const Vec3& normal) {
    const auto [from, to] = longest_edge(segment);
    const double side = side_of(from, normal, triangle[0]);
    const double other_side = side_of(to, normal, triangle[0]);
    if (side == 0 && other_side == 0) {
        return ends_along(to - from, clip({from, to}, triangle, normal));
    }
    if ((side > 0) == (other_side > 0) && side != 0 && other_side != 0) {
        return {};
    }
    return {from + (to - from) * (side / (side - other_side))};
}

/// True for a zero vector too.
bool are_nearly_parallel(const Vec3& l, const Vec3& r) {
    return l.cross(r).squaredNorm() <= 1e-24 * l.squaredNorm() * r.squaredNorm();
}

/// Two triangles without area: where they cross, or the two ends of what they share on one line.
std::vector<Vec3> of_segments(const Corners& a, const Corners& b) {
    auto [a0, a1] = longest_edge(a);
    auto [b0, b1] = longest_edge(b);
    if ((a1 - a0).squaredNorm() < (b1 - b0).squaredNorm()) {
        std::swap(a0, b0);
        std::swap(a1, b1);
    }
    const Vec3 u = a1 - a0;
    const Vec3 v = b1 - b0;
    const double length = u.squaredNorm();
    if (length == 0) {
        return {a0};
    }
    if (!are_nearly_parallel(u, v)) {
        return {nearest_on_segment(a0, a1, b0, b1)};
    }
    const auto on_a = [&](const Vec3& point) {
        return Vec3(a0 + u * std::clamp(u.dot(point - a0) / length, 0.0, 1.0));
    };
    return ends_along(u, {on_a(b0), on_a(b1)});
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

/// In coordinates of at most 1, so that nothing overflows and little underflows.
std::vector<Vec3> scaled_shared_points(const Corners& a, const Corners& b, PairClass kind) {
    std::vector<Vec3> points = without_repeats(construct(a, b, kind));
    if (points.empty() || !all_finite(points)) {
        points = {nearest_point(a, b)};
    }
    merge_surplus(points);
    return points;
}

Vec3 times_power_of_two(const Vec3& v, int exponent) {
    return {std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent), std::ldexp(v.z(), exponent)};
}

} // namespace

std::vector<Vec3> approximate_shared_points(const Corners& a, const Corners& b, PairClass kind) {
    double largest = 0;
    bool finite = true;
    for (std::size_t i = 0; i < 3; ++i) {
        largest = std::max({largest, a[i].cwiseAbs().maxCoeff(), b[i].cwiseAbs().maxCoeff()});
        finite = finite && a[i].allFinite() && b[i].allFinite();
    }
    if (!finite || largest == 0) {
        return {Vec3::Zero()};
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    Corners scaled_a;
    Corners scaled_b;
    for (std::size_t i = 0; i < 3; ++i) {
        scaled_a[i] = times_power_of_two(a[i], -exponent);
        scaled_b[i] = times_power_of_two(b[i], -exponent);
    }
    std::vector<Vec3> points = scaled_shared_points(scaled_a, scaled_b, kind);
    for (Vec3& point : points) {
        point = times_power_of_two(point, exponent);
    }
    return points;
}

} // namespace cd
