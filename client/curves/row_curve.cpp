#include "client/curves/row_curve.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

/// The curves of A and of B from a row to the next.
using RowCurves = std::array<CurvePhase, 2>;

Result<RowCurves> curves_of(const KeyRow& row, double seconds) {
    const auto of_a = CD_TRY(curve_of(row.poses.a, row.rates[0], seconds));
    const auto of_b = CD_TRY(curve_of(row.poses.b, row.rates[1], seconds));
    return RowCurves{of_a, of_b};
}

/// Bounds the angle between two rotations by unit quaternions, in radians.
double angle_between(const Quaternion& p, const Quaternion& q) {
    const double sign = p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z < 0 ? -1 : 1;
    const double apart = std::hypot(std::hypot(p.w - sign * q.w, p.x - sign * q.x),
                                    std::hypot(p.y - sign * q.y, p.z - sign * q.z));
    return 4 * std::asin(std::min(1.0, apart / 2));
}

/// Returns at how many equal times of a row keys are needed.
Result<double>
parts_of(const RowCurves& curves, const BodyRadii& radii, std::size_t moving, double off_max) {
    const double share = (1 - grid_share - gap_share) / static_cast<double>(moving);
    const double of_b = CD_TRY(key_parts(curves[1], radii.b, off_max, share));
    if (moving == 1) {
        return of_b;
    }
    const double of_a = CD_TRY(key_parts(curves[0], radii.a, off_max, share));
    return std::max(of_a, of_b);
}

/// Refuses curves that end too far from the poses of the next row. A that rests has no gap.
Status
check_gaps(const RowCurves& curves, const KeyRow& next, const BodyRadii& radii, double off_max) {
    const double of_a = CD_TRY(gap_of(curves[0], next.poses.a, radii.a));
    const double of_b = CD_TRY(gap_of(curves[1], next.poses.b, radii.b));
    return check_gap(of_a + of_b, 1, off_max);
}

PosePair at_time(const RowCurves& curves, const PosePair& begin, std::size_t moving, double time) {
    return {moving == 1 ? begin.a : curves[0].at(time), curves[1].at(time)};
}

} // namespace

Result<CurvePhase> curve_of(const Pose& from, const PoseRates& rates, double seconds) {
    const Pose key = CD_TRY(unit_key(from));
    CurvePhase phase;
    phase.seconds = seconds;
    phase.turn = key.quaternion();
    phase.spin = rates.spin;
    phase.from = key.translation();
    phase.velocity = rates.velocity;
    phase.acceleration = rates.acceleration;
    return phase;
}

Result<double> gap_of(const CurvePhase& phase, const Pose& next, double radius) {
    const Pose end = phase.at(phase.seconds);
    const Pose key = CD_TRY(unit_key(next));
    const Pose unit_end = CD_TRY(unit_key(end));
    return (end.translation() - key.translation()).norm() +
           1.1 * angle_between(unit_end.quaternion(), key.quaternion()) * radius;
}

Status check_gap(double gap, double share, double off_max) {
    if (gap <= share * gap_share * off_max) {
        return Done{};
    }
    return bad_input(fmt::format(
        "the velocities of the row before miss this pose by up to {:.2g}, more than {} of {:.2g}; "
        "check units and times, or allow {:.2g} or more: [motion] chord, or else an eighth of "
        "resolution or max_step",
        gap,
        share == 1 ? "half" : "a quarter",
        off_max,
        1.1 * gap / (share * gap_share)));
}

Result<RowKeys> keys_between(std::span<const KeyRow> rows,
                             const BodyRadii& radii,
                             std::size_t moving,
                             double off_max,
                             const NameKey& name) {
    RowKeys keys;
    const auto add = [&](const PosePair& poses, double time, std::size_t row) {
        keys.poses.push_back(poses);
        keys.times.push_back(time);
        keys.rows.push_back(row);
    };
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const KeyRow& from = rows[row];
        add(from.poses, from.time, row);
        if (row + 1 == rows.size()) {
            break;
        }
        const KeyRow& next = rows[row + 1];
        const double seconds = next.time - from.time;
        if (!(seconds > 0)) {
            return bad_input(name(row + 1) + ": the time " + exact_text(next.time) +
                             " is not after " + exact_text(from.time) + " of " + name(row));
        }
        const auto curves = CD_TRY(within(name(row) + ": ", curves_of(from, seconds)));
        CD_TRY(within(name(row + 1) + ": ", check_gaps(curves, next, radii, off_max)));
        const double parts =
            CD_TRY(within(name(row) + ": ", parts_of(curves, radii, moving, off_max)));
        if (!(parts + static_cast<double>(keys.poses.size()) < curve_keys_max)) {
            return within(name(row) + ": ", Result<RowKeys>(too_many_keys(off_max)));
        }
        for (double i = 1; i < parts; ++i) {
            const double time = seconds * (i / parts);
            add(at_time(curves, from.poses, moving, time), from.time + time, row);
        }
    }
    return keys;
}

} // namespace cd
