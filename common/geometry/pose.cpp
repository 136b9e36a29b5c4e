#include "common/geometry/pose.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double u = 0x1p-53; // Unit roundoff.

/// M(q) / q.q in doubles. Each entry is within 16 u: with q scaled by an exact power of two so that
/// its largest component is in [0.5, 1), an entry of M is a sum of at most four products, each at
/// most n = q.q, so it is within 5 u n; n is within 4 u of itself; the division adds u, and entries
/// are at most 1. What underflows in the scaling is below 2^-1000.
Mat3 rotation_of(const Quaternion& given) {
    const double largest =
        std::max({std::abs(given.w), std::abs(given.x), std::abs(given.y), std::abs(given.z)});
    int exponent = 0;
    std::frexp(largest, &exponent);
    const double w = std::ldexp(given.w, -exponent);
    const double x = std::ldexp(given.x, -exponent);
    const double y = std::ldexp(given.y, -exponent);
    const double z = std::ldexp(given.z, -exponent);
    const double n = w * w + x * x + y * y + z * z;
    Mat3 m;
    m << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y), //
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),  //
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
    return m / n;
}

/// A pose's linear part with what is known of it.
struct LinearPart {
    Mat3 rounded;
    double error = 0;         ///< Of each entry of `rounded`.
    double largest = 0;       ///< Bounds every entry of both.
    double skew = 0;          ///< Bounds each |entry| of R'R - I, exactly computed.
    double inverse_error = 0; ///< Of each entry of `rounded` transposed as the inverse.
};

/// With E = R'R - I and |E| <= 3 skew in the 2-norm, R^-1 = (I + E)^-1 R', so that
/// |R^-1 - R'| <= 3 skew / (1 - 3 skew) sqrt(1 + 3 skew). Nothing is known beyond 3 skew = 1/2.
LinearPart linear_part(const Pose& pose) {
    LinearPart part;
    part.rounded = pose.rotation();
    if (pose.kind() == Pose::Kind::Quaternion) {
        part.error = 16 * u;
        part.largest = 1 + 16 * u;
        part.inverse_error = 16 * u;
        return part;
    }
    part.largest = part.rounded.cwiseAbs().maxCoeff();
    const Mat3 gram = part.rounded.transpose() * part.rounded - Mat3::Identity();
    // Three products and three sums: the rounding is below 5 u (3 largest^2 + 1).
    part.skew = gram.cwiseAbs().maxCoeff() + 5 * u * (3 * part.largest * part.largest + 1);
    const double spread = 3 * part.skew;
    part.inverse_error = spread < 0.5 ? spread / (1 - spread) * (1 + spread)
                                      : std::numeric_limits<double>::infinity();
    return part;
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

RelativePose relative_pose(const PosePair& poses) {
    const LinearPart a = linear_part(poses.a);
    const LinearPart b = linear_part(poses.b);
    const Vec3 offset = poses.b.translation() - poses.a.translation();
    const double reach = offset.cwiseAbs().maxCoeff();
    // Each bound below is raised by this for the roundings of its own computation.
    constexpr double slack = 1.01;

    RelativePose relative;
    relative.rotation = a.rounded.transpose() * b.rounded;
    // Three products of factors with their errors, and three roundings of at most that sum each.
    relative.rotation_error = slack * 3 *
                              (a.inverse_error * b.largest + a.largest * b.error +
                               a.inverse_error * b.error + 4 * u * a.largest * b.largest);
    relative.translation = a.rounded.transpose() * offset;
    // The difference is within u of itself, the product's roundings within 4 u. What underflows is
    // below 2^-1000.
    relative.translation_error =
        slack * 3 * reach * (a.inverse_error * (1 + u) + 5 * u * a.largest) + 0x1p-1000;
    // R'R = B' (AA')^-1 B; AA' - I has the norm of A'A - I.
    const double spread = 3 * a.skew;
    relative.skew = spread < 0.5 ? slack * (b.skew + (1 + 3 * b.skew) * spread / (1 - spread))
                                 : std::numeric_limits<double>::infinity();
    return relative;
}

} // namespace cd
