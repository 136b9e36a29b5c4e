// Keys along the curves between rows of poses that have velocities and accelerations.
#pragma once

#include "client/curves/pose_curve.hpp"
#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"
#include "common/motion/motion_keys.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace cd {

/// How a body moves from its pose on, until the next row. Axes are the world's.
struct PoseRates {
    Vec3 velocity = Vec3::Zero();     ///< Of its origin, in lengths a second.
    Vec3 acceleration = Vec3::Zero(); ///< Of its origin, in lengths a second squared.
    Vec3 spin = Vec3::Zero();         ///< Axis times radians a second.
};

/// The poses of a row, and how A and B move from there.
struct KeyRow {
    double time = 0; ///< In seconds.
    PosePair poses;
    std::array<PoseRates, 2> rates;
};

/// Keys along the curves of rows.
struct RowKeys {
    std::vector<PosePair> poses;
    std::vector<double> times;
    std::vector<std::size_t> rows; ///< For each key the row from which its curve starts.
};

/// The share of the distance from the curves by which they may miss the next row.
inline constexpr double gap_share = 0.5;

/// Returns the curve from a pose with its rates. Errors: as `unit_key`.
[[nodiscard]] Result<CurvePhase> curve_of(const Pose& from, const PoseRates& rates, double seconds);

/// Bounds how far the end of a curve takes a point of the body from where the next pose has it.
/// Errors: as `unit_key`.
[[nodiscard]] Result<double> gap_of(const CurvePhase& phase, const Pose& next, double radius);

/// Refuses a gap above `share`, which is 1 or 1/2, of what may be missed. Errors: BadInput.
[[nodiscard]] Status check_gap(double gap, double share, double off_max);

/// Makes keys at equal times between each row and the next, as many as it takes that the motion
/// from each to the next changes no distance between points of A and of B by more than `off_max`
/// against the curves, at any time, even if the keys are then rounded to a grid and that moves the
/// motions by up to `grid_share` of it. The poses of the rows are keys as they are. `radii` are the
/// bodies', and `moving` is the number of bodies that move: 1 if A rests.
///
/// A curve leads from a row's pose with the row's rates (`CurvePhase`) until the time of the next.
/// Its last key is the next row's pose instead. The motion to it goes linearly astray, so it is
/// never farther off than its end is: for the origins by their distance g; for a turn of gamma
/// between the quaternions by less than 1.1 gamma times the radius, since q(tau) moves by at most
/// 2 sin(gamma/4) and is at least cos(22.5 degrees) long. Both together are at most `gap_share` of
/// `off_max`.
///
/// Errors begin with the name of a row: BadInput for times that do not rise, for a curve that
/// misses the next row by more, and as `keys_along`; TooLarge for more than `curve_keys_max` keys.
[[nodiscard]] Result<RowKeys> keys_between(std::span<const KeyRow> rows,
                                           const BodyRadii& radii,
                                           std::size_t moving,
                                           double off_max,
                                           const NameKey& name);

} // namespace cd
