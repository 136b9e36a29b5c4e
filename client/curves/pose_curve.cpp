#include "client/curves/pose_curve.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

constexpr double pi = 3.14159265358979323846;

Quaternion rotation_by(const Vec3& turned) {
    const double angle = turned.norm();
    if (angle == 0) {
        return {};
    }
    const Vec3 v = turned * (std::sin(angle / 2) / angle);
    return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

/// Returns the largest acceleration of the origin.
double acceleration_of(const CurvePhase& phase) {
    if (!phase.pivot) {
        return phase.acceleration.norm();
    }
    return phase.spin.norm() * phase.spin.cross(phase.from - *phase.pivot).norm();
}

/// Bounds how far roundings move a point of the body in `CurvePhase::at`. Each of the lengths below
/// passes fewer than 64 roundings, and the angle of the turn passes some, by which its lever moves.
double rounding_of(const CurvePhase& phase, double radius) {
    const double turned = phase.spin.norm() * phase.seconds;
    const double lever = phase.pivot ? radius + (phase.from - *phase.pivot).norm() : radius;
    const double pivot = phase.pivot ? phase.pivot->norm() : 0;
    const double reach = phase.from.norm() + pivot + phase.velocity.norm() * phase.seconds +
                         phase.acceleration.norm() * phase.seconds * phase.seconds +
                         (1 + turned) * lever;
    return 0x1p-47 * reach;
}

/// Returns into how many equal parts a phase is cut for keys within `off_max` of it.
double parts_of(const CurvePhase& phase, double radius, double off_max) {
    const double turned = phase.spin.norm() * phase.seconds;
    const double bent = acceleration_of(phase) * phase.seconds * phase.seconds / 8;
    const double paced = 0.005 * turned * turned * turned * radius;
    // Each of the two errors gets half of what is allowed.
    return std::ceil(std::max(
        {1.0, turned / (pi / 2), std::sqrt(2 * bent / off_max), std::cbrt(2 * paced / off_max)}));
}

} // namespace

Pose CurvePhase::at(double time) const {
    const Quaternion turned = rotation_by(spin * time);
    Vec3 place = from + velocity * time + acceleration * (time * time / 2);
    if (pivot) {
        const Pose about = Pose::from_quaternion(turned, Vec3::Zero());
        place = *pivot + about.rotation() * (from - *pivot) + velocity * time;
    }
    return Pose::from_quaternion(turned * turn, place);
}

Result<double> key_parts(const CurvePhase& phase, double radius, double off_max, double share) {
    const double rounding = rounding_of(phase, radius);
    if (!std::isfinite(rounding)) {
        return bad_input("the curve is too long for numbers of 64 bits");
    }
    if (!(rounding <= off_max * share / 6)) {
        return bad_input("numbers of 64 bits do not tell the curve within " + exact_text(off_max) +
                         "; allow at least " + exact_text(rounding * (6 / share)));
    }
    return parts_of(phase, radius, share * off_max - rounding);
}

Error too_many_keys(double off_max) {
    return {ErrorCode::TooLarge,
            "the curve takes more than " + exact_text(curve_keys_max) + " keys to stay within " +
                exact_text(off_max) + "; allow more, or cut the curve in pieces"};
}

Result<CurveKeys> keys_along(const std::vector<CurvePhase>& phases, double radius, double off_max) {
    CurveKeys keys;
    double begin = 0;
    for (const CurvePhase& phase : phases) {
        const double parts = CD_TRY(key_parts(phase, radius, off_max, 1 - grid_share));
        if (!(parts + static_cast<double>(keys.poses.size()) < curve_keys_max)) {
            return too_many_keys(off_max);
        }
        // The first key of a later phase is the last one of the phase before.
        for (double i = keys.poses.empty() ? 0 : 1; i <= parts; ++i) {
            const double time = i == parts ? phase.seconds : phase.seconds * (i / parts);
            keys.poses.push_back(phase.at(time));
            keys.times.push_back(begin + time);
        }
        begin += phase.seconds;
    }
    return keys;
}

} // namespace cd
