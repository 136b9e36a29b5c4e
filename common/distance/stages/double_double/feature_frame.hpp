// Proves whether a feature has its nearest points inside its edges or face, in doubles or
// double-doubles.
//
// Bounds, with u for the roundoff and lengths as in distance_certificate.hpp. A difference of two
// corners errs by a vector of length at most d. The gap of a feature is w - f u - g v, with one or
// two vectors along its edges, no longer than E, and W for the length of w.
//
// One share: f = w.u / u.u. The dividend errs by d (W + E) + 4 u W E, the divisor by 2 d E + 4 u
// E^2.
//
// Two shares: with c = u x v, f = (w x v).c / c.c and g = (u x w).c / c.c. A cross product errs by
// d times both lengths and by 8 u of their product. So c errs by dc = 2 d E + 8 u E^2, a dividend
// by |c| (d (W + E) + 8 u W E) + W E dc + 4 u W E |c|, and the divisor by 2 |c| dc + 4 u |c|^2.
//
// A share of at most m >= 1 errs by (its dividend's error + m times that of the divisor) / divisor
// and 4 u m. The factor 1.1 covers terms of higher order, since the divisor must be 100 times its
// error.
#pragma once

#include "common/distance/distance_certificate.hpp"
#include "common/distance/nearest_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cd {

namespace feature_frame {

using distance_certificate::cross;
using distance_certificate::difference;
using distance_certificate::leading;
using distance_certificate::scalar;
using distance_certificate::SixCorners;
using distance_certificate::Vector;

/// A feature as the vectors of its gap, w - f u - g v.
template <class Number>
struct Frame {
    Vector<Number> w;
    Vector<Number> u;
    Vector<Number> v;
    int vectors = 0; ///< How many of u and v there are.
    bool is_face = false;
};

/// Bounds the errors of the vectors of frames.
struct FrameErrors {
    double difference = 0; ///< Bounds the length of the error of w, u and v.
    double roundoff = 0;
};

enum class Standing { Unknown, Valid, Invalid };

/// The shares of a feature's points, and what they prove.
template <class Number>
struct Shares {
    Number first{};
    Number second{};
    double error = 0;    ///< Bounds the error of each share.
    double length = 0;   ///< Bounds the length of u and v.
    double distance = 0; ///< Bounds the length of w.
    Standing standing = Standing::Unknown;
};

template <class Number>
Frame<Number> face_frame(const Vector<Number>& p, const Vector<Number>* face) {
    return {difference(p, face[0]),
            difference(face[1], face[0]),
            difference(face[2], face[0]),
            2,
            true};
}

template <class Number>
Frame<Number> frame_of(const SixCorners<Number>& corners, std::size_t number) {
    const Vector<Number>* const a = corners.data();
    const Vector<Number>* const b = a + 3;
    const std::size_t i = number / 3 % 3;
    const std::size_t j = number % 3;
    const auto edge = [](const Vector<Number>* of, std::size_t k) {
        return difference(of[(k + 1) % 3], of[k]);
    };
    if (number >= feature::edge_edge) {
        const std::size_t k = (number - feature::edge_edge) / 3;
        return {difference(b[j], a[k]), edge(a, k), difference(b[j], b[(j + 1) % 3]), 2, false};
    }
    if (number >= feature::face_corner) {
        return face_frame(b[j], a);
    }
    if (number >= feature::corner_face) {
        return face_frame(a[j], b);
    }
    if (number >= feature::edge_corner) {
        return {difference(b[j], a[i]), edge(a, i), {}, 1, false};
    }
    if (number >= feature::corner_edge) {
        return {difference(a[i], b[j]), edge(b, j), {}, 1, false};
    }
    return {difference(a[i], b[j]), {}, {}, 0, false};
}

/// Bounds the length of a vector that errs by at most `error`.
template <class Number>
double length_of(const Vector<Number>& v, double error) {
    return 1.01 * std::sqrt(leading(scalar(v, v))) + error;
}

/// Tells what follows from a number that is inside if it is positive.
inline Standing standing_of(double inside, double error) {
    return inside > error    ? Standing::Valid
           : inside < -error ? Standing::Invalid
                             : Standing::Unknown;
}

/// A feature is valid if all its conditions hold, and invalid if one does not.
inline Standing both(Standing l, Standing r) {
    if (l == Standing::Invalid || r == Standing::Invalid) {
        return Standing::Invalid;
    }
    return l == Standing::Valid && r == Standing::Valid ? Standing::Valid : Standing::Unknown;
}

template <class Number>
Standing standing_in_range(const Number& share, double error) {
    return both(standing_of(leading(share), error),
                standing_of(leading(Number(Number{1} - share)), error));
}

template <class Number>
Shares<Number> shares_of(const Frame<Number>& frame, const FrameErrors& errors) {
    const double d = errors.difference;
    const double round = errors.roundoff;
    Shares<Number> shares;
    shares.distance = length_of(frame.w, d);
    if (frame.vectors == 0) {
        shares.standing = Standing::Valid;
        return shares;
    }
    const double e = std::max(length_of(frame.u, d), length_of(frame.v, d));
    const double w = shares.distance;
    shares.length = e;
    Number divisor{};
    double dividend_error = d * (w + e) + 4 * round * w * e;
    double divisor_error = 2 * d * e + 4 * round * e * e;
    if (frame.vectors == 1) {
        divisor = scalar(frame.u, frame.u);
        shares.first = scalar(frame.w, frame.u) / divisor;
    } else {
        const Vector<Number> c = cross(frame.u, frame.v);
        divisor = scalar(c, c);
        shares.first = scalar(cross(frame.w, frame.v), c) / divisor;
        shares.second = scalar(cross(frame.u, frame.w), c) / divisor;
        const double area = 1.01 * std::sqrt(leading(divisor));
        const double area_error = 2 * d * e + 8 * round * e * e;
        dividend_error = area * (d * (w + e) + 12 * round * w * e) + w * e * area_error;
        divisor_error = 2 * area * area_error + 4 * round * area * area;
    }
    if (!(leading(divisor) > 100 * divisor_error)) {
        return shares;
    }
    const double most =
        std::max({1.0, std::abs(leading(shares.first)), std::abs(leading(shares.second))});
    shares.error =
        1.1 * (dividend_error + most * divisor_error) / leading(divisor) + 4 * round * most;
    if (frame.is_face) {
        const Number third = Number{1} - shares.first - shares.second;
        shares.standing = both(standing_of(leading(third), 2 * shares.error + 8 * round * most),
                               both(standing_of(leading(shares.first), shares.error),
                                    standing_of(leading(shares.second), shares.error)));
    } else {
        // The difference from 1 is rounded once more.
        const double error = shares.error + 4 * round * most;
        shares.standing = standing_in_range(shares.first, error);
        if (frame.vectors == 2) {
            shares.standing = both(shares.standing, standing_in_range(shares.second, error));
        }
    }
    return shares;
}

/// Bounds the distance of a feature from below, if it is valid. Both points' shares err, and so do
/// the vectors that the shares, which are in [0, 1], multiply.
inline double least_distance(const Frame<double>& frame, const FrameErrors& errors) {
    const Shares<double> shares = shares_of(frame, errors);
    if (shares.standing == Standing::Invalid) {
        return std::numeric_limits<double>::infinity();
    }
    if (frame.vectors > 0 && shares.error == 0) {
        return 0; // The shares are not known.
    }
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double gap = frame.w[k] - (shares.first * frame.u[k] + shares.second * frame.v[k]);
        square += gap * gap;
    }
    const double reach = shares.distance + 2 * shares.length;
    const double error = (1 + frame.vectors) * errors.difference +
                         frame.vectors * shares.error * shares.length +
                         10 * errors.roundoff * reach;
    return std::sqrt(square) - 1.01 * error;
}

} // namespace feature_frame

} // namespace cd
