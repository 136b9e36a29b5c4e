#include "common/geometry/double_double_points.hpp"

#include "common/geometry/double_double_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace cd {

namespace {

using Vector = DoubleDoublePoints::Vector;
using Map = DoubleDoublePoints::Map;
using Local = DoubleDoublePoints::Local;

constexpr double u = 0x1p-53; // Unit roundoff of double.
constexpr double e = double_double_error;

// Magnitudes within which neither overflow nor underflow matters: products of four lengths stay far
// below 2^996, and what underflow does, some 2^-1074, far below any bound in use here.
constexpr double length_least = 0x1p-200;
constexpr double length_most = 0x1p200;
constexpr double side_error_least = 0x1p-900;

Vector operator-(const Vector& l, const Vector& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

DoubleDouble dot(const Vector& l, const Vector& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

Vector cross(const Vector& l, const Vector& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

Map map_of(const Pose& pose) {
    const bool is_matrix = pose.kind() == Pose::Kind::Matrix;
    return {double_double_rotation(pose),
            pose.translation(),
            is_matrix ? pose.matrix().cwiseAbs().maxCoeff() : 1};
}

/// Bounds the magnitudes of the terms of R x + offset.
double magnitude_of(const Map& map, const Vec3& x, const Vec3& offset) {
    return 1.01 * (map.largest * x.cwiseAbs().sum() + offset.cwiseAbs().maxCoeff());
}

/// Bounds the error of each component of a point computed by `posed`, for terms of at most that
/// magnitude: 10 e from the rotation, e from each product and e from each of the three sums, with
/// room for terms of higher order and for the roundings of the bounds themselves.
double point_error(double magnitude) {
    return 20 * e * magnitude;
}

/// R x + t - origin.
Vector posed(const Map& map, const Vec3& x, const Vec3& origin) {
    Vector result;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const Vector& row = map.rows[k];
        result[k] = exact_sum(map.translation[axis], -origin[axis]) + row[0] * x[0] +
                    (row[1] * x[1] + row[2] * x[2]);
    }
    return result;
}

/// Whether component k of what `posed` computes is 0 for sure: it is t - origin and one product,
/// both exact doubles.
bool is_exactly_zero(const Map& map, const Vec3& x, const Vec3& origin, std::size_t k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const DoubleDouble shift = exact_sum(map.translation[axis], -origin[axis]);
    DoubleDouble product;
    int products = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        const DoubleDouble& entry = map.rows[k][j];
        const double factor = x[static_cast<Eigen::Index>(j)];
        if (entry.low != 0 || (entry.high != 0 && std::abs(entry.high) < length_least) ||
            (factor != 0 && std::abs(factor) < length_least)) {
            return false; // Not exact, or it may underflow.
        }
        if (entry.high != 0 && factor != 0) {
            product = exact_product(entry.high, factor);
            ++products;
        }
    }
    return products <= 1 && shift.low == 0 && product.low == 0 && shift.high == -product.high;
}

/// The nearest double of a number that is within `error` of `value`, if that is the same for all
/// of these (Ziv's test). The second term of the margin covers the rounding of the two inner sums,
/// u (u |high| + margin) at most. Where the answer is not 0 it is never -0.
std::optional<double> rounded(const DoubleDouble& value, double error) {
    const double margin = 1.01 * error + 0x1p-104 * std::abs(value.high);
    const double least = value.high + (value.low - margin);
    const double greatest = value.high + (value.low + margin);
    return least == greatest ? std::optional(least) : std::nullopt;
}

Local local_of(const Map& map, const Corners& corners, const Vec3& origin) {
    Local local;
    for (std::size_t i = 0; i < 3; ++i) {
        local.corners[i] = posed(map, corners[i], origin);
        for (std::size_t k = 0; k < 3; ++k) {
            local.is_zero[i][k] = is_exactly_zero(map, corners[i], origin, k);
        }
        local.magnitude = std::max(local.magnitude,
                                   magnitude_of(map, corners[i], Vec3(map.translation - origin)));
        const Vector& c = local.corners[i];
        const Vec3 high(c[0].high, c[1].high, c[2].high);
        local.least = i == 0 ? high : Vec3(local.least.cwiseMin(high));
        local.greatest = i == 0 ? high : Vec3(local.greatest.cwiseMax(high));
    }
    local.normal = cross(local.corners[1] - local.corners[0], local.corners[2] - local.corners[0]);
    return local;
}

/// Bounds of the lengths in a pair, and of the errors that follow from them. All are of single
/// components, and of computed and of true values alike.
///
/// Let d bound the error of a corner. A difference of two corners errs by 2 d and the rounding of
/// the subtraction, by d1 = 2.2 d in all. Let Lb bound differences of corners of B, and L those of
/// any two corners. A component of B's normal, of two products of edges, is at most 2 Lb^2 and errs
/// by 4 Lb d1 + 4 e Lb^2. The side of a corner p, the normal's dot product with p - b0, errs in its
/// three products by 3 (2 Lb^2 d1 + L (4 Lb d1 + 4 e Lb^2)) and is rounded by 3 (2 e) + 4 e + 6 e
/// times Lb^2 L. With Lb <= L that is at most Lb L (40 d + 28 e Lb); 48 Lb L (d + e Lb) leaves room
/// for terms of higher order and the roundings of the bound itself.
struct Bounds {
    double corner_error = 0;
    double length_a = 0;
    double length_b = 0;
    double side_error_a = 0; ///< Of sides of A's plane.
    double side_error_b = 0;
    bool usable = false;

    Bounds(const Local& a, const Local& b) {
        const double magnitude = std::max(a.magnitude, b.magnitude);
        corner_error = point_error(magnitude);
        const Vec3 least = a.least.cwiseMin(b.least);
        const Vec3 greatest = a.greatest.cwiseMax(b.greatest);
        const double farthest =
            std::max(least.cwiseAbs().maxCoeff(), greatest.cwiseAbs().maxCoeff());
        // High parts are within u of the whole.
        const auto length = [&](const Vec3& from, const Vec3& to) {
            return 1.01 * (to - from).maxCoeff() + 4 * u * farthest + 4 * corner_error;
        };
        length_a = length(a.least, a.greatest);
        length_b = length(b.least, b.greatest);
        const double across = length(least, greatest);
        side_error_a = 48 * length_a * across * (corner_error + e * length_a);
        side_error_b = 48 * length_b * across * (corner_error + e * length_b);
        usable = magnitude >= length_least && magnitude <= length_most &&
                 side_error_a >= side_error_least && side_error_b >= side_error_least;
    }
};

/// A place on an edge, at a share of the way from one corner to another.
struct Place {
    const Vector* from = nullptr;
    const Vector* to = nullptr;
    DoubleDouble share;
    double error = 0;              ///< Of each component.
    DoubleDouble along;            ///< The component by which places are compared.
    std::array<bool, 3> is_zero{}; ///< The components that are 0 for sure.

    [[nodiscard]] DoubleDouble component(std::size_t k) const {
        return (*from)[k] + share * ((*to)[k] - (*from)[k]);
    }
};

/// Two places, by a component in which the first is known to be less.
using Ends = std::array<Place, 2>;

/// Whether x < y or y < x for sure, in the component at hand: -1, 1, or else 0.
int order(const Place& x, const Place& y) {
    const double difference = (x.along - y.along).high;
    const double error = 1.01 * (x.error + y.error);
    return difference > error ? 1 : -difference > error ? -1 : 0;
}

/// Where two edges of a triangle cross the other's plane, if it is certain that just two edges do
/// so, away from corners.
///
/// With s and t the sides of the ends of an edge, the share s / (s - t) errs by
/// (|t| ds + |s| ds) / |(s - t)(s - t)'| for sides that err by ds, which is ds / |s - t|, as the
/// signs differ; rounding adds e for the divisor and 2 e for the quotient. The place errs by d of
/// its corner, d1 of the difference, La times the error of the share, e La of the product and of
/// the sum, and e times a coordinate, which is less than d / 10.
std::optional<Ends> crossings(
    const Local& of, double length, const Local& with, double side_error, double corner_error) {
    Vector sides;
    int positive = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sides[i] = dot(with.normal, of.corners[i] - with.corners[0]);
        if (!(std::abs(sides[i].high) > 1.01 * side_error)) {
            return std::nullopt;
        }
        positive += sides[i].high > 0 ? 1 : 0;
    }
    if (positive == 0 || positive == 3) {
        return std::nullopt;
    }
    // The corner that is alone on its side.
    std::size_t lone = 0;
    while ((sides[lone].high > 0) != (positive == 1)) {
        ++lone;
    }
    Ends ends;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t other = (lone + 1 + i) % 3;
        const DoubleDouble divisor = sides[lone] - sides[other];
        ends[i].from = &of.corners[lone];
        ends[i].to = &of.corners[other];
        for (std::size_t k = 0; k < 3; ++k) {
            // Of the edge, or of the whole of the other triangle.
            ends[i].is_zero[k] = (of.is_zero[lone][k] && of.is_zero[other][k]) ||
                                 (with.is_zero[0][k] && with.is_zero[1][k] && with.is_zero[2][k]);
        }
        ends[i].share = sides[lone] / divisor;
        ends[i].error =
            4 * corner_error + length * (1.2 * side_error / std::abs(divisor.high) + 8 * e);
    }
    return ends;
}

/// Compares by component k from now on, and puts both ends in order; false where that is open.
bool sort(Ends& ends, std::size_t k) {
    for (Place& place : ends) {
        place.along = place.component(k);
    }
    const int found = order(ends[0], ends[1]);
    if (found > 0) {
        std::swap(ends[0], ends[1]);
    }
    return found != 0;
}

/// What is common to two intervals of a line, sorted by one component.
std::optional<Ends> common_part(const Ends& a, const Ends& b) {
    const int low = order(a[0], b[0]);
    const int high = order(a[1], b[1]);
    if (low == 0 || high == 0) {
        return std::nullopt;
    }
    const Ends common{low > 0 ? a[0] : b[0], high < 0 ? a[1] : b[1]};
    return order(common[0], common[1]) < 0 ? std::optional(common) : std::nullopt;
}

std::optional<std::array<Vec3, 2>> rounded(const Ends& ends) {
    std::array<Vec3, 2> points;
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto value = ends[i].is_zero[k] ? std::optional(0.0)
                                                  : rounded(ends[i].component(k), ends[i].error);
            if (!value) {
                return std::nullopt;
            }
            points[i][static_cast<Eigen::Index>(k)] = *value;
        }
    }
    return points;
}

/// The axis along which a line is longest, as far as doubles tell.
std::size_t main_axis(const Vector& normal_a, const Vector& normal_b) {
    const Vec3 a(normal_a[0].high, normal_a[1].high, normal_a[2].high);
    const Vec3 b(normal_b[0].high, normal_b[1].high, normal_b[2].high);
    const Vec3 line(a.y() * b.z() - a.z() * b.y(),
                    a.z() * b.x() - a.x() * b.z(),
                    a.x() * b.y() - a.y() * b.x());
    Eigen::Index axis = 0;
    line.cwiseAbs().maxCoeff(&axis);
    return static_cast<std::size_t>(axis);
}

} // namespace

DoubleDoublePoints::DoubleDoublePoints(const PosePair& poses)
    : a_(map_of(poses.a)), b_(map_of(poses.b)) {}

std::optional<Vec3> DoubleDoublePoints::origin(const Corners& a) const {
    const double magnitude = magnitude_of(a_, a[0], a_.translation);
    if (!(magnitude >= length_least && magnitude <= length_most)) {
        return std::nullopt;
    }
    const Vector nearby = posed(a_, a[0], Vec3::Zero());
    Vec3 origin;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto value = is_exactly_zero(a_, a[0], Vec3::Zero(), k)
                               ? std::optional(0.0)
                               : rounded(nearby[k], point_error(magnitude));
        if (!value) {
            return std::nullopt;
        }
        origin[static_cast<Eigen::Index>(k)] = *value;
    }
    return origin;
}

std::optional<std::array<Vec3, 2>>
DoubleDoublePoints::points(const Corners& a, const Corners& b, const Vec3& origin) {
    if (!local_a_ || a != last_a_ || origin != last_origin_) {
        local_a_ = local_of(a_, a, origin);
        last_a_ = a;
        last_origin_ = origin;
    }
    const Local& local_a = *local_a_;
    const Local local_b = local_of(b_, b, origin);
    const Bounds bounds(local_a, local_b);
    if (!bounds.usable) {
        return std::nullopt;
    }
    auto on_a =
        crossings(local_a, bounds.length_a, local_b, bounds.side_error_b, bounds.corner_error);
    auto on_b =
        crossings(local_b, bounds.length_b, local_a, bounds.side_error_a, bounds.corner_error);
    if (!on_a || !on_b) {
        return std::nullopt;
    }
    // All four are on the line that the planes share; where two differ in a component, the order of
    // that component is the order along the line.
    const std::size_t axis = main_axis(local_a.normal, local_b.normal);
    if (!sort(*on_a, axis) || !sort(*on_b, axis)) {
        return std::nullopt;
    }
    auto common = common_part(*on_a, *on_b);
    // Last, the first component that differs decides the order in which they are given.
    std::size_t first = 0;
    while (common && first < axis && (*common)[0].is_zero[first] && (*common)[1].is_zero[first]) {
        ++first;
    }
    if (!common || (axis != first && !sort(*common, first))) {
        return std::nullopt;
    }
    return rounded(*common);
}

} // namespace cd
