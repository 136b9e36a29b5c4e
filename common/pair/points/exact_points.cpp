#include "common/pair/points/exact_points.hpp"

#include "common/pair/numbers/exact_lattice.hpp"
#include "common/pair/numbers/exact_vectors.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace cd {

namespace {

using Int = ExactInt;
using Vec = ExactVec;

using exact_vectors::cross;
using exact_vectors::dot;
using exact_vectors::minus;

bool is_zero(const Vec& v) {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/// The point x / w in units of the pair's lattice; w > 0.
struct Place {
    Vec x;
    Int w = 1;
};

bool operator==(const Place& l, const Place& r) {
    return l.x[0] * r.w == r.x[0] * l.w && l.x[1] * r.w == r.x[1] * l.w &&
           l.x[2] * r.w == r.x[2] * l.w;
}

/// Compares two points lexicographically.
bool operator<(const Place& l, const Place& r) {
    for (std::size_t k = 0; k < 3; ++k) {
        const int order = Int(l.x[k] * r.w - r.x[k] * l.w).sign();
        if (order != 0) {
            return order < 0;
        }
    }
    return false;
}

/// Returns the vector from `from` to `to`, times to.w.
Vec toward(const Vec& from, const Place& to) {
    return {to.x[0] - to.w * from[0], to.x[1] - to.w * from[1], to.x[2] - to.w * from[2]};
}

/// Returns the point of the segment from p to q where a linear function is 0 whose values at p and
/// q are the weights, which have different signs.
Place crossing(const Vec& p, const Vec& q, const Int& weight_p, const Int& weight_q) {
    // (w_p q - w_q p) / (w_p - w_q), whose divisor has the sign of w_p.
    Place place;
    const bool flip = weight_p < 0;
    for (std::size_t k = 0; k < 3; ++k) {
        Int x = weight_p * q[k] - weight_q * p[k];
        place.x[k] = flip ? Int(-x) : x;
    }
    place.w = abs(Int(weight_p - weight_q));
    return place;
}

/// Returns twice the signed area of a, b, p as projected along axis `dropped`, times p.w.
Int area(const Vec& a, const Vec& b, const Place& p, std::size_t dropped) {
    const std::size_t x = (dropped + 1) % 3;
    const std::size_t y = (dropped + 2) % 3;
    return (b[x] - a[x]) * (p.x[y] - p.w * a[y]) - (b[y] - a[y]) * (p.x[x] - p.w * a[x]);
}

/// Returns the turn of a, b, c as projected along axis `dropped`: 1 if left, -1 if right, 0 if
/// collinear.
int turn(const Place& a, const Place& b, const Place& c, std::size_t dropped) {
    const std::size_t x = (dropped + 1) % 3;
    const std::size_t y = (dropped + 2) % 3;
    const Int determinant = a.x[x] * (b.x[y] * c.w - c.x[y] * b.w) +
                            b.x[x] * (c.x[y] * a.w - a.x[y] * c.w) +
                            c.x[x] * (a.x[y] * b.w - b.x[y] * a.w);
    return determinant.sign();
}

/// Returns an axis along which a plane with this normal is not projected to a line.
std::size_t axis_to_drop(const Vec& normal) {
    return normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
}

/// A triangle, possibly degenerate: three corners, two segment ends, or one point.
struct Shape {
    std::vector<Vec> corners;
    Vec normal;           ///< Zero if degenerate.
    std::size_t drop = 0; ///< See `axis_to_drop`.

    explicit Shape(std::span<const Vec> given) {
        normal = cross(minus(given[1], given[0]), minus(given[2], given[0]));
        if (!is_zero(normal)) {
            corners.assign(given.begin(), given.end());
            drop = axis_to_drop(normal);
            return;
        }
        // On a line, lexicographic order is the order along it.
        const auto [low, high] = std::minmax_element(given.begin(), given.end());
        corners.push_back(*low);
        if (*low != *high) {
            corners.push_back(*high);
        }
    }

    [[nodiscard]] bool has_area() const { return corners.size() == 3; }
    [[nodiscard]] std::size_t edges() const { return has_area() ? 3 : corners.size() - 1; }
    [[nodiscard]] const Vec& from(std::size_t edge) const { return corners[edge]; }
    [[nodiscard]] const Vec& to(std::size_t edge) const {
        return corners[(edge + 1) % corners.size()];
    }
    [[nodiscard]] Int side(const Vec& point) const { return dot(normal, minus(point, corners[0])); }
};

/// Tests whether a point in the plane of a triangle with area is in the triangle.
bool is_within_edges(const Shape& triangle, const Place& point) {
    const int inside = triangle.normal[triangle.drop].sign();
    for (std::size_t i = 0; i < 3; ++i) {
        const Int turned = area(triangle.from(i), triangle.to(i), point, triangle.drop);
        if (turned.sign() * inside < 0) {
            return false;
        }
    }
    return true;
}

bool contains(const Shape& shape, const Place& point) {
    const Vec offset = toward(shape.corners[0], point);
    if (shape.has_area()) {
        return dot(shape.normal, offset) == 0 && is_within_edges(shape, point);
    }
    if (shape.corners.size() == 1) {
        return is_zero(offset);
    }
    const Vec along = minus(shape.corners[1], shape.corners[0]);
    const Int place = dot(along, offset);
    return is_zero(cross(along, offset)) && place >= 0 && place <= point.w * dot(along, along);
}

/// Finds the corners of the intersection of two shapes. A corner is a corner of one shape that lies
/// in the other, or a point where an edge of one properly crosses the inside or, within a plane, an
/// edge of the other. Each such point is a corner: the intersection ends there on the line of the
/// two planes, or two half-planes that contain the intersection have the point on their boundary.
class Search {
  public:
    Search(const Shape& a, const Shape& b) : a_(a), b_(b) {}

    [[nodiscard]] std::vector<Place> places() {
        add_corners(a_, b_);
        add_corners(b_, a_);
        add_crossings(a_, b_);
        add_crossings(b_, a_);
        return std::move(found_);
    }

  private:
    void add(Place place) {
        if (std::find(found_.begin(), found_.end(), place) == found_.end()) {
            found_.push_back(std::move(place));
        }
    }

    void add_corners(const Shape& of, const Shape& in) {
        for (const Vec& corner : of.corners) {
            Place place{corner, 1};
            if (contains(in, place)) {
                add(std::move(place));
            }
        }
    }

    /// Adds crossings of the edges of `of` with the inside or the edges of `with`.
    void add_crossings(const Shape& of, const Shape& with) {
        for (std::size_t i = 0; i < of.edges(); ++i) {
            const Vec& p = of.from(i);
            const Vec& q = of.to(i);
            if (!with.has_area()) {
                if (!of.has_area() && with.edges() == 1) {
                    add_crossing_of_lines(p, q, with.from(0), with.to(0));
                }
                continue; // If `of` is a triangle, the swapped call finds all crossings.
            }
            const Int side_p = with.side(p);
            const Int side_q = with.side(q);
            if (side_p.sign() * side_q.sign() < 0) {
                Place place = crossing(p, q, side_p, side_q);
                if (is_within_edges(with, place)) {
                    add(std::move(place));
                }
            } else if (side_p == 0 && side_q == 0) {
                for (std::size_t j = 0; j < 3; ++j) {
                    add_crossing_in_plane(p, q, with.from(j), with.to(j), with.drop);
                }
            }
        }
    }

    void add_crossing_of_lines(const Vec& p, const Vec& q, const Vec& r, const Vec& s) {
        const Vec normal = cross(minus(q, p), minus(s, r));
        if (!is_zero(normal) && dot(normal, minus(r, p)) == 0) {
            add_crossing_in_plane(p, q, r, s, axis_to_drop(normal));
        }
    }

    /// Adds the point where both segments properly cross the other's line.
    void add_crossing_in_plane(
        const Vec& p, const Vec& q, const Vec& r, const Vec& s, std::size_t drop) {
        const Int of_p = area(r, s, {p, 1}, drop);
        const Int of_q = area(r, s, {q, 1}, drop);
        if (of_p.sign() * of_q.sign() < 0 &&
            area(p, q, {r, 1}, drop).sign() * area(p, q, {s, 1}, drop).sign() < 0) {
            add(crossing(p, q, of_p, of_q));
        }
    }

    const Shape& a_;
    const Shape& b_;
    std::vector<Place> found_;
};

/// Orders the points from the lexicographically least on; a polygon turns left around A's normal.
/// Seen from one corner of a convex polygon, the others span less than a half turn.
void put_in_order(std::vector<Place>& places, const Shape& a) {
    if (places.empty()) {
        return;
    }
    std::iter_swap(places.begin(), std::min_element(places.begin(), places.end()));
    if (places.size() < 3) {
        return;
    }
    const int left = a.normal[a.drop].sign();
    const auto before = [&](const Place& l, const Place& r) {
        return turn(places.front(), l, r, a.drop) * left > 0;
    };
    std::sort(places.begin() + 1, places.end(), before);
}

} // namespace

ExactPoints::ExactPoints(const PosePair& poses)
    : a_(to_exact(poses.a)), b_(to_exact(poses.b)), norm_(a_.norm * b_.norm) {}

Vec3 ExactPoints::origin(const Corners& a) const {
    return offset(a, Vec3::Zero());
}

Vec3 ExactPoints::offset(const Corners& a, const Vec3& origin) const {
    const std::array<Dyadic, 3> exact = world_corner(a_, a[0]);
    Vec3 rounded;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const Dyadic difference = exact[k] - to_dyadic(origin[axis]) * a_.norm;
        rounded[axis] = nearest_double(
            difference.mantissa, a_.norm.mantissa, difference.exponent - a_.norm.exponent);
    }
    return rounded;
}

std::vector<Vec3>
ExactPoints::points(const Corners& a, const Corners& b, const Vec3& origin) const {
    const ExactLattice lattice = exact_lattice(a_, a, b_, b, origin);
    const std::span<const Vec> corners(lattice.corners);
    const Shape shape_a(corners.first(3));
    const Shape shape_b(corners.last(3));
    std::vector<Place> places = Search(shape_a, shape_b).places();
    put_in_order(places, shape_a);

    std::vector<Vec3> rounded(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Int denominator = places[i].w * norm_.mantissa;
        for (std::size_t k = 0; k < 3; ++k) {
            rounded[i][static_cast<Eigen::Index>(k)] =
                nearest_double(places[i].x[k], denominator, lattice.exponent - norm_.exponent);
        }
    }
    return rounded;
}

} // namespace cd
