// Decides a triangle pair from the signs of a few determinants of its six corners. All exact stages
// share this procedure.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <array>
#include <concepts>
#include <cstddef>

namespace cd {

/// The signs (-1, 0, 1) of a triangle's three corners against the plane of the other triangle.
using PlaneSides = std::array<int, 3>;

/// Marks a sign that an inexact stage cannot prove.
inline constexpr int unknown_sign = 2;
inline constexpr PlaneSides unknown_sides{unknown_sign, unknown_sign, unknown_sign};

[[nodiscard]] inline bool is_any_unknown(const PlaneSides& sides) {
    return (sides[0] == unknown_sign) | (sides[1] == unknown_sign) | (sides[2] == unknown_sign);
}

/// Provides signs for the six corners of a pair: A's are x_0 to x_2, B's are x_3 to x_5. Below, the
/// sign of det(x_j - x_i, x_k - x_i, x_l - x_i) is written [i j k l].
template <class T>
concept CornerSigns = requires(T signs, std::size_t i) {
    /// [3 4 5 i] for the corners i of A.
    { signs.sides_of_a() } -> std::same_as<PlaneSides>;
    /// [0 1 2 j] for the corners j of B.
    { signs.sides_of_b() } -> std::same_as<PlaneSides>;
    /// [i i' j j'] for an edge i i' of A and an edge j j' of B, in either direction.
    { signs.edge_side(i, i, i, i) } -> std::same_as<int>;
    /// The turn from i over j to k, seen along `axis`: the sign of det(x_j - x_i, x_k - x_i) in the
    /// next two coordinates.
    { signs.turn(i, i, i, i) } -> std::same_as<int>;
    /// The sign of x_i - x_j along `axis`.
    { signs.difference(i, i, i) } -> std::same_as<int>;
};

namespace pair_decision {

constexpr std::size_t next(std::size_t corner) {
    return (corner + 1) % 3;
}

/// Returns the corner after `corner` in the triangle whose first corner is `first`.
constexpr std::size_t next_of(std::size_t first, std::size_t corner) {
    return first + next(corner - first);
}

inline bool all_are(const PlaneSides& sides, int sign) {
    return (sides[0] == sign) & (sides[1] == sign) & (sides[2] == sign);
}

inline bool is_any(const PlaneSides& sides, int sign) {
    return (sides[0] == sign) | (sides[1] == sign) | (sides[2] == sign);
}

inline bool is_one_sided(const PlaneSides& sides) {
    return all_are(sides, 1) | all_are(sides, -1);
}

constexpr int count(const PlaneSides& sides, int sign) {
    return (sides[0] == sign) + (sides[1] == sign) + (sides[2] == sign);
}

/// The corner that the other triangle's plane separates from the other two corners. Exists if the
/// triangle is neither in the plane nor strictly on one side. Both edges at the corner reach the
/// plane, and neither lies in it.
struct LoneCorner {
    std::size_t corner;
    bool is_above; ///< A corner in the plane counts as below if the other two are above.
};

constexpr LoneCorner find_lone_corner(const PlaneSides& sides) {
    const auto find = [&](int sign) {
        return static_cast<std::size_t>(sides[0] == sign ? 0 : sides[1] == sign ? 1 : 2);
    };
    if (count(sides, 1) == 1) {
        return {find(1), true};
    }
    if (count(sides, -1) == 1) {
        return {find(-1), false};
    }
    return {find(0), count(sides, -1) == 2};
}

/// Table of `find_lone_corner` for all sides. The base-3 digits of the index are the corners'
/// signs; digit 2 means -1.
inline constexpr auto lone_corners = [] {
    std::array<LoneCorner, 27> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto sign = [](std::size_t digit) {
            return digit % 3 == 2 ? -1 : static_cast<int>(digit % 3);
        };
        table[i] = find_lone_corner({sign(i / 9), sign(i / 3), sign(i)});
    }
    return table;
}();

/// Returns `find_lone_corner(sides)` from a table: branches on signs are too often mispredicted.
inline LoneCorner lone_corner(const PlaneSides& sides) {
    const auto digit = [](int sign) {
        return static_cast<std::size_t>(sign + 3 * static_cast<int>(sign < 0));
    };
    return lone_corners[9 * digit(sides[0]) + 3 * digit(sides[1]) + digit(sides[2])];
}

/// Decides two triangles with area in different planes, neither strictly on one side of the other's
/// plane. Each meets the planes' common line in an interval, and the sides of two pairs of edges
/// order the intervals' ends (Guigue and Devillers, Fast and robust triangle-triangle overlap test
/// using orientation predicates, 2003, RR-4488, section 4). p1 and p2 are the lone corners.
template <CornerSigns Signs>
PairClass decide_crossing(Signs& signs, const PlaneSides& of_a, const PlaneSides& of_b) {
    const LoneCorner a = lone_corner(of_a);
    const LoneCorner b = lone_corner(of_b);
    const std::size_t p1 = a.corner;
    const std::size_t p2 = b.corner;
    // Where a lone corner is below, swapping q and r of the other triangle reverses the normal from
    // which the corner's side is seen. So both lone corners are above, as in the paper.
    const std::size_t q1 = b.is_above ? next(p1) : next(next(p1));
    const std::size_t r1 = 3 - p1 - q1;
    const std::size_t q2 = a.is_above ? next(p2) : next(next(p2));
    const std::size_t r2 = 3 - p2 - q2;
    const int first = signs.edge_side(p1, q1, 3 + p2, 3 + q2);
    if (first > 0) {
        return PairClass::Separate;
    }
    const int second = signs.edge_side(p1, r1, 3 + p2, 3 + r2);
    if (second < 0) {
        return PairClass::Separate;
    }
    // The relative interiors meet if both triangles cross the other's plane, so that both intervals
    // have length, and the open intervals overlap.
    const bool both_cross = count(of_a, 1) > 0 && count(of_a, -1) > 0 && //
                            count(of_b, 1) > 0 && count(of_b, -1) > 0;
    return both_cross && first < 0 && second > 0 ? PairClass::Proper : PairClass::Touch;
}

/// Decides a segment (a degenerate triangle) against a triangle with area, whose plane the segment
/// reaches but does not lie in. The segment's line misses the triangle if the line is on different
/// sides of two edges. `first` is the segment's first corner, 0 or 3; `sides` are the sides of the
/// segment's corners.
template <CornerSigns Signs>
PairClass decide_piercing(Signs& signs, std::size_t first, const PlaneSides& sides) {
    const LoneCorner lone = lone_corner(sides);
    const std::size_t from = first + lone.corner;
    const std::size_t to = next_of(first, from);
    bool above = false;
    bool below = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const int side = first == 0 ? signs.edge_side(from, to, 3 + i, 3 + next(i))
                                    : signs.edge_side(i, next(i), from, to);
        above = above || side > 0;
        below = below || side < 0;
    }
    return above && below ? PairClass::Separate : PairClass::Touch;
}

/// Classifies the corners of the triangle that starts at corner `other` against edge i of the
/// triangle that starts at corner `first` and has the turn `own`: 1 if all are strictly outside, 0
/// if all are outside or on the edge's line, -1 otherwise. If `Signs` has `turns(i, j, axis,
/// enough)`, it returns the turns from i over j to the other triangle's corners; after a turn that
/// equals `enough` the rest may be anything.
template <CornerSigns Signs>
[[gnu::always_inline]] inline int outside_of_edge(
    Signs& signs, std::size_t first, std::size_t i, int own, std::size_t other, std::size_t axis) {
    if constexpr (requires { signs.turns(first, first, axis, own); }) {
        const PlaneSides turns = signs.turns(first + i, first + next(i), axis, own);
        return is_any(turns, own) ? -1 : static_cast<int>(all_are(turns, -own));
    }
    int verdict = 1;
    for (std::size_t j = 0; j < 3; ++j) {
        const int side = signs.turn(first + i, first + next(i), other + j, axis) * own;
        if (side > 0) {
            return -1;
        }
        verdict = side == 0 ? 0 : verdict;
    }
    return verdict;
}

/// Decides two coplanar triangles with area, projected along `axis`, where both keep an area. For
/// convex sets in two dimensions the separating axes are normals of edges (Ericson, Real-Time
/// Collision Detection, 5.2.1). `turn_a` and `turn_b` are the turns of the triangles' corners, 1 or
/// -1.
template <CornerSigns Signs>
PairClass decide_coplanar(Signs& signs, std::size_t axis, int turn_a, int turn_b) {
    bool overlap = true;
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
        const int of_a = outside_of_edge(signs, 0, i, turn_a, 3, axis);
        if (of_a == 1) {
            return PairClass::Separate;
        }
        const int of_b = outside_of_edge(signs, 3, i, turn_b, 0, axis);
        if (of_b == 1) {
            return PairClass::Separate;
        }
        overlap = overlap && of_a < 0 && of_b < 0;
    }
    return overlap ? PairClass::Coplanar : PairClass::Touch;
}

/// Tests whether all of A's corners are strictly below, or all above, all of B's along `axis`.
template <CornerSigns Signs>
bool is_apart_along(Signs& signs, std::size_t axis) {
    bool below = true;
    bool above = true;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 3; j < 6; ++j) {
            const int sign = signs.difference(i, j, axis);
            below = below && sign < 0;
            above = above && sign > 0;
        }
    }
    return below || above;
}

/// Tests whether, seen along `axis`, an edge of the triangle that starts at corner `first` has all
/// corners of the other triangle strictly on one side and no corner of its own triangle there. An
/// edge seen as a point separates nothing.
template <CornerSigns Signs>
bool is_apart_at_edge(Signs& signs, std::size_t first, std::size_t other, std::size_t axis) {
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t from = first + i;
        const std::size_t to = next_of(first, from);
        const int side = signs.turn(from, to, other, axis);
        if (side != 0 && signs.turn(from, to, other + 1, axis) == side &&
            signs.turn(from, to, other + 2, axis) == side &&
            signs.turn(from, to, next_of(first, to), axis) != side) {
            return true;
        }
    }
    return false;
}

/// Decides two triangles in one plane, at least one of them degenerate. They meet if and only if
/// their projections along every axis meet: along one axis the plane is not projected to a line,
/// and a meeting is seen along all. In a projection the possible separating axes are normals of
/// edges. If all edges are parallel or points, the coordinate axes cover the direction along the
/// edges.
template <CornerSigns Signs>
PairClass decide_degenerate(Signs& signs) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (is_apart_along(signs, axis)) {
            return PairClass::Separate;
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (is_apart_at_edge(signs, 0, 3, axis) || is_apart_at_edge(signs, 3, 0, axis)) {
            return PairClass::Separate;
        }
    }
    return PairClass::Touch;
}

/// An axis along which a triangle's projection has area, and the turn of the projection, 1 or -1.
/// The turn is 0 for a degenerate triangle, whose projections have no area along any axis.
struct View {
    std::size_t axis = 0;
    int turn = 0;
};

template <CornerSigns Signs>
View open_view(Signs& signs, std::size_t first) {
    View view;
    for (; view.axis < 3; ++view.axis) {
        view.turn = signs.turn(first, first + 1, first + 2, view.axis);
        if (view.turn != 0) {
            break;
        }
    }
    return view;
}

/// Tests whether no plane contains both of two degenerate triangles. A plane contains both if each
/// edge of one triangle is coplanar with each edge of the other.
template <CornerSigns Signs>
bool are_segments_skew(Signs& signs) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            if (signs.edge_side(i, next(i), 3 + j, 3 + next(j)) != 0) {
                return true;
            }
        }
    }
    return false;
}

/// Decides a pair whose six sides are all 0: both triangles lie in one plane, or both are
/// degenerate.
template <CornerSigns Signs>
PairClass decide_flat(Signs& signs) {
    const View a = open_view(signs, 0);
    if (a.turn != 0) {
        // In a common plane this view also shows B's area, if it has any.
        const int turn_b = signs.turn(3, 4, 5, a.axis);
        return turn_b != 0 ? decide_coplanar(signs, a.axis, a.turn, turn_b)
                           : decide_degenerate(signs);
    }
    if (open_view(signs, 3).turn == 0 && are_segments_skew(signs)) {
        return PairClass::Separate;
    }
    return decide_degenerate(signs);
}

} // namespace pair_decision

/// Classifies the pair whose signs `signs` provides. Asks only for signs that the decision needs,
/// each at most once.
template <CornerSigns Signs>
[[nodiscard]] PairClass decide_pair(Signs& signs) {
    using namespace pair_decision;
    const PlaneSides of_a = signs.sides_of_a();
    if (is_one_sided(of_a)) {
        return PairClass::Separate;
    }
    const PlaneSides of_b = signs.sides_of_b();
    if (is_one_sided(of_b)) {
        return PairClass::Separate;
    }
    // If all sides of A are 0, A lies in B's plane or B has no area. If one side of B is then not
    // 0, A has area and lies in another plane, so B has no area.
    const bool a_flat = all_are(of_a, 0);
    const bool b_flat = all_are(of_b, 0);
    if (a_flat && b_flat) {
        return decide_flat(signs);
    }
    if (a_flat) {
        return decide_piercing(signs, 3, of_b);
    }
    if (b_flat) {
        return decide_piercing(signs, 0, of_a);
    }
    return decide_crossing(signs, of_a, of_b);
}

} // namespace cd
