#include "common/geometry/pose.hpp"

#include "common/core/check.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double u = 0x1p-53; // Unit roundoff of double.
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Computes M(q) / q.q in doubles. Each entry errs by at most 10 u, so the bound of 16 u in
/// `quaternion_entry_error` has room. An exact power of two scales q so that its largest component
/// is in [0.5, 1]. An entry of M sums at most four products, each at most n = q.q, so its error is
/// at most 5 u n. The relative error of n is at most 4 u; the division adds u, and entries are at
/// most 1. Underflow in the scaling is below 2^-1000.
Mat3 rotation_of(const Quaternion& given) {
    const double largest =
        std::max({std::abs(given.w), std::abs(given.x), std::abs(given.y), std::abs(given.z)});
    // The scaling is exact, so it may be left out where it would do nothing useful.
    int exponent = 0;
    if (!(largest >= 0.5 && largest <= 1)) {
        std::frexp(largest, &exponent);
    }
    const auto scaled = [exponent](double value) {
        return exponent == 0 ? value : std::ldexp(value, -exponent);
    };
    const double w = scaled(given.w);
    const double x = scaled(given.x);
    const double y = scaled(given.y);
    const double z = scaled(given.z);
    const double n = w * w + x * x + y * y + z * z;
    Mat3 m;
    m << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y), //
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),  //
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
    return m / n;
}

constexpr double quaternion_entry_error = 16 * u;

/// A matrix in doubles, with bounds on its errors and entries.
struct BoundedMatrix {
    Mat3 value;
    double error = 0;   ///< Upper bound on the error of each entry.
    double largest = 0; ///< Bounds every entry, computed or true.
};

BoundedMatrix linear_part(const Pose& pose) {
    const Mat3 value = pose.rotation();
    return {value, pose.rotation_error(), value.cwiseAbs().maxCoeff() + pose.rotation_error()};
}

/// Bounds every |entry| of L R - I, where entries of L and R are at most l and r. Three products
/// and three sums round an entry by less than 5 u (3 l r + 1).
double residual(const Mat3& left, double l, const Mat3& right, double r) {
    const Mat3 computed = left * right - Mat3::Identity();
    return computed.cwiseAbs().maxCoeff() + 5 * u * (3 * l * r + 1);
}

/// Bounds each |entry| of R'R - I for the linear part R of a pose.
double skew_of(const Pose& pose) {
    if (pose.kind() == Pose::Kind::Quaternion) {
        return 0;
    }
    const BoundedMatrix part = linear_part(pose);
    return residual(part.value.transpose(), part.largest, part.value, part.largest);
}

/// Bounds |(I + F)^-1 - I| in the spectral norm for a matrix F whose entries are at most `entry`.
/// As |F| <= 3 entry = s, the Neumann series gives s / (1 - s). Returns infinity for s >= 1/2.
double inverse_spread(double entry) {
    const double s = 3 * entry;
    return s < 0.5 ? s / (1 - s) : infinity;
}

/// Inverts the linear part R of a pose by cofactors and bounds the error. If the result X satisfies
/// X R = I + F, then R^-1 = (I + F)^-1 X, which is within inverse_spread(F) |X| of X, and |X| is at
/// most 3 times the largest entry. The inverse of a quaternion's rotation is its transpose.
BoundedMatrix inverse_of(const Pose& pose) {
    const BoundedMatrix part = linear_part(pose);
    if (pose.kind() == Pose::Kind::Quaternion) {
        return {part.value.transpose(), part.error, part.largest};
    }
    const Vec3 x = part.value.col(0);
    const Vec3 y = part.value.col(1);
    const Vec3 z = part.value.col(2);
    const double determinant = x.dot(y.cross(z));
    Mat3 cofactors;
    cofactors << y.cross(z).transpose(), z.cross(x).transpose(), x.cross(y).transpose();
    BoundedMatrix inverse{cofactors / determinant, infinity, infinity};
    if (!inverse.value.allFinite()) {
        return inverse;
    }
    const double largest = inverse.value.cwiseAbs().maxCoeff();
    inverse.error =
        inverse_spread(residual(inverse.value, largest, part.value, part.largest)) * 3 * largest;
    inverse.largest = largest + inverse.error;
    return inverse;
}

/// Returns the given bound, or infinity if an overflow has made the bound NaN.
double bound(double value) {
    return value >= 0 ? value : infinity;
}

} // namespace

Quaternion operator*(const Quaternion& l, const Quaternion& r) {
    return {l.w * r.w - l.x * r.x - l.y * r.y - l.z * r.z,
            l.w * r.x + l.x * r.w + l.y * r.z - l.z * r.y,
            l.w * r.y - l.x * r.z + l.y * r.w + l.z * r.x,
            l.w * r.z + l.x * r.y - l.y * r.x + l.z * r.w};
}

Pose Pose::from_matrix(const Mat3& rotation, const Vec3& translation) {
    Pose pose;
    pose.matrix_ = rotation;
    pose.translation_ = translation;
    return pose;
}

Pose Pose::from_quaternion(const Quaternion& quaternion, const Vec3& translation) {
    CD_CHECK(!(quaternion == Quaternion{0, 0, 0, 0}));
    Pose pose;
    pose.kind_ = Kind::Quaternion;
    pose.quaternion_ = quaternion;
    pose.translation_ = translation;
    return pose;
}

const Mat3& Pose::matrix() const {
    CD_CHECK(kind_ == Kind::Matrix);
    return matrix_;
}

const Quaternion& Pose::quaternion() const {
    CD_CHECK(kind_ == Kind::Quaternion);
    return quaternion_;
}

Mat3 Pose::rotation() const {
    return kind_ == Kind::Matrix ? matrix_ : rotation_of(quaternion_);
}

double Pose::rotation_error() const {
    return kind_ == Kind::Matrix ? 0 : quaternion_entry_error;
}

Vec3 Pose::apply(const Vec3& point) const {
    return rotation() * point + translation_;
}

bool Pose::is_finite() const {
    const bool rotates = kind_ == Kind::Matrix
                             ? matrix_.allFinite()
                             : std::isfinite(quaternion_.w) && std::isfinite(quaternion_.x) &&
                                   std::isfinite(quaternion_.y) && std::isfinite(quaternion_.z);
    return rotates && translation_.allFinite();
}

bool operator==(const Pose& left, const Pose& right) {
    if (left.kind_ != right.kind_ || left.translation_ != right.translation_) {
        return false;
    }
    return left.kind_ == Pose::Kind::Matrix ? left.matrix_ == right.matrix_
                                            : left.quaternion_ == right.quaternion_;
}

namespace {

/// Returns the map of B's pose alone.
RelativePose relative_to_world(const Pose& b) {
    RelativePose relative;
    relative.rotation = b.rotation();
    relative.rotation_error = relative.rotation.allFinite() ? b.rotation_error() : infinity;
    relative.translation = b.translation();
    relative.translation_error = relative.translation.allFinite() ? 0 : infinity;
    relative.skew = bound(skew_of(b));
    return relative;
}

} // namespace

RelativePose relative_pose(const PosePair& poses) {
    static const Pose world;
    if (poses.a == world) {
        return relative_to_world(poses.b);
    }
    const BoundedMatrix a = inverse_of(poses.a);
    const BoundedMatrix b = linear_part(poses.b);
    const Vec3 offset = poses.b.translation() - poses.a.translation();
    const double reach = offset.cwiseAbs().maxCoeff();
    // `slack` covers the roundings of the bounds' own computation. `underflow` covers what products
    // of entries below 2^20 can lose; larger entries are far from rigid.
    constexpr double slack = 1.01;
    constexpr double underflow = 0x1p-1000;

    RelativePose relative;
    relative.rotation = a.value * b.value;
    // An entry sums three products of factors with errors; each product is rounded three times.
    relative.rotation_error = bound(
        slack * 3 * (a.error * b.largest + a.largest * b.error + 4 * u * a.largest * b.largest) +
        underflow);
    relative.translation = a.value * offset;
    // `offset` has a relative error of u, and each product is rounded three times.
    relative.translation_error =
        bound(slack * 3 * reach * (a.error + 5 * u * a.largest) + underflow);
    // R = A^-1 B, so R'R - I = (B'B - I) + B' ((AA')^-1 - I) B, where AA' - I has the singular
    // values of A'A - I, and |B|^2 <= 1 + |B'B - I|.
    const double skew_b = skew_of(poses.b);
    relative.skew = bound(slack * (skew_b + (1 + 3 * skew_b) * inverse_spread(skew_of(poses.a))));
    return relative;
}

} // namespace cd
