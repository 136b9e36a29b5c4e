#include "common/pair/poses/rounded_poses.hpp"

#include "common/pair/numbers/double_double.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cd {

namespace {

constexpr double u = 0x1p-53;             // Unit roundoff.
constexpr double weight_least = 0x1p-300; // Least nonzero weight.

/// Bounds the errors of the entries of `Pose::rotation`. An off-diagonal entry of a quaternion's
/// M(q) / q.q is exactly 0 if both its products have a factor 0. The remaining diagonal entries may
/// then be (n - 0) / n or (0 - n) / n for one computed n: exactly 1 or -1.
Mat3 entry_errors(const Pose& pose) {
    if (pose.kind() == Pose::Kind::Matrix) {
        return Mat3::Zero();
    }
    const Quaternion& q = pose.quaternion();
    const std::array<double, 3> v{q.x, q.y, q.z};
    Mat3 errors = Mat3::Constant(pose.rotation_error());
    for (int i = 0; i < 3; ++i) {
        const auto [x, y, z] = std::array{v[static_cast<std::size_t>(i)],
                                          v[static_cast<std::size_t>((i + 1) % 3)],
                                          v[static_cast<std::size_t>((i + 2) % 3)]};
        // The entries (i, i + 1) and (i + 1, i) consist of xy and wz.
        if ((x == 0 || y == 0) && (q.w == 0 || z == 0)) {
            errors(i, (i + 1) % 3) = errors((i + 1) % 3, i) = 0;
        }
        if ((y == 0 && z == 0) || (q.w == 0 && x == 0)) {
            errors(i, i) = 0;
        }
    }
    return errors;
}

RoundedPoses::Row row_of(const Mat3& matrix, const Mat3& errors, int row) {
    RoundedPoses::Row made;
    int ones = 0;
    int inexact = 0;
    for (int k = 0; k < 3; ++k) {
        const double entry = matrix(row, k);
        const bool is_exact = errors(row, k) == 0;
        made.columns |= is_exact && entry == 0 ? 0u : 1u << k;
        if (is_exact && std::abs(entry) == 1) {
            ++ones;
            made.source = k;
            made.sign = entry;
        } else {
            inexact += is_exact && entry == 0 ? 0 : 1;
        }
    }
    if (ones != 1 || inexact != 0) {
        made.sign = 0;
    }
    return made;
}

bool is_between(double x, double least, double most) {
    return x == 0 || (std::abs(x) >= least && std::abs(x) <= most);
}

bool permutes_axes(const RoundedPoses::Body& body) {
    std::uint32_t columns = 0;
    for (const RoundedPoses::Row& row : body.rows) {
        if (row.sign == 0) {
            return false;
        }
        columns |= row.columns;
    }
    return columns == 7;
}

} // namespace

RoundedPoses::RoundedPoses(const PosePair& poses) {
    const std::array<const Pose*, 2> given{&poses.a, &poses.b};
    std::array<Mat3, 2> matrices;
    std::array<Mat3, 2> errors;
    for (std::size_t i = 0; i < 2; ++i) {
        matrices[i] = given[i]->rotation();
        errors[i] = entry_errors(*given[i]);
        bodies[i].translation = given[i]->translation();
        bodies[i].is_none = errors[i].isZero(0) && matrices[i] == Mat3::Identity() &&
                            bodies[i].translation == Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            const Row row = row_of(matrices[i], errors[i], k);
            bodies[i].rows[static_cast<std::size_t>(k)] = row;
            bodies[i].rounded_columns |= row.sign == 0 ? row.columns : 0;
        }
    }
    for (int k = 0; k < 3; ++k) {
        are_tame = are_tame && is_between(bodies[0].translation[k], tame_least, tame_most) &&
                   is_between(bodies[1].translation[k], tame_least, tame_most);
    }
    if (permutes_axes(bodies[0]) && permutes_axes(bodies[1])) {
        return;
    }
    are_rotated = true;
    const auto weight = [&](std::size_t body, int row, int k) {
        const double made =
            1.01 * (errors[body](row, k) + 4.01 * u * std::abs(matrices[body](row, k)));
        return made == 0 ? 0 : std::max(made, weight_least);
    };
    for (int row = 0; row < 3; ++row) {
        const auto r = static_cast<std::size_t>(row);
        for (int k = 0; k < 3; ++k) {
            const auto c = static_cast<std::size_t>(k);
            entries[r][c] = BothBodies{matrices[0](row, k), matrices[1](row, k)};
            weights[r][c] = BothBodies{weight(0, row, k), weight(1, row, k)};
            for (std::size_t body = 0; body < 2; ++body) {
                are_tame = are_tame && std::abs(matrices[body](row, k)) <= 2 &&
                           is_between(weights[r][c][body], tame_least, 2);
            }
        }
        const DoubleDouble apart =
            exact_sum(bodies[0].translation[row], -bodies[1].translation[row]);
        offset[r] = apart.high;
        offset_error[r] = apart.low == 0 ? 0 : u * std::abs(apart.high); // NaN after an overflow.
    }
}

} // namespace cd
