#include "common/geometry/reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// Bounds of the square of the factor by which a matrix changes a vector's length.
struct SquareFactors {
    double least;
    double most;
};

/// Bounds the eigenvalues of M'M by Gershgorin's circles. An entry of M'M has three products and
/// two sums, so it errs by at most 3.1 u times the larger of the two diagonal entries.
SquareFactors square_factors(const Mat3& m) {
    const Mat3 square = m.transpose() * m;
    const double error = 16 * unit_roundoff * square.diagonal().maxCoeff();
    SquareFactors factors{std::numeric_limits<double>::infinity(), 0};
    for (int i = 0; i < 3; ++i) {
        const double others = std::abs(square(i, (i + 1) % 3)) + std::abs(square(i, (i + 2) % 3));
        factors.least = std::min(factors.least, square(i, i) - others);
        factors.most = std::max(factors.most, square(i, i) + others);
    }
    return {factors.least - error, factors.most + error};
}

double reach_of(const Pose& pose, double distance) {
    if (pose.kind() == Pose::Kind::Quaternion) {
        return distance;
    }
    const double square = square_factors(pose.matrix()).least;
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

double world_reach(const Pose& pose, double distance) {
    if (pose.kind() == Pose::Kind::Quaternion) {
        return distance;
    }
    const double square = square_factors(pose.matrix()).most;
    if (!(square > 0x1p-900) || !(square < 0x1p900)) {
        return std::numeric_limits<double>::infinity();
    }
    return distance * std::sqrt(square) * (1 + 8 * unit_roundoff);
}

} // namespace cd
