// Proves bounds of the distance of two triangles in doubles or double-doubles.
//
// Lemma. For points x of S and y of T, and any v other than 0,
//     (min_j v.T_j - max_i v.S_i) / |v|  <=  distance of S and T  <=  |y - x|,
// since v.(t - s) <= |v| |t - s|, and the left side is linear in the corners. So whoever proposes
// x, y and v need not be trusted: a proof is two evaluations with bounds of their errors.
//
// Bounds, with u for the roundoff: a product and a quotient err by u and 2 u relatively, a sum by u
// (|l| + |r|) (double_double.hpp; doubles err less). Corners are relative to a point near the
// triangles. L bounds their coordinates, computed or true, and h the coordinates' errors. |x| is
// the Euclidean length, at most sqrt(3) times the largest coordinate.
//
// Upper bound. x = c0 + l1 (c1 - c0) + l2 (c2 - c0) with weights that are exactly in the triangle.
// The corners' errors move it by at most h. The differences err by 2 u L, the products by another
// 2 u L in all, since l1 + l2 <= 1, their sum by 2 u L and the last sum by 3 u L: 9 u L. y - x
// errs by 2 h + 18 u L + 2 u L in a component, which is 3.5 h + 34.7 u L in length. The square of
// the length errs by 3 u relatively and its root by u: 2.5 u times 3.5 L. In all 3.5 h + 44 u L.
//
// Lower bound. v.c errs by 3 u |v| |c| and, from the corner's error, by 1.74 h |v|; so both sums
// err by 2 (5.2 u L + 1.74 h) |v|. Their difference rounds by u times 3.5 L |v|. The quotient, at
// most 3.5 L, errs by 2 u relatively and by 2.5 u from |v|: 15.8 u L. In all 3.5 h + 29.7 u L.
//
// So e = 4 h + 50 u L covers both, terms of higher order and the rounding of bounds.
//
// Underflow loses at most 2^-1072 in a scalar product, divided by |v|, which is at least 2^-450:
// nothing beside h, which callers keep above 2^-400. Callers bound the magnitudes of all terms by
// 2^200, so that nothing overflows: the largest product has the eighth power of a length, 2^813.
#pragma once

#include "common/distance/nearest_points.hpp"
#include "common/pair/numbers/double_double.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace cd {

/// Bounds of a distance: lower - error <= distance <= upper + error.
template <class Number>
struct DistanceBounds {
    Number lower{};
    Number upper{};
    double error = 0;
    bool are_proven = false; ///< If false, the other members mean nothing.
};

/// What bounds the errors of a pair's numbers.
struct CertificateErrors {
    double corner = 0;   ///< Bounds the error of each coordinate of a corner.
    double roundoff = 0; ///< Relative error of a product, as named above.
    double scale = 1;    ///< Multiplies all error bounds; less than 1 proves nothing.
};

namespace distance_certificate {

inline constexpr double weight_corner = 4; // Of h.
inline constexpr double weight_reach = 50; // Of u L.
inline constexpr double square_least = 0x1p-900;

template <class Number>
using Vector = std::array<Number, 3>;
/// The corners of A, then of B.
template <class Number>
using SixCorners = std::array<Vector<Number>, 6>;

inline double leading(double value) {
    return value;
}
inline double leading(const DoubleDouble& value) {
    return value.high;
}
inline bool is_less(double l, double r) {
    return l < r;
}
inline bool is_less(const DoubleDouble& l, const DoubleDouble& r) {
    return l.high < r.high || (l.high == r.high && l.low < r.low);
}
inline double root(double square) {
    return std::sqrt(square);
}
/// One step of Newton's method doubles the digits of the first root; it errs by less than 8 u^2.
inline DoubleDouble root(const DoubleDouble& square) {
    const double first = std::sqrt(square.high);
    const DoubleDouble rest = square - exact_product(first, first);
    return exact_sum_ordered(first, rest.high / (2 * first));
}

template <class Number>
Vector<Number> difference(const Vector<Number>& l, const Vector<Number>& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}
template <class Number>
Number scalar(const Vector<Number>& l, const Vector<Number>& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}
template <class Number>
Vector<Number> cross(const Vector<Number>& l, const Vector<Number>& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}
template <class Number>
Vector<Number> moved(const Vector<Number>& p, const Vector<Number>& along, const Number& by) {
    return {p[0] + along[0] * by, p[1] + along[1] * by, p[2] + along[2] * by};
}
/// Returns the nearest number of [0, 1]; 0 for NaN.
template <class Number>
Number clamped(const Number& share) {
    if (!is_less(Number{0}, share)) {
        return Number{0};
    }
    return is_less(Number{1}, share) ? Number{1} : share;
}

/// Proposed points of both triangles and a direction from one to the other, of either sign.
template <class Number>
struct Proposal {
    Vector<Number> x;
    Vector<Number> y;
    Vector<Number> direction;
    bool is_inside = true; ///< False unless the points provably belong to the triangles.
};

/// The corners of an edge.
template <class Number>
struct Edge {
    const Vector<Number>& from;
    const Vector<Number>& to;
};

template <class Number>
Vector<Number> point_near(const Vector<Number>& p, const Edge<Number>& edge) {
    const Vector<Number> along = difference(edge.to, edge.from);
    const Number share =
        clamped(Number(scalar(difference(p, edge.from), along) / scalar(along, along)));
    return moved(edge.from, along, share);
}

/// Proposes the points of a corner, which is `x`, and a face.
template <class Number>
Proposal<Number> at_face(const Vector<Number>& p, const Vector<Number>* face, double roundoff) {
    const Vector<Number> u = difference(face[1], face[0]);
    const Vector<Number> v = difference(face[2], face[0]);
    const Vector<Number> w = difference(p, face[0]);
    const Vector<Number> normal = cross(u, v);
    const Number area = scalar(normal, normal);
    const Number of_u = clamped(Number(scalar(cross(w, v), normal) / area));
    const Number of_v = clamped(Number(scalar(cross(u, w), normal) / area));
    // The third weight errs by less than 8 u.
    const double third = leading(Number(Number{1} - of_u - of_v));
    Proposal<Number> proposal{p, {}, normal, third > 8 * roundoff};
    for (std::size_t k = 0; k < 3; ++k) {
        proposal.y[k] = face[0][k] + (u[k] * of_u + v[k] * of_v);
    }
    return proposal;
}

template <class Number>
Proposal<Number> at_edges(const Edge<Number>& a, const Edge<Number>& b) {
    const Vector<Number> u = difference(a.to, a.from);
    const Vector<Number> v = difference(b.to, b.from);
    const Vector<Number> w = difference(b.from, a.from);
    const Vector<Number> normal = cross(u, v);
    const Number square = scalar(normal, normal);
    const Number of_u = clamped(Number(scalar(cross(w, v), normal) / square));
    const Number of_v = clamped(Number(scalar(cross(w, u), normal) / square));
    return {moved(a.from, u, of_u), moved(b.from, v, of_v), normal, true};
}

template <class Number>
Proposal<Number>
proposal_of(const SixCorners<Number>& corners, std::size_t number, double roundoff) {
    const Vector<Number>* const a = corners.data();
    const Vector<Number>* const b = a + 3;
    const auto edge = [](const Vector<Number>* of, std::size_t k) {
        return Edge<Number>{of[k], of[(k + 1) % 3]};
    };
    const std::size_t i = number / 3 % 3;
    const std::size_t j = number % 3;
    Proposal<Number> made;
    if (number >= feature::edge_edge) {
        return at_edges(edge(a, (number - feature::edge_edge) / 3), edge(b, j));
    }
    if (number >= feature::face_corner) {
        made = at_face(b[j], a, roundoff);
        std::swap(made.x, made.y);
        return made;
    }
    if (number >= feature::corner_face) {
        return at_face(a[j], b, roundoff);
    }
    if (number >= feature::edge_corner) {
        made.x = point_near(b[j], edge(a, i));
        made.y = b[j];
    } else if (number >= feature::corner_edge) {
        made.x = a[i];
        made.y = point_near(a[i], edge(b, j));
    } else {
        made.x = a[i];
        made.y = b[j];
    }
    made.direction = difference(made.y, made.x);
    return made;
}

/// Returns the length of the gap between both triangles' projections on a direction, times its own
/// length; negative where they overlap.
template <class Number>
Number gap_along(const Vector<Number>& direction, const SixCorners<Number>& corners) {
    std::array<Number, 6> at;
    std::transform(corners.begin(), corners.end(), at.begin(), [&](const Vector<Number>& c) {
        return scalar(direction, c);
    });
    const auto less = [](const Number& l, const Number& r) { return is_less(l, r); };
    const auto [least_a, most_a] = std::minmax_element(at.begin(), at.begin() + 3, less);
    const auto [least_b, most_b] = std::minmax_element(at.begin() + 3, at.end(), less);
    return std::max(Number(*least_b - *most_a), Number(*least_a - *most_b), less);
}

} // namespace distance_certificate

/// Proves bounds of the distance from a feature that is proposed, with its points evaluated in
/// Number, which is double or DoubleDouble. `corners` are those of A, then of B, within the
/// magnitudes named above.
template <class Number>
[[nodiscard]] DistanceBounds<Number>
certified_bounds(const distance_certificate::SixCorners<Number>& corners,
                 std::size_t proposed,
                 const CertificateErrors& errors) {
    using namespace distance_certificate;
    const Proposal<Number> proposal = proposal_of(corners, proposed, errors.roundoff);
    const Number square = scalar(proposal.direction, proposal.direction);
    const Vector<Number> apart = difference(proposal.y, proposal.x);
    const Number apart_square = scalar(apart, apart);
    DistanceBounds<Number> bounds;
    if (!proposal.is_inside || !(leading(square) >= square_least) ||
        !(leading(apart_square) >= square_least)) {
        return bounds;
    }
    double reach = errors.corner;
    for (const Vector<Number>& corner : corners) {
        for (const Number& coordinate : corner) {
            reach = std::max(reach, std::abs(leading(coordinate)));
        }
    }
    bounds.lower = gap_along(proposal.direction, corners) / root(square);
    bounds.upper = root(apart_square);
    bounds.error = errors.scale * (weight_corner * errors.corner +
                                   weight_reach * errors.roundoff * (reach + errors.corner));
    bounds.are_proven = true;
    return bounds;
}

} // namespace cd
