#include "common/pair/stages/double/double_signs.hpp"

#include <cmath>

namespace cd {

namespace {

using double_signs::CornerPairs;
using two_doubles::exact_sums;
using two_doubles::magnitudes;
using two_doubles::Sums;

TwoDoubles twice(double x) {
    return TwoDoubles{x, x};
}

TwoDoubles as_error(double error) {
    return TwoDoubles{0, double_signs::size_of_error * error};
}

bool are_all_tame(const Corners& a, const Corners& b) {
    TwoMasks all{-1, -1};
    for (std::size_t i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const TwoDoubles x = magnitudes(TwoDoubles{a[i][k], b[i][k]});
            all &= (x <= twice(tame_most)) & ((x >= twice(tame_least)) | (x == twice(0)));
        }
    }
    return (all[0] & all[1]) != 0;
}

/// Returns a corner's world coordinate along an axis onto which the pose maps one of the body's
/// axes, in either direction: exactly high + low, in both lanes.
Sums placed(const RoundedPoses::Body& body, const Vec3& corner, std::size_t axis) {
    const RoundedPoses::Row& row = body.rows[axis];
    return exact_sums(twice(row.sign * corner[row.source]),
                      twice(body.translation[static_cast<int>(axis)]));
}

} // namespace

ExactCorners::ExactCorners(const RoundedPoses& poses, const Corners& a, const Corners& b)
    : are_tame_(poses.are_tame && are_all_tame(a, b)) {
    const std::array<const Corners*, 2> corners{&a, &b};
    for (std::size_t i = 0; i < 6; ++i) {
        const RoundedPoses::Body& body = poses.bodies[i / 3];
        const Vec3& corner = (*corners[i / 3])[i % 3];
        TwoDoubles low_parts = twice(0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (body.is_none) {
                at_[i][axis] = twice(corner[static_cast<int>(axis)]);
            } else {
                const Sums sums = placed(body, corner, axis);
                at_[i][axis] = sums.high;
                low_parts += magnitudes(sums.low);
            }
        }
        are_exact_ &= low_parts[0] == 0; // NaN, after an overflow, is not exact.
    }
}

CornerPairs ExactCorners::ones() const {
    CornerPairs ones = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const TwoMasks are_one = (at_[i][0] == at_[3 + j][0]) & (at_[i][1] == at_[3 + j][1]) &
                                     (at_[i][2] == at_[3 + j][2]);
            ones |= static_cast<CornerPairs>(are_one[0] & 1) << (3 * i + j);
        }
    }
    return ones;
}

PosedCorners::PosedCorners(const RoundedPoses& poses, const Corners& a, const Corners& b)
    : are_tame_(poses.are_tame && are_all_tame(a, b)) {
    const std::array<const Corners*, 2> corners{&a, &b};
    if (poses.are_rotated) {
        rotate(poses, a, b);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (poses.bodies[0].rows[axis].sign != 0 && poses.bodies[1].rows[axis].sign != 0) {
            place_exact(poses, axis, corners);
        }
    }
    find_ones(poses, corners);
}

/// Stores the corners' coordinates along an axis that both poses keep. A difference between the
/// triangles errs by both corners' E and the difference of the first corners' low parts.
void PosedCorners::place_exact(const RoundedPoses& poses,
                               std::size_t axis,
                               const std::array<const Corners*, 2>& corners) {
    std::array<double, 2> first_low{};
    for (std::size_t i = 0; i < 6; ++i) {
        const std::size_t body = i / 3;
        const Sums sums = placed(poses.bodies[body], (*corners[body])[i % 3], axis);
        first_low[body] = i % 3 == 0 ? sums.low[0] : first_low[body];
        const double error = std::abs(sums.low[0] - first_low[body]);
        within_[i][axis] = across_[i][axis] = {sums.high, as_error(error)};
    }
    const TwoDoubles apart = as_error(std::abs(first_low[1] - first_low[0]));
    for (std::size_t i = 3; i < 6; ++i) {
        across_[i][axis].error += apart;
    }
}

/// Stores the corners' rotated coordinates. Raises the sizes of nonzero factors so that their
/// products with weights do not underflow. So an error is 0 only where all true products are 0.
void PosedCorners::rotate(const RoundedPoses& poses, const Corners& a, const Corners& b) {
    using Three = std::array<BothBodies, 3>;
    std::array<Three, 3> x;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int axis = static_cast<int>(k);
            x[i][k] = BothBodies{a[i][axis], b[i][axis]};
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        x[1][k] -= x[0][k];
        x[2][k] -= x[0][k];
    }
    std::array<Three, 3> posed;
    std::array<Three, 3> error;
    for (std::size_t i = 0; i < 3; ++i) {
        Three size;
        for (std::size_t k = 0; k < 3; ++k) {
            size[k] =
                magnitudes(x[i][k]) + two_doubles::where(x[i][k] != twice(0), twice(0x1p-700));
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const Three& m = poses.entries[k];
            const Three& w = poses.weights[k];
            posed[i][k] = m[0] * x[i][0] + m[1] * x[i][1] + m[2] * x[i][2];
            error[i][k] = w[0] * size[0] + w[1] * size[1] + w[2] * size[2];
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double first = posed[0][k][1] - posed[0][k][0];
        const double apart = first - poses.offset[k];
        // Adds the offset's error and one rounding for each of the two differences.
        const double apart_error = error[0][k][0] + error[0][k][1] + poses.offset_error[k] +
                                   1.01 * double_signs::u * (std::abs(first) + std::abs(apart));
        posed[0][k] = error[0][k] = twice(0);
        for (std::size_t i = 0; i < 3; ++i) {
            within_[i][k] = across_[i][k] = {twice(posed[i][k][0]), as_error(error[i][k][0])};
            within_[3 + i][k] = {twice(posed[i][k][1]), as_error(error[i][k][1])};
            const double from_a = posed[i][k][1] + apart;
            across_[3 + i][k] = {
                twice(from_a),
                as_error(error[i][k][1] + apart_error + 1.01 * double_signs::u * std::abs(from_a))};
        }
    }
}

/// Finds the corners of A and B that provably coincide. A component is known if its row of the pose
/// is exact, or if all coordinates that enter it are 0, as on the axis of a rotation. Its high and
/// low part are unique, so equal components have equal parts.
void PosedCorners::find_ones(const RoundedPoses& poses,
                             const std::array<const Corners*, 2>& corners) {
    std::array<bool, 6> are_known{};
    for (std::size_t body = 0; body < 2; ++body) {
        const std::uint32_t columns = poses.bodies[body].rounded_columns;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& x = (*corners[body])[i];
            are_known[3 * body + i] = ((columns & 1) == 0 || x[0] == 0) &
                                      ((columns & 2) == 0 || x[1] == 0) &
                                      ((columns & 4) == 0 || x[2] == 0);
        }
    }
    const auto are_one = [&](std::size_t i, std::size_t j) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Sums l = placed(poses.bodies[0], (*corners[0])[i], axis);
            const Sums r = placed(poses.bodies[1], (*corners[1])[j], axis);
            if (l.high[0] != r.high[0] || l.low[0] != r.low[0]) {
                return false;
            }
        }
        return true;
    };
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 3 && are_known[3 + j]; ++i) {
            if (are_known[i] && are_one(i, j)) {
                ones_ |= CornerPairs{1} << (3 * i + j);
            }
        }
    }
}

} // namespace cd
