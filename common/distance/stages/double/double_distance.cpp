#include "common/distance/stages/double/double_distance.hpp"

#include "common/distance/stages/double/feature_choice.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr double u = 0x1p-53; // Unit roundoff.

distance_certificate::SixCorners<double> six(const std::array<Vec3, 6>& corners) {
    distance_certificate::SixCorners<double> to;
    for (std::size_t i = 0; i < 6; ++i) {
        to[i] = {corners[i].x(), corners[i].y(), corners[i].z()};
    }
    return to;
}

} // namespace

std::optional<bool> DoublePair::is_within(double d) const {
    if (!bounds.are_proven) {
        return std::nullopt;
    }
    if (bounds.lower - bounds.error > d) {
        return false;
    }
    return bounds.upper + bounds.error <= d ? std::optional(true) : std::nullopt;
}

DoubleDistance::Map::Map(const Pose& pose)
    : rotation(pose.rotation()),
      translation(pose.translation()),
      entry_error(pose.rotation_error()),
      largest(rotation.cwiseAbs().maxCoeff() + entry_error) {}

/// A coordinate sums t - o and three products. With M for the sum of their magnitudes, t - o and
/// the products are rounded once each, and three sums err by u M: 4 u M, raised for terms of higher
/// order. An entry's error is multiplied by its factor.
void DoubleDistance::Map::place(
    const Corners& corners, const Vec3& origin, Vec3* to, double& error, double& magnitude) const {
    const Vec3 offset = translation - origin;
    const double offset_size = offset.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < 3; ++i) {
        to[i] = offset + rotation * corners[i];
        const double size = corners[i].cwiseAbs().sum();
        const double sum = 1.01 * (offset_size + largest * size);
        magnitude = std::max(magnitude, sum);
        error = std::max(error, 5 * u * sum + 1.01 * entry_error * size);
    }
}

DoubleDistance::DoubleDistance(const PosePair& poses, double error_scale)
    : a_(poses.a), b_(poses.b), scale_(error_scale) {}

DoubleDistance::Placed DoubleDistance::placed(const Corners& a, const Corners& b) const {
    Placed all;
    all.origin = a_.rotation * a[0] + a_.translation;
    if (!all.origin.allFinite()) {
        all.origin = Vec3::Zero();
    }
    a_.place(a, all.origin, all.corners.data(), all.error, all.magnitude);
    b_.place(b, all.origin, all.corners.data() + 3, all.error, all.magnitude);
    return all;
}

DoublePair DoubleDistance::choose(const Corners& a, const Corners& b) const {
    const Placed all = placed(a, b);
    return {all.origin, likely_feature(all.corners), {}};
}

DoublePair DoubleDistance::look_at(const Corners& a, const Corners& b) const {
    const Placed all = placed(a, b);
    DoublePair pair{all.origin, likely_feature(all.corners), {}};
    if (!(all.magnitude >= local_length_least && all.magnitude <= local_length_most)) {
        return pair;
    }
    pair.bounds = certified_bounds(six(all.corners), pair.feature, {all.error, u, scale_});
    return pair;
}

Vec3 DoubleDistance::displacement(const Corners& a, const Corners& b) const {
    const Placed all = placed(a, b);
    const auto proposal =
        distance_certificate::proposal_of(six(all.corners), likely_feature(all.corners), u);
    return {proposal.y[0] - proposal.x[0],
            proposal.y[1] - proposal.x[1],
            proposal.y[2] - proposal.x[2]};
}

} // namespace cd
