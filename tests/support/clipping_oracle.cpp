#include "tests/support/clipping_oracle.hpp"

#include "tests/support/posed_point.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace cd::tests {

namespace {

using Number = Rational;
using Point = RationalPoint;
using Polygon = std::vector<Point>;

Point minus(const Point& l, const Point& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

Number dot(const Point& l, const Point& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

Point cross(const Point& l, const Point& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

bool is_zero(const Point& p) {
    return p[0] == 0 && p[1] == 0 && p[2] == 0;
}

/// The half-space of points x with normal.(x - on) >= 0.
struct HalfSpace {
    Point normal;
    Point on;
};

void add_plane(std::vector<HalfSpace>& bounds, const Point& normal, const Point& on) {
    bounds.push_back({normal, on});
    bounds.push_back({{-normal[0], -normal[1], -normal[2]}, on});
}

bool has_area(const Polygon& triangle) {
    return !is_zero(cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0])));
}

/// Returns half-spaces whose common part is exactly the triangle, segment or point.
std::vector<HalfSpace> bounds_of(const Polygon& t) {
    std::vector<HalfSpace> bounds;
    if (has_area(t)) {
        const Point normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
        add_plane(bounds, normal, t[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            bounds.push_back({cross(normal, minus(t[(i + 1) % 3], t[i])), t[i]});
        }
        return bounds;
    }
    const auto [low, high] = std::minmax_element(t.begin(), t.end());
    const Point along = minus(*high, *low);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Point unit{0, 0, 0};
        unit[axis] = 1;
        add_plane(bounds, is_zero(along) ? unit : cross(along, unit), *low);
    }
    bounds.push_back({along, *low});
    bounds.push_back({minus(*low, *high), *high});
    return bounds;
}

Polygon clip(const Polygon& polygon, const HalfSpace& bound) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& here = polygon[i];
        const Point& next = polygon[(i + 1) % polygon.size()];
        const Number from = dot(bound.normal, minus(here, bound.on));
        const Number to = dot(bound.normal, minus(next, bound.on));
        if (from >= 0) {
            kept.push_back(here);
        }
        if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
            const Number share = from / (from - to);
            const Point step = minus(next, here);
            kept.push_back(
                {here[0] + share * step[0], here[1] + share * step[1], here[2] + share * step[2]});
        }
    }
    return kept;
}

/// True if `p`, a point of the triangle's plane, is strictly inside all three edges.
bool is_inner(const Point& p, const Polygon& t) {
    const Point normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    for (std::size_t i = 0; i < 3; ++i) {
        if (dot(cross(normal, minus(t[(i + 1) % 3], t[i])), minus(p, t[i])) <= 0) {
            return false;
        }
    }
    return true;
}

/// The mean of a convex set's corners lies in its relative interior.
Point mean(const Polygon& polygon) {
    Point sum{0, 0, 0};
    for (const Point& p : polygon) {
        for (std::size_t k = 0; k < 3; ++k) {
            sum[k] += p[k];
        }
    }
    const Number count = polygon.size();
    return {sum[0] / count, sum[1] / count, sum[2] / count};
}

Polygon world(const Pose& pose, const Corners& corners) {
    return {clipping_oracle_world(pose, corners[0]),
            clipping_oracle_world(pose, corners[1]),
            clipping_oracle_world(pose, corners[2])};
}

Polygon common_part(const Polygon& a, const Polygon& b) {
    Polygon shared = a;
    for (const HalfSpace& bound : bounds_of(b)) {
        shared = clip(shared, bound);
    }
    return shared;
}

bool is_strictly_between(const Point& p, const Point& from, const Point& to) {
    const Point along = minus(to, from);
    const Point offset = minus(p, from);
    const Number place = dot(along, offset);
    return is_zero(cross(along, offset)) && place > 0 && place < dot(along, along);
}

/// Removes repeated corners and, for flat sets, points between corners: clipping leaves both.
Polygon corners_of(const Polygon& polygon) {
    Polygon distinct;
    for (const Point& p : polygon) {
        if (std::find(distinct.begin(), distinct.end(), p) == distinct.end()) {
            distinct.push_back(p);
        }
    }
    Polygon corners;
    for (const Point& p : distinct) {
        const bool is_corner = std::none_of(distinct.begin(), distinct.end(), [&](const Point& l) {
            return std::any_of(distinct.begin(), distinct.end(), [&](const Point& r) {
                return is_strictly_between(p, l, r);
            });
        });
        if (is_corner) {
            corners.push_back(p);
        }
    }
    return corners;
}

} // namespace

PairClass
clipping_oracle_class(const Corners& corners_a, const Corners& corners_b, const PosePair& poses) {
    const Polygon a = world(poses.a, corners_a);
    const Polygon b = world(poses.b, corners_b);
    const Polygon shared = common_part(a, b);
    if (shared.empty()) {
        return PairClass::Separate;
    }
    if (!has_area(a) || !has_area(b)) {
        return PairClass::Touch;
    }
    // Relative interiors of convex sets meet exactly if the relative interior of their intersection
    // lies in both.
    const Point center = mean(shared);
    if (!is_inner(center, a) || !is_inner(center, b)) {
        return PairClass::Touch;
    }
    const Point normal = cross(minus(b[1], b[0]), minus(b[2], b[0]));
    const bool coplanar = std::all_of(
        a.begin(), a.end(), [&](const Point& p) { return dot(normal, minus(p, b[0])) == 0; });
    return coplanar ? PairClass::Coplanar : PairClass::Proper;
}

std::vector<RationalPoint>
clipping_oracle_points(const Corners& a, const Corners& b, const PosePair& poses) {
    Polygon corners = corners_of(common_part(world(poses.a, a), world(poses.b, b)));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

RationalPoint clipping_oracle_world(const Pose& pose, const Vec3& corner) {
    return world_point<Rational>(pose, corner);
}

bool is_nearest_double(double value, const Rational& exact) {
    if (!std::isfinite(value) || (value == 0 && std::signbit(value))) {
        return false;
    }
    const Rational error = abs(Rational(value) - exact);
    for (const double to : {-1.0, 1.0}) {
        const double neighbour =
            std::nextafter(value, to * std::numeric_limits<double>::infinity());
        if (!std::isfinite(neighbour)) {
            continue;
        }
        const Rational other = abs(Rational(neighbour) - exact);
        if (other < error || (other == error && std::bit_cast<std::uint64_t>(value) % 2 == 1)) {
            return false;
        }
    }
    return true;
}

} // namespace cd::tests
