#include "common/tree/reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// Returns a lower bound on the square of the factor by which a matrix M shortens a vector: the
/// least eigenvalue of M'M, by Gershgorin's circles. An entry of M'M has three products and two
/// sums, so it errs by at most 3.1 u times the larger of the two diagonal entries.
double least_square_factor(const Mat3& m) {
    const Mat3 square = m.transpose() * m;
    const double largest = square.diagonal().maxCoeff();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double others = std::abs(square(i, (i + 1) % 3)) + std::abs(square(i, (i + 2) % 3));
        least = std::min(least, square(i, i) - others);
    }
    return least - 16 * unit_roundoff * largest;
}

double reach_of(const Pose& pose, double distance) {
    if (pose.kind() == Pose::Kind::Quaternion) {
        return distance;
    }
    const double square = least_square_factor(pose.matrix());
    // Comparisons with NaN are false. Below this bound underflow would count.
    if (!(square > 0x1p-900) || !(square < 0x1p900)) {
        return std::numeric_limits<double>::infinity();
    }
    return distance / std::sqrt(square) * (1 + 8 * unit_roundoff);
}

} // namespace

double body_reach(const PosePair& poses, double distance) {
    return std::max(reach_of(poses.a, distance), reach_of(poses.b, distance));
}

} // namespace cd
