#include "common/geometry/exact_triangle_pair.hpp"

#include "common/geometry/dyadic.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace cd {

namespace {

using Int = ExactInt;

struct Vec {
    std::array<Int, 3> v;

    [[nodiscard]] bool is_zero() const { return v[0] == 0 && v[1] == 0 && v[2] == 0; }
};

Vec operator-(const Vec& l, const Vec& r) {
    return {{l.v[0] - r.v[0], l.v[1] - r.v[1], l.v[2] - r.v[2]}};
}

Vec cross(const Vec& l, const Vec& r) {
    return {{l.v[1] * r.v[2] - l.v[2] * r.v[1],
             l.v[2] * r.v[0] - l.v[0] * r.v[2],
             l.v[0] * r.v[1] - l.v[1] * r.v[0]}};
}

Int dot(const Vec& l, const Vec& r) {
    return l.v[0] * r.v[0] + l.v[1] * r.v[1] + l.v[2] * r.v[2];
}

int sign(const Int& value) {
    return value.sign();
}

using Points = std::vector<Vec>;

/// The corners of both triangles on one integer lattice.
std::pair<Points, Points>
on_lattice(const Corners& a, const Corners& b, const ExactPose& pose_a, const ExactPose& pose_b) {
    std::array<Dyadic, 18> coordinates;
    std::size_t place = 0;
    const auto map = [&](const Corners& corners, const ExactPose& pose, const Dyadic& other_norm) {
        for (const Vec3& corner : corners) {
            const std::array<Dyadic, 3> x{
                to_dyadic(corner.x()), to_dyadic(corner.y()), to_dyadic(corner.z())};
            for (std::size_t row = 0; row < 3; ++row) {
                const auto& r = pose.linear[row];
                coordinates[place++] =
                    (r[0] * x[0] + r[1] * x[1] + r[2] * x[2] + pose.translation[row]) * other_norm;
            }
        }
    };
    map(a, pose_a, pose_b.norm);
    map(b, pose_b, pose_a.norm);

    int lowest = 0;
    bool any = false;
    for (const Dyadic& value : coordinates) {
        if (value.mantissa != 0) {
            lowest = any ? std::min(lowest, value.exponent) : value.exponent;
            any = true;
        }
    }
    std::array<Points, 2> bodies{Points(3), Points(3)};
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const Dyadic& value = coordinates[i];
        Int& target = bodies[i / 9][i % 9 / 3].v[i % 3];
        target = value.mantissa == 0 ? Int(0) : Int(value.mantissa << (value.exponent - lowest));
    }
    return {std::move(bodies[0]), std::move(bodies[1])};
}

/// An axis along which a plane with this normal can be projected without folding.
std::size_t axis_to_drop(const Vec& normal) {
    return normal.v[0] != 0 ? 0 : normal.v[1] != 0 ? 1 : 2;
}

int orientation(const Vec& a, const Vec& b, const Vec& c, std::size_t dropped) {
    const std::size_t x = (dropped + 1) % 3;
    const std::size_t y = (dropped + 2) % 3;
    return sign((b.v[x] - a.v[x]) * (c.v[y] - a.v[y]) - (b.v[y] - a.v[y]) * (c.v[x] - a.v[x]));
}

/// How far all of `points` are from the inside of edge i of a triangle, in the projected plane: 1
/// when all are strictly outside, 0 when all are outside or on the edge's line, -1 otherwise.
int outside_of_edge(const Points& triangle, std::size_t i, const Points& points, std::size_t drop) {
    const Vec& from = triangle[i];
    const Vec& to = triangle[(i + 1) % 3];
    const int inside = orientation(from, to, triangle[(i + 2) % 3], drop);
    int verdict = 1;
    for (const Vec& point : points) {
        const int side = orientation(from, to, point, drop) * inside;
        if (side > 0) {
            return -1;
        }
        verdict = side == 0 ? 0 : verdict;
    }
    return verdict;
}

/// Two triangles with area in one plane: separating axes in two dimensions, which for convex sets
/// are normals of edges (Ericson, Real-Time Collision Detection, 5.2.1).
PairClass classify_coplanar(const Points& a, const Points& b, const Vec& normal) {
    const std::size_t drop = axis_to_drop(normal);
    bool overlap = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const int of_a = outside_of_edge(a, i, b, drop);
        const int of_b = outside_of_edge(b, i, a, drop);
        if (of_a == 1 || of_b == 1) {
            return PairClass::Separate;
        }
        overlap = overlap && of_a < 0 && of_b < 0;
    }
    return overlap ? PairClass::Coplanar : PairClass::Touch;
}

/// A segment (or point) in the plane of a triangle with area: do the closed sets meet? The normals
/// of the triangle's edges and of the segment are the possible separating axes.
bool segment_meets_coplanar_triangle(const Points& segment, const Points& triangle, const Vec& n) {
    const std::size_t drop = axis_to_drop(n);
    for (std::size_t i = 0; i < 3; ++i) {
        if (outside_of_edge(triangle, i, segment, drop) == 1) {
            return false;
        }
    }
    const int first = orientation(segment[0], segment[1], triangle[0], drop);
    const int second = orientation(segment[0], segment[1], triangle[1], drop);
    const int third = orientation(segment[0], segment[1], triangle[2], drop);
    return first == 0 || first != second || first != third;
}

/// A number numerator / denominator with a positive denominator.
struct Ratio {
    Int numerator;
    Int denominator;
};

bool operator<(const Ratio& l, const Ratio& r) {
    return l.numerator * r.denominator < r.numerator * l.denominator;
}

struct Interval {
    Ratio low;
    Ratio high;
};

/// Where a triangle that meets a plane cuts it, along the direction of the line that both planes
/// share. `sides` are the triangle's distances from the plane, up to one positive factor.
Interval
interval_on_line(const Points& triangle, const std::array<Int, 3>& sides, const Vec& line) {
    std::vector<Ratio> places;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (sides[i] == 0) {
            places.push_back({dot(line, triangle[i]), 1});
        }
        if (sign(sides[i]) * sign(sides[j]) < 0) {
            // The point (s_i x_j - s_j x_i) / (s_i - s_j) of the edge.
            Int numerator = sides[i] * dot(line, triangle[j]) - sides[j] * dot(line, triangle[i]);
            Int denominator = sides[i] - sides[j];
            if (denominator < 0) {
                numerator = -numerator;
                denominator = -denominator;
            }
            places.push_back({std::move(numerator), std::move(denominator)});
        }
    }
    const auto [low, high] = std::minmax_element(places.begin(), places.end());
    return {*low, *high};
}

struct PlaneSides {
    std::array<Int, 3> value;
    int lowest = 0;
    int highest = 0;
};

PlaneSides sides_of(const Points& triangle, const Vec& normal, const Vec& on_plane) {
    PlaneSides sides;
    for (std::size_t i = 0; i < 3; ++i) {
        sides.value[i] = dot(normal, triangle[i] - on_plane);
        const int s = sign(sides.value[i]);
        sides.lowest = i == 0 ? s : std::min(sides.lowest, s);
        sides.highest = i == 0 ? s : std::max(sides.highest, s);
    }
    return sides;
}

PairClass classify_with_area(const Points& a, const Points& b, const Vec& na, const Vec& nb) {
    const PlaneSides of_a = sides_of(a, nb, b[0]);
    if (of_a.lowest > 0 || of_a.highest < 0) {
        return PairClass::Separate;
    }
    const PlaneSides of_b = sides_of(b, na, a[0]);
    if (of_b.lowest > 0 || of_b.highest < 0) {
        return PairClass::Separate;
    }
    if (of_a.lowest == 0 && of_a.highest == 0) {
        return classify_coplanar(a, b, nb);
    }
    const Vec line = cross(na, nb);
    const Interval on_a = interval_on_line(a, of_a.value, line);
    const Interval on_b = interval_on_line(b, of_b.value, line);
    const Ratio& low = on_a.low < on_b.low ? on_b.low : on_a.low;
    const Ratio& high = on_a.high < on_b.high ? on_a.high : on_b.high;
    if (high < low) {
        return PairClass::Separate;
    }
    // The relative interiors meet where both triangles cross the other's plane and the open
    // intervals overlap.
    const bool both_cross =
        of_a.lowest < 0 && of_a.highest > 0 && of_b.lowest < 0 && of_b.highest > 0;
    return both_cross && low < high ? PairClass::Proper : PairClass::Touch;
}

/// The two ends of three points on a line; equal for a point. On a line, the lexicographic order is
/// the order along it.
Points ends_of(const Points& collinear) {
    const auto before = [](const Vec& l, const Vec& r) { return l.v < r.v; };
    const auto [first, last] = std::minmax_element(collinear.begin(), collinear.end(), before);
    return {*first, *last};
}

bool segment_meets_triangle(const Points& segment, const Points& triangle, const Vec& normal) {
    const Int first = dot(normal, segment[0] - triangle[0]);
    const Int second = dot(normal, segment[1] - triangle[0]);
    if (sign(first) * sign(second) > 0) {
        return false;
    }
    if (first == 0 && second == 0) {
        return segment_meets_coplanar_triangle(segment, triangle, normal);
    }
    // It crosses the plane in (s0 x1 - s1 x0) / (s0 - s1); everything is scaled by that divisor.
    const Int divisor = first - second;
    Vec crossing;
    Points scaled(3);
    for (std::size_t k = 0; k < 3; ++k) {
        crossing.v[k] = first * segment[1].v[k] - second * segment[0].v[k];
        for (std::size_t i = 0; i < 3; ++i) {
            scaled[i].v[k] = divisor * triangle[i].v[k];
        }
    }
    return segment_meets_coplanar_triangle({crossing, crossing}, scaled, normal);
}

bool segments_meet(const Points& a, const Points& b) {
    const Vec u = a[1] - a[0];
    const Vec v = b[1] - b[0];
    const Vec w = b[0] - a[0];
    const Vec n = cross(u, v);
    if (!n.is_zero()) {
        if (dot(n, w) != 0) {
            return false;
        }
        // a0 + s u = b0 + t v with s = (w x v).n / n.n and t = (w x u).n / n.n.
        const Int s = dot(cross(w, v), n);
        const Int t = dot(cross(w, u), n);
        const Int one = dot(n, n);
        return s >= 0 && s <= one && t >= 0 && t <= one;
    }
    if (!cross(w, u).is_zero() || !cross(w, v).is_zero()) {
        return false; // On two parallel lines, or a point off the other's line.
    }
    if (u.is_zero() && v.is_zero()) {
        return w.is_zero();
    }
    // All four points are on one line, and each pair is in its order.
    return !(a[1].v < b[0].v) && !(b[1].v < a[0].v);
}

} // namespace

struct ExactTrianglePair::State {
    ExactPose a;
    ExactPose b;
};

ExactTrianglePair::ExactTrianglePair(const PosePair& poses)
    : state_(std::make_unique<State>(State{to_exact(poses.a), to_exact(poses.b)})) {}
ExactTrianglePair::ExactTrianglePair(ExactTrianglePair&&) noexcept = default;
ExactTrianglePair& ExactTrianglePair::operator=(ExactTrianglePair&&) noexcept = default;
ExactTrianglePair::~ExactTrianglePair() = default;

PairClass ExactTrianglePair::classify(const Corners& corners_a, const Corners& corners_b) const {
    const auto [a, b] = on_lattice(corners_a, corners_b, state_->a, state_->b);
    const Vec na = cross(a[1] - a[0], a[2] - a[0]);
    const Vec nb = cross(b[1] - b[0], b[2] - b[0]);
    if (!na.is_zero() && !nb.is_zero()) {
        return classify_with_area(a, b, na, nb);
    }
    const bool meet = !nb.is_zero()   ? segment_meets_triangle(ends_of(a), b, nb)
                      : !na.is_zero() ? segment_meets_triangle(ends_of(b), a, na)
                                      : segments_meet(ends_of(a), ends_of(b));
    return meet ? PairClass::Touch : PairClass::Separate;
}

} // namespace cd
