#include "common/pair/stages/double_double/double_double_positions.hpp"

#include "common/pair/pair_decision.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

using Vector = DoubleDoubleVec;
using ExactComponents = LocalTriangle::ExactComponents;

constexpr double u = 0x1p-53; // Unit roundoff of double.
constexpr double e = double_double_error;

using pair_decision::next;

Vec3 high_of(const Vector& v) {
    return {v[0].high, v[1].high, v[2].high};
}

bool is_same(const std::optional<DoubleDouble>& l, const std::optional<DoubleDouble>& r) {
    return l && r && l->high == r->high && l->low == r->low;
}

/// Sets the exactly known components that both ends of an edge, and so all its points, have in
/// common.
void add_common(LocalPosition& position, const ExactComponents& from, const ExactComponents& to) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (is_same(from[k], to[k])) {
            position.world[k] = from[k];
        }
    }
}

/// Bounds the components of differences between points whose high parts range from `least` to
/// `greatest`; high parts are within u of the whole.
double length_between(const Vec3& least, const Vec3& greatest, double corner_error) {
    const double farthest = std::max(least.cwiseAbs().maxCoeff(), greatest.cwiseAbs().maxCoeff());
    return 1.01 * (greatest - least).maxCoeff() + 4 * u * farthest + 4 * corner_error;
}

double length_of(const LocalTriangle& triangle, const LocalBounds& bounds) {
    return length_between(triangle.least, triangle.greatest, bounds.corner_error);
}

/// Returns twice the area of from, to, point, seen along an axis.
DoubleDouble area(const Vector& from, const Vector& to, const Vector& point, std::size_t axis) {
    const std::size_t x = next(axis);
    const std::size_t y = next(x);
    return (to[x] - from[x]) * (point[y] - from[y]) - (to[y] - from[y]) * (point[x] - from[x]);
}

/// Bounds the error of an area, with room, for points that err by at most `error`. Their
/// differences are at most `across` + 2 error = L and err by d1 = 2.2 error. Two products err by 2
/// L d1 + e L^2 each, and the last difference by 2 e L^2.
double area_error(double across, double error, const LocalBounds& bounds) {
    const double length = across + 3 * error;
    return 12 * length * (error + e * length * bounds.scale);
}

/// The values at both ends of an edge of a function that is linear along the edge and 0 between its
/// ends. The true values have different signs, and neither is 0.
struct Weights {
    DoubleDouble from;
    DoubleDouble to;
    double error = 0; ///< Bounds the error of each value.
};

/// Returns the point of an edge where the function that the weights belong to is 0.
///
/// With s and t the weights, the share s / (s - t) errs by (|t| ds + |s| ds) / |(s - t)(s - t)'|
/// for weights that err by ds. That is ds / |s - t|, as the true signs differ. Rounding adds e for
/// the divisor and 2 e for the quotient. The position errs by the sum of: d of its corner, d1 of
/// the difference, its length times the error of the share, e times it for the product and the sum,
/// and e times a coordinate, which is less than d / 10.
LocalPosition position_on_edge(const LocalHalf& of,
                               std::size_t edge,
                               const Weights& weights,
                               const LocalBounds& bounds) {
    const DoubleDouble divisor = weights.from - weights.to;
    LocalPosition position;
    position.from = &of.own->corners[edge];
    position.to = &of.own->corners[next(edge)];
    position.share = weights.from / divisor;
    position.error =
        4 * bounds.corner_error +
        of.length * (1.2 * weights.error / std::abs(divisor.high) + 8 * e * bounds.scale);
    add_common(position, of.own->world[edge], of.own->world[next(edge)]);
    return position;
}

} // namespace

LocalBounds::LocalBounds(const LocalTriangle& a, const LocalTriangle& b, double bound_scale)
    : corner_error(bound_scale * local_error(std::max(a.magnitude, b.magnitude))),
      across(
          length_between(a.least.cwiseMin(b.least), a.greatest.cwiseMax(b.greatest), corner_error)),
      scale(bound_scale) {}

/// Let d bound the error of a corner. A difference of two corners errs by 2 d and the rounding of
/// the subtraction, by d1 = 2.2 d in all. Let Lb bound differences of corners of B, and L those of
/// any two corners. A component of B's normal, of two products of edges, is at most 2 Lb^2 and errs
/// by 4 Lb d1 + 4 e Lb^2. The side of a corner p is the normal's dot product with p - b0. Its three
/// products err by 3 (2 Lb^2 d1 + L (4 Lb d1 + 4 e Lb^2)), and its rounding by 3 (2 e) + 4 e + 6 e
/// times Lb^2 L. With Lb <= L that is at most Lb L (40 d + 28 e Lb); 48 Lb L (d + e Lb) leaves room
/// for terms of higher order and the bound's own roundings.
LocalHalf::LocalHalf(const LocalTriangle& own_triangle,
                     const LocalTriangle& other_triangle,
                     const LocalBounds& bounds)
    : own(&own_triangle), other(&other_triangle) {
    const double other_length = length_of(*other, bounds);
    length = length_of(*own, bounds);
    side_error =
        48 * other_length * bounds.across * (bounds.corner_error + e * other_length * bounds.scale);
    for (std::size_t i = 0; i < 3; ++i) {
        sides[i] = dot(other->normal, own->corners[i] - other->corners[0]);
        const double side = sides[i].high;
        if (std::abs(side) > 1.01 * side_error) {
            proven[i] = side > 0 ? 1 : -1;
        }
    }
}

LocalPosition
corner_position(const LocalTriangle& of, std::size_t corner, const LocalBounds& bounds) {
    LocalPosition position;
    position.from = &of.corners[corner];
    position.error = bounds.corner_error;
    position.world = of.world[corner];
    return position;
}

LocalPosition piercing_position(const LocalHalf& of, std::size_t edge, const LocalBounds& bounds) {
    LocalPosition position =
        position_on_edge(of, edge, {of.sides[edge], of.sides[next(edge)], of.side_error}, bounds);
    // All points of a triangle perpendicular to an axis have the same coordinate on that axis.
    const auto& world = of.other->world;
    for (std::size_t k = 0; k < 3; ++k) {
        if (is_same(world[0][k], world[1][k]) && is_same(world[0][k], world[2][k])) {
            position.world[k] = world[0][k];
        }
    }
    return position;
}

LocalPosition crossing_position(const LocalHalf& a,
                                std::size_t edge,
                                const LocalHalf& b,
                                std::size_t other,
                                const LocalBounds& bounds) {
    const std::size_t axis = main_axis(high_of(b.own->normal));
    const Vector& from = b.own->corners[other];
    const Vector& to = b.own->corners[next(other)];
    LocalPosition position =
        position_on_edge(a,
                         edge,
                         {area(from, to, a.own->corners[edge], axis),
                          area(from, to, a.own->corners[next(edge)], axis),
                          area_error(bounds.across, bounds.corner_error, bounds)},
                         bounds);
    add_common(position, b.own->world[other], b.own->world[next(other)]);
    return position;
}

std::optional<int> compare(const LocalPosition& x, const LocalPosition& y, std::size_t k) {
    if (x.world[k] && y.world[k]) {
        const DoubleDouble& l = *x.world[k];
        const DoubleDouble& r = *y.world[k];
        return l.high != r.high ? (l.high < r.high ? -1 : 1) : (l.low > r.low) - (l.low < r.low);
    }
    const double difference = (x.component(k) - y.component(k)).high;
    // The difference's rounding adds less than a tenth of the positions' errors.
    const double error = 1.1 * (x.error + y.error);
    return difference > error    ? std::optional(1)
           : -difference > error ? std::optional(-1)
                                 : std::nullopt;
}

std::optional<int> compare(const LocalPosition& x, const LocalPosition& y) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<int> order = compare(x, y, k);
        if (order != 0) {
            return order;
        }
    }
    return std::nullopt;
}

std::optional<int> turn(const LocalPosition& a,
                        const LocalPosition& b,
                        const LocalPosition& c,
                        const LocalHalf& around,
                        const LocalBounds& bounds) {
    const Vec3 normal = high_of(around.own->normal);
    const std::size_t axis = main_axis(normal);
    const auto vector = [](const LocalPosition& position) {
        return Vector{position.component(0), position.component(1), position.component(2)};
    };
    const double up = normal[static_cast<Eigen::Index>(axis)];
    const double value = area(vector(a), vector(b), vector(c), axis).high;
    const double up_error = area_error(bounds.across, bounds.corner_error, bounds);
    const double error = area_error(bounds.across, std::max({a.error, b.error, c.error}), bounds);
    if (!(std::abs(up) > 1.01 * up_error && std::abs(value) > 1.01 * error)) {
        return std::nullopt;
    }
    return (value > 0) == (up > 0) ? 1 : -1;
}

std::size_t main_axis(const Vec3& vector) {
    Eigen::Index axis = 0;
    vector.cwiseAbs().maxCoeff(&axis);
    return static_cast<std::size_t>(axis);
}

/// Applies Ziv's test. The second term of the margin covers the rounding of the two inner sums, at
/// most u (u |high| + margin).
std::optional<double> rounded(const DoubleDouble& value, double error, const LocalBounds& bounds) {
    const double margin = 1.01 * error + bounds.scale * 0x1p-104 * std::abs(value.high);
    const double least = value.high + (value.low - margin);
    const double greatest = value.high + (value.low + margin);
    return least == greatest ? std::optional(least) : std::nullopt;
}

std::optional<double> rounded(const LocalPosition& position,
                              std::size_t k,
                              const Vec3& origin,
                              const LocalBounds& bounds) {
    if (position.world[k]) {
        const DoubleDouble& world = *position.world[k];
        const double from = origin[static_cast<Eigen::Index>(k)];
        if (const auto difference = nearest_sum<3>({world.high, -from, world.low})) {
            return difference;
        }
    }
    return rounded(position.component(k), position.error, bounds);
}

} // namespace cd
