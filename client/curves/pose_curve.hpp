// Curves along which body B moves, and keys that follow them.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"

#include <optional>
#include <string>
#include <vector>

namespace cd {

/// B's pose over some time: it turns at a constant rate, and its origin moves with a constant
/// acceleration or about a pivot. Lengths are in the job's unit, axes are the world's.
struct CurvePhase {
    double seconds = 1;
    Quaternion turn{};                        ///< At the begin.
    Vec3 spin = Vec3::Zero();                 ///< Axis times radians a second.
    Vec3 from = Vec3::Zero();                 ///< The origin at the begin.
    Vec3 velocity = Vec3::Zero();             ///< At the begin.
    Vec3 acceleration = Vec3::Zero();         ///< Not with a pivot.
    std::optional<Vec3> pivot = std::nullopt; ///< The origin turns about it as the body does.

    /// Returns the pose `time` seconds after the begin. It depends on the host's sine and cosine in
    /// its last digits.
    [[nodiscard]] Pose at(double time) const;
};

/// A curve as a job file has it.
struct CurveSpec {
    std::string text;               ///< The line of the job file, such as "line = { ... }".
    std::string unit = {};          ///< Unit of its lengths; empty: the job's.
    std::vector<CurvePhase> phases; ///< One after another.
};

/// Keys along a curve.
struct CurveKeys {
    std::vector<Pose> poses;   ///< Of B, of kind Quaternion; at least two.
    std::vector<double> times; ///< From 0 on, rising.
};

/// The most keys of a curve.
inline constexpr double curve_keys_max = 1e6;

/// The share of the distance from a curve that is left for the rounding of keys to a grid.
inline constexpr double grid_share = 0.25;

/// Returns into how many equal times a phase is cut, a whole number, so that motions between keys
/// at these times keep every point of B within `share` of `off_max` of it, as `keys_along` says.
/// `radius` is B's. Errors: BadInput if roundings take more than a sixth of that.
[[nodiscard]] Result<double>
key_parts(const CurvePhase& phase, double radius, double off_max, double share);

/// Returns the error TooLarge that says that a curve needs more than `curve_keys_max` keys.
[[nodiscard]] Error too_many_keys(double off_max);

/// Makes keys at equal times of each phase, as many as it takes that the motion from each to the
/// next (common/motion/body_path.hpp) keeps every point of B within `off_max` of the curve, at all
/// times, even if the keys are then rounded to a grid (motion_keys.hpp) and that moves the motion
/// by up to `grid_share` of it. `radius` is B's (`body_radius`). `off_max` is above 0.
///
/// Between keys h seconds apart the motion errs by at most |c''| h^2 / 8 in the position, with c''
/// the largest acceleration of the origin, since a chord is linear in time. It turns about the
/// same axis at another pace: for a turn of delta <= pi/2, the angle 2 atan2(tau s, 1 - tau + tau
/// c) with s, c the sine and cosine of delta/2 differs from tau delta by at most 0.005 delta^3. So
/// no point is farther off than the sum of |c''| h^2 / 8 and 0.005 delta^3 times the radius.
/// Roundings in `CurvePhase::at` add less than 2^-47 times all lengths from which the place of a
/// point is computed. Errors: BadInput if that is more than an eighth of `off_max`; TooLarge for
/// more than `curve_keys_max` keys.
[[nodiscard]] Result<CurveKeys>
keys_along(const std::vector<CurvePhase>& phases, double radius, double off_max);

} // namespace cd
