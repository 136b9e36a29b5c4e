#include "common/pair/points/double_double_points.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cd {

namespace {

constexpr std::size_t next(std::size_t corner) {
    return (corner + 1) % 3;
}

/// The ends of an interval on the line in which the planes of both triangles meet.
using Ends = std::array<LocalPlace, 2>;

/// Returns where two edges of a triangle cross the other triangle's plane, ordered by component k.
/// Returns nothing unless it is proven that no corner is in the plane, and which end is first.
std::optional<Ends> ends_of(const LocalHalf& half, std::size_t k, const LocalBounds& bounds) {
    if (is_any_unknown(half.proven)) {
        return std::nullopt;
    }
    // Finds the corner that is alone on its side.
    const int sum = half.proven[0] + half.proven[1] + half.proven[2];
    if (sum == 3 || sum == -3) {
        return std::nullopt;
    }
    std::size_t lone = 0;
    while (half.proven[lone] == sum) {
        ++lone;
    }
    Ends ends{piercing_place(half, lone, bounds), piercing_place(half, next(next(lone)), bounds)};
    const std::optional<int> order = compare(ends[0], ends[1], k);
    if (!order || *order == 0) {
        return std::nullopt;
    }
    if (*order > 0) {
        std::swap(ends[0], ends[1]);
    }
    return ends;
}

/// Intersects two intervals of a line whose ends are ordered by component k. Returns nothing if a
/// comparison is unproven, two ends coincide, or the intervals are disjoint.
std::optional<Ends> common_part(const Ends& a, const Ends& b, std::size_t k) {
    const std::optional<int> low = compare(a[0], b[0], k);
    const std::optional<int> high = compare(a[1], b[1], k);
    if (!low || !high || *low == 0 || *high == 0) {
        return std::nullopt;
    }
    const Ends common{*low > 0 ? a[0] : b[0], *high < 0 ? a[1] : b[1]};
    return compare(common[0], common[1], k) == -1 ? std::optional(common) : std::nullopt;
}

/// Moves the lexicographically least point to the front; returns false if a comparison is unproven.
bool put_least_first(std::span<LocalPlace> places) {
    for (std::size_t i = 1; i < places.size(); ++i) {
        const std::optional<int> order = compare(places[i], places[0]);
        if (!order) {
            return false;
        }
        if (*order < 0) {
            std::swap(places[i], places[0]);
        }
    }
    return true;
}

/// Sorts a convex polygon's corners from the second on around the first, from which the others are
/// seen within less than a half turn. Returns false if the order is unproven.
bool sort_around_first(std::span<LocalPlace> places,
                       const LocalHalf& a,
                       const LocalBounds& bounds) {
    for (std::size_t end = 2; end < places.size(); ++end) {
        for (std::size_t i = end; i > 1; --i) {
            const auto found = turn(places[0], places[i - 1], places[i], a, bounds);
            if (!found) {
                return false;
            }
            if (*found > 0) {
                break;
            }
            std::swap(places[i - 1], places[i]);
        }
    }
    return true;
}

/// Rounds each component of a point. Uses `otherwise(k)` for components whose rounding is unproven;
/// returns nothing if `otherwise(k)` is empty.
template <class Otherwise>
std::optional<Vec3> rounded(const LocalPlace& place,
                            const Vec3& origin,
                            const LocalBounds& bounds,
                            const Otherwise& otherwise) {
    Vec3 point;
    for (std::size_t k = 0; k < 3; ++k) {
        std::optional<double> value = rounded(place, k, origin, bounds);
        if (!value) {
            value = otherwise(k);
        }
        if (!value) {
            return std::nullopt;
        }
        point[static_cast<Eigen::Index>(k)] = *value;
    }
    return point;
}

} // namespace

DoubleDoublePoints::DoubleDoublePoints(const PosePair& poses, double bound_scale)
    : a_(poses.a), b_(poses.b), scale_(bound_scale) {}

std::optional<Vec3> DoubleDoublePoints::origin(const Corners& a) const {
    const double magnitude = a_.magnitude_of(a[0], a_.translation);
    if (!(magnitude >= local_length_least && magnitude <= local_length_most)) {
        return std::nullopt;
    }
    const DoubleDoubleVec nearby = a_.place(a[0], Vec3::Zero());
    LocalBounds bounds;
    bounds.scale = scale_;
    Vec3 origin;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto exact = a_.exact_component(a[0], k);
        const auto value = exact ? std::optional(exact->high)
                                 : rounded(nearby[k], scale_ * local_error(magnitude), bounds);
        if (!value) {
            return std::nullopt;
        }
        origin[static_cast<Eigen::Index>(k)] = *value;
    }
    return origin;
}

bool DoubleDoublePoints::take(const Corners& a, const Corners& b, const Vec3& origin) {
    if (!local_a_ || a != last_a_ || origin != origin_) {
        local_a_.emplace(a_, a, origin);
        last_a_ = a;
        origin_ = origin;
    }
    local_b_.emplace(b_, b, origin);
    last_b_ = b;
    bounds_ = LocalBounds(*local_a_, *local_b_, scale_);
    half_a_ = LocalHalf(*local_a_, *local_b_, bounds_);
    half_b_ = LocalHalf(*local_b_, *local_a_, bounds_);
    const double magnitude = std::max(local_a_->magnitude, local_b_->magnitude);
    return magnitude >= local_length_least && magnitude <= local_length_most &&
           half_a_.side_error >= side_error_least * scale_ &&
           half_b_.side_error >= side_error_least * scale_;
}

std::optional<std::span<const Vec3>> DoubleDoublePoints::ends() {
    // All four ends are on the line of both planes, so the order of two different components is the
    // order of the ends along the line.
    const DoubleDoubleVec& m = local_a_->normal;
    const DoubleDoubleVec& n = local_b_->normal;
    const std::size_t axis = main_axis({m[1].high * n[2].high - m[2].high * n[1].high,
                                        m[2].high * n[0].high - m[0].high * n[2].high,
                                        m[0].high * n[1].high - m[1].high * n[0].high});
    const auto on_a = ends_of(half_a_, axis, bounds_);
    const auto on_b = on_a ? ends_of(half_b_, axis, bounds_) : std::nullopt;
    auto common = on_b ? common_part(*on_a, *on_b, axis) : std::nullopt;
    if (!common || !put_least_first(*common)) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const auto point = rounded(
            (*common)[i], origin_, bounds_, [](std::size_t) { return std::optional<double>(); });
        if (!point) {
            return std::nullopt;
        }
        points_[i] = *point;
    }
    return std::span<const Vec3>(points_).first(2);
}

std::optional<double> DoubleDoublePoints::nearest_of_corner(
    const DoubleDoubleVec* corner, std::size_t k, const std::function<Vec3()>& offset) const {
    for (std::size_t i = 0; i < 3; ++i) {
        if (corner == &local_a_->corners[i]) {
            const auto nearest = a_.nearest_component(last_a_[i], origin_, k);
            // The first corner minus the origin is a rounding error, which is below every error
            // bound.
            return nearest || i != 0 ? nearest : std::optional(offset()[static_cast<int>(k)]);
        }
        if (corner == &local_b_->corners[i]) {
            return b_.nearest_component(last_b_[i], origin_, k);
        }
    }
    return std::nullopt;
}

std::optional<std::span<const Vec3>> DoubleDoublePoints::at(const SharedCorners& corners,
                                                            const std::function<Vec3()>& offset) {
    std::array<LocalPlace, 6> all;
    const std::span<LocalPlace> places(all.data(), corners.count);
    for (std::size_t i = 0; i < corners.count; ++i) {
        const SharedCorner& c = corners.corner[i];
        const LocalHalf& half = c.first < 3 ? half_a_ : half_b_;
        switch (c.kind) {
        case SharedCorner::Kind::Corner:
            places[i] = corner_place(*half.own, c.first % 3, bounds_);
            break;
        case SharedCorner::Kind::Piercing:
            places[i] = piercing_place(half, c.first % 3, bounds_);
            break;
        case SharedCorner::Kind::Crossing:
            places[i] = crossing_place(half_a_, c.first, half_b_, c.second % 3, bounds_);
            break;
        }
    }
    if (!put_least_first(places) || !sort_around_first(places, half_a_, bounds_)) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto point = rounded(places[i], origin_, bounds_, [&](std::size_t k) {
            return places[i].to != nullptr ? std::nullopt
                                           : nearest_of_corner(places[i].from, k, offset);
        });
        if (!point) {
            return std::nullopt;
        }
        points_[i] = *point;
    }
    return std::span<const Vec3>(points_).first(places.size());
}

} // namespace cd
