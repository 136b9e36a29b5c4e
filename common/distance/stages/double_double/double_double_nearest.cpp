#include "common/distance/stages/double_double/double_double_nearest.hpp"

#include "common/distance/stages/double_double/double_double_distance.hpp"
#include "common/distance/stages/double_double/feature_frame.hpp"
#include "common/pair/stages/double_double/double_double_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace cd {

namespace {

constexpr double u = 0x1p-53; // Unit roundoff of doubles.

using feature_frame::frame_of;
using feature_frame::FrameErrors;
using feature_frame::least_distance;
using feature_frame::Shares;
using feature_frame::shares_of;
using feature_frame::Standing;

/// Bounds the error of each coordinate of a feature's point: the corners', that of one or two
/// shares, and the roundings, of at most 9 u L (see distance_certificate.hpp).
double
point_error(const Shares<DoubleDouble>& shares, const CertificateErrors& errors, double reach) {
    return errors.scale *
           (errors.corner + 2 * shares.error * shares.length + 10 * errors.roundoff * reach);
}

} // namespace

struct DoubleDoubleNearest::Pair {
    distance_certificate::SixCorners<DoubleDouble> corners{}; ///< Relative to the origin.
    distance_certificate::SixCorners<double> leading{};       ///< High parts of `corners`.
    CertificateErrors errors;
    double reach = 0; ///< Bounds all coordinates of `corners`, computed or true.
    bool is_usable = false;

    Pair(const DoubleDoubleNearest& maps, const Corners& a, const Corners& b, const Vec3& origin) {
        double magnitude = 0;
        const auto place = [&](const LocalMap& map, const Corners& given, std::size_t first) {
            const Vec3 offset = map.translation - origin;
            for (std::size_t i = 0; i < 3; ++i) {
                corners[first + i] = map.place(given[i], origin);
                magnitude = std::max(magnitude, map.magnitude_of(given[i], offset));
            }
        };
        place(maps.a_, a, 0);
        place(maps.b_, b, 3);
        is_usable = magnitude >= local_length_least && magnitude <= local_length_most;
        errors = {local_error(magnitude), double_double_error, maps.scale_};
        reach = errors.corner;
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                leading[i][k] = corners[i][k].high;
                reach = std::max(reach, errors.corner + std::abs(leading[i][k]));
            }
        }
    }

    /// A difference of corners errs by 2 h and 2 u L in each component.
    [[nodiscard]] FrameErrors in_double_double() const {
        return {4 * errors.corner + 4 * errors.roundoff * reach, errors.roundoff};
    }
    /// High parts err by another u L each.
    [[nodiscard]] FrameErrors in_double() const { return {4 * errors.corner + 8 * u * reach, u}; }
};

DoubleDoubleNearest::DoubleDoubleNearest(const PosePair& poses, double error_scale)
    : a_(poses.a), b_(poses.b), scale_(error_scale) {}

namespace {

/// The corners of one triangle between which a feature's point lies.
struct Support {
    std::array<std::size_t, 3> corners{};
    std::size_t count = 1;
};

Support edge_support(std::size_t k) {
    return {{k, (k + 1) % 3}, 2};
}

Support support_in_a(std::size_t number) {
    if (number >= feature::edge_edge) {
        return edge_support((number - feature::edge_edge) / 3);
    }
    if (number >= feature::face_corner) {
        return {{0, 1, 2}, 3};
    }
    if (number >= feature::corner_face) {
        return {{number % 3}, 1};
    }
    const std::size_t i = number / 3 % 3;
    return number >= feature::edge_corner ? edge_support(i) : Support{{i}, 1};
}

Support support_in_b(std::size_t number) {
    const bool is_edge = number >= feature::edge_edge ||
                         (number >= feature::corner_edge && number < feature::edge_corner);
    if (is_edge) {
        return edge_support(number % 3);
    }
    const bool is_face = number >= feature::corner_face && number < feature::face_corner;
    return is_face ? Support{{0, 1, 2}, 3} : Support{{number % 3}, 1};
}

/// A point of a posed triangle, relative to an origin.
struct LocalPoint {
    const LocalMap& map;
    const Corners& corners;
    Support support;
    const DoubleDoubleVec& place;
    double error; ///< Bounds the error of each component of `place`.
    const Vec3& origin;

    /// Returns component k, rounded once; nothing if that is unproven.
    [[nodiscard]] std::optional<double> rounded_component(std::size_t k, double scale) const {
        if (const auto common = common_component(k)) {
            return common;
        }
        LocalBounds bounds;
        bounds.scale = scale;
        const auto found = rounded(place[k], error, bounds);
        return found || support.count > 1
                   ? found
                   : map.nearest_component(corners[support.corners[0]], origin, k);
    }

  private:
    /// All points of an edge or face perpendicular to an axis have one coordinate on that axis.
    [[nodiscard]] std::optional<double> common_component(std::size_t k) const {
        const auto first = map.exact_component(corners[support.corners[0]], k);
        for (std::size_t i = 1; first && i < support.count; ++i) {
            const auto other = map.exact_component(corners[support.corners[i]], k);
            if (!other || other->high != first->high || other->low != first->low) {
                return std::nullopt;
            }
        }
        return first ? nearest_sum<3>(
                           {first->high, -origin[static_cast<Eigen::Index>(k)], first->low})
                     : std::nullopt;
    }
};

/// Rounds a point. Where a component is unproven, uses that of `otherwise()`, if that is not empty.
std::optional<Vec3> rounded_point(const LocalPoint& point,
                                  double scale,
                                  const std::function<std::optional<Vec3>()>& otherwise) {
    Vec3 result;
    std::optional<Vec3> other;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        std::optional<double> value = point.rounded_component(k, scale);
        if (!value) {
            other = other ? other : otherwise();
            if (!other) {
                return std::nullopt;
            }
            value = (*other)[axis];
        }
        result[axis] = *value;
    }
    return result;
}

/// Returns the first feature whose distance rounds to `distance`, that of the pair; nothing if that
/// is unproven.
///
/// Earlier features are invalid or farther away by more than a double's step. If the feature found
/// is valid, its distance rounds to no less than the pair's, and the upper bound to no more.
std::optional<std::size_t>
first_feature(const distance_certificate::SixCorners<double>& in_double,
              const FrameErrors& in_double_errors,
              const distance_certificate::SixCorners<DoubleDouble>& corners,
              const CertificateErrors& errors,
              double distance) {
    std::size_t number = 0;
    while (number < feature::count &&
           least_distance(frame_of(in_double, number), in_double_errors) > distance * (1 + 4 * u)) {
        ++number;
    }
    if (number == feature::count) {
        return std::nullopt;
    }
    const DistanceBounds<DoubleDouble> bounds = certified_bounds(corners, number, errors);
    return bounds.are_proven && most_rounded(bounds) <= distance ? std::optional(number)
                                                                 : std::nullopt;
}

} // namespace

std::optional<NearestPoints>
DoubleDoubleNearest::nearest(const Corners& a,
                             const Corners& b,
                             const Vec3& origin,
                             std::size_t likely,
                             const std::function<Vec3()>& offset) const {
    const Pair pair(*this, a, b, origin);
    if (!pair.is_usable) {
        return std::nullopt;
    }
    const auto distance = rounded(certified_bounds(pair.corners, likely, pair.errors));
    const auto number =
        distance
            ? first_feature(pair.leading, pair.in_double(), pair.corners, pair.errors, *distance)
            : std::nullopt;
    if (!number) {
        return std::nullopt;
    }
    const Shares<DoubleDouble> shares =
        shares_of(frame_of(pair.corners, *number), pair.in_double_double());
    if (shares.standing != Standing::Valid) {
        return std::nullopt;
    }
    const auto proposal =
        distance_certificate::proposal_of(pair.corners, *number, pair.errors.roundoff);
    const double error = point_error(shares, pair.errors, pair.reach);
    const LocalPoint x{a_, a, support_in_a(*number), proposal.x, error, origin};
    const LocalPoint y{b_, b, support_in_b(*number), proposal.y, error, origin};
    const bool is_first_corner = x.support.count == 1 && x.support.corners[0] == 0;
    const auto of_a = rounded_point(
        x, scale_, [&] { return is_first_corner ? std::optional(offset()) : std::nullopt; });
    const auto of_b = of_a ? rounded_point(y, scale_, [] { return std::nullopt; }) : std::nullopt;
    if (!of_b) {
        return std::nullopt;
    }
    return NearestPoints{origin, *of_a, *of_b, static_cast<std::uint8_t>(*number)};
}

} // namespace cd
