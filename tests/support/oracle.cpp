#include "tests/support/oracle.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace cd::tests {

namespace {

/// The points x with normal.x >= offset, or with = on the boundary.
struct HalfSpace {
    ExactPoint normal;
    Integer offset;

    HalfSpace(ExactPoint direction, const ExactPoint& on)
        : normal(std::move(direction)), offset(dot(normal, on)) {}

    [[nodiscard]] Integer at(const ExactPoint& x) const { return dot(normal, x) - offset; }
    [[nodiscard]] int side(const WeightedPoint& x) const {
        return cmp(dot(normal, x.p), offset * x.weight);
    }
};

using Sides = std::array<Integer, 3>;

/// A triangle with area.
struct Bounded {
    const ExactTriangle* corners;
    HalfSpace plane;
    std::array<HalfSpace, 3> edges; ///< Edge i runs from corner i to the next; the inside has
                                    ///< values >= 0.

    Bounded(const ExactTriangle& t, const ExactPoint& normal)
        : corners(&t),
          plane(normal, t[0]),
          edges{edge(t, normal, 0), edge(t, normal, 1), edge(t, normal, 2)} {}

    /// Requires `x` in the triangle's plane.
    [[nodiscard]] bool has(const WeightedPoint& x) const {
        return std::all_of(
            edges.begin(), edges.end(), [&](const HalfSpace& edge) { return edge.side(x) >= 0; });
    }

  private:
    static HalfSpace edge(const ExactTriangle& t, const ExactPoint& normal, std::size_t i) {
        return {cross(normal, minus(t[(i + 1) % 3], t[i])), t[i]};
    }
};

Sides sides_of(const ExactTriangle& t, const HalfSpace& plane) {
    return {plane.at(t[0]), plane.at(t[1]), plane.at(t[2])};
}

bool all_on_one_side(const Sides& s) {
    const int first = sgn(s[0]);
    return first != 0 && sgn(s[1]) == first && sgn(s[2]) == first;
}

/// Intersects a plane with the segment from `p` to `q`, which lie strictly on either side.
WeightedPoint
crossing(const ExactPoint& p, const Integer& at_p, const ExactPoint& q, const Integer& at_q) {
    const Integer to_p = abs(at_q);
    const Integer to_q = abs(at_p);
    WeightedPoint result;
    for (std::size_t k = 0; k < 3; ++k) {
        result.p[k] = to_p * p[k] + to_q * q[k];
    }
    result.weight = to_p + to_q;
    return result;
}

/// Returns the ends of a triangle's part in a plane; `sides` of its corners are not all 0.
std::vector<WeightedPoint> ends_in_plane(const ExactTriangle& t, const Sides& sides) {
    std::vector<WeightedPoint> ends;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        if (sides[i] == 0) {
            ends.push_back({t[i], 1});
        } else if (sgn(sides[i]) * sgn(sides[next]) < 0) {
            ends.push_back(crossing(t[i], sides[i], t[next], sides[next]));
        }
    }
    return ends;
}

void add_those_in(const Bounded& t,
                  std::vector<WeightedPoint> points,
                  std::vector<WeightedPoint>& kept) {
    for (WeightedPoint& point : points) {
        if (t.has(point)) {
            kept.push_back(std::move(point));
        }
    }
}

std::vector<WeightedPoint> corners_of(const ExactTriangle& t) {
    return {{t[0], 1}, {t[1], 1}, {t[2], 1}};
}

/// The corners of the intersection are corners of the triangles or crossings of their edges.
std::vector<WeightedPoint> shared_in_plane(const Bounded& a, const Bounded& b) {
    std::vector<WeightedPoint> shared;
    add_those_in(b, corners_of(*a.corners), shared);
    add_those_in(a, corners_of(*b.corners), shared);
    for (const HalfSpace& edge_of_b : b.edges) {
        const Sides sides = sides_of(*a.corners, edge_of_b);
        if (!all_on_one_side(sides) &&
            std::any_of(sides.begin(), sides.end(), [](const Integer& s) { return s != 0; })) {
            add_those_in(b, ends_in_plane(*a.corners, sides), shared);
        }
    }
    return shared;
}

/// The intersection lies on the common line of the two planes, where each triangle has a segment.
/// Its ends are those segment ends that lie in the other triangle.
std::vector<WeightedPoint>
shared_on_line(const Bounded& a, const Bounded& b, const Sides& sides_a) {
    const Sides sides_b = sides_of(*b.corners, a.plane);
    std::vector<WeightedPoint> shared;
    if (!all_on_one_side(sides_b)) {
        add_those_in(b, ends_in_plane(*a.corners, sides_a), shared);
        add_those_in(a, ends_in_plane(*b.corners, sides_b), shared);
    }
    return shared;
}

/// Returns half-spaces whose common part is exactly the segment or point from `low` to `high`.
std::vector<HalfSpace> bounds_of_segment(const ExactPoint& low, const ExactPoint& high) {
    const ExactPoint along = minus(high, low);
    std::vector<HalfSpace> bounds{{along, low}, {minus(low, high), high}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ExactPoint unit;
        unit[axis] = 1;
        const ExactPoint normal = is_zero(along) ? unit : cross(along, unit);
        bounds.push_back({normal, low});
        bounds.push_back({minus(ExactPoint{}, normal), low});
    }
    return bounds;
}

/// Clips the segment from `low` to `high` by all half-spaces; each cuts off one end.
std::vector<WeightedPoint> clipped_segment(const ExactPoint& low,
                                           const ExactPoint& high,
                                           const std::vector<HalfSpace>& bounds) {
    mpq_class from = 0;
    mpq_class to = 1;
    for (const HalfSpace& bound : bounds) {
        const Integer at_low = bound.at(low);
        const Integer at_high = bound.at(high);
        if (at_low < 0 && at_high < 0) {
            return {};
        }
        if (at_low < 0 || at_high < 0) {
            mpq_class place(at_low, at_low - at_high);
            place.canonicalize();
            mpq_class& end = at_low < 0 ? from : to;
            end = at_low < 0 ? std::max(from, place) : std::min(to, place);
        }
    }
    if (from > to) {
        return {};
    }
    std::vector<WeightedPoint> ends;
    for (const mpq_class& place : {from, to}) {
        WeightedPoint end;
        end.weight = place.get_den();
        for (std::size_t k = 0; k < 3; ++k) {
            end.p[k] = low[k] * place.get_den() + (high[k] - low[k]) * place.get_num();
        }
        ends.push_back(std::move(end));
    }
    return ends;
}

std::vector<HalfSpace> bounds_of(const ExactTriangle& t, const ExactPoint& normal) {
    if (is_zero(normal)) {
        const auto [low, high] = std::minmax_element(t.begin(), t.end());
        return bounds_of_segment(*low, *high);
    }
    const Bounded bounded(t, normal);
    std::vector<HalfSpace> bounds(bounded.edges.begin(), bounded.edges.end());
    bounds.push_back(bounded.plane);
    bounds.push_back({minus(ExactPoint{}, normal), t[0]});
    return bounds;
}

/// Intersects a triangle without area with any other triangle.
std::vector<WeightedPoint> shared_with_segment(const ExactTriangle& segment,
                                               const ExactTriangle& other,
                                               const ExactPoint& normal) {
    const auto [low, high] = std::minmax_element(segment.begin(), segment.end());
    return clipped_segment(*low, *high, bounds_of(other, normal));
}

/// Relative interiors of convex sets meet exactly if their intersection is not on one edge.
bool has_inner_point(const Bounded& t, const std::vector<WeightedPoint>& shared) {
    return std::all_of(t.edges.begin(), t.edges.end(), [&](const HalfSpace& edge) {
        return std::any_of(shared.begin(), shared.end(), [&](const WeightedPoint& corner) {
            return edge.side(corner) > 0;
        });
    });
}

struct Meeting {
    PairClass kind = PairClass::Separate;
    std::vector<WeightedPoint> shared;
};

Meeting meeting_of(const ExactTriangle& corners_a, const ExactTriangle& corners_b) {
    const ExactPoint normal_b = normal_of(corners_b);
    const ExactPoint normal_a = normal_of(corners_a);
    Meeting result;
    if (is_zero(normal_a) || is_zero(normal_b)) {
        result.shared = is_zero(normal_a) ? shared_with_segment(corners_a, corners_b, normal_b)
                                          : shared_with_segment(corners_b, corners_a, normal_a);
        result.kind = result.shared.empty() ? PairClass::Separate : PairClass::Touch;
        return result;
    }
    const HalfSpace plane_b(normal_b, corners_b[0]);
    const Sides sides_a = sides_of(corners_a, plane_b);
    if (all_on_one_side(sides_a)) {
        return result;
    }
    const Bounded a(corners_a, normal_a);
    const Bounded b(corners_b, normal_b);
    const bool coplanar = sides_a[0] == 0 && sides_a[1] == 0 && sides_a[2] == 0;
    result.shared = coplanar ? shared_in_plane(a, b) : shared_on_line(a, b, sides_a);
    if (result.shared.empty()) {
        return result;
    }
    const bool inner = has_inner_point(a, result.shared) && has_inner_point(b, result.shared);
    const PairClass inner_kind = coplanar ? PairClass::Coplanar : PairClass::Proper;
    result.kind = inner ? inner_kind : PairClass::Touch;
    return result;
}

} // namespace

PairClass oracle_class(const ExactTriangle& a, const ExactTriangle& b) {
    return meeting_of(a, b).kind;
}

PairClass oracle_class(const Corners& a, const Corners& b, const PosePair& poses) {
    const ExactWorld world = exact_world(a, b, poses);
    return oracle_class(ExactTriangle{world.a[0], world.a[1], world.a[2]},
                        ExactTriangle{world.b[0], world.b[1], world.b[2]});
}

std::vector<WeightedPoint> shared_corners(const ExactTriangle& a, const ExactTriangle& b) {
    return meeting_of(a, b).shared;
}

} // namespace cd::tests
