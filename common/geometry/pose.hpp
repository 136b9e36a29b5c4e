// Rigid poses, kept as the exact numbers that they were given as (NUMERICS: the contract).
#pragma once

#include "common/geometry/types.hpp"

#include <cstdint>

namespace cd {

/// A quaternion as given: it need not have norm 1. Rotates by M(q) / q.q, which is exactly rigid.
struct Quaternion {
    double w = 1;
    double x = 0;
    double y = 0;
    double z = 0;

    friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// The product: rotating by `left * right` rotates by `right` first. Only + - *, in a fixed order.
[[nodiscard]] Quaternion operator*(const Quaternion& left, const Quaternion& right);

/// Maps a body's coordinates into the world: x' = R x + t, column vectors.
///
/// Two exact kinds: twelve doubles taken literally, or a quaternion with a translation. A pose
/// stays what it was given as, on the wire and on disk.
class Pose {
  public:
    enum class Kind : std::uint8_t { Matrix = 0, Quaternion = 1 };

    /// The identity, as a matrix.
    Pose() = default;
    [[nodiscard]] static Pose from_matrix(const Mat3& rotation, const Vec3& translation);
    /// The quaternion is not zero.
    [[nodiscard]] static Pose from_quaternion(const Quaternion& quaternion,
                                              const Vec3& translation);

    [[nodiscard]] Kind kind() const { return kind_; }
    /// The matrix as given; only of kind Matrix.
    [[nodiscard]] const Mat3& matrix() const;
    /// The quaternion as given; only of kind Quaternion.
    [[nodiscard]] const Quaternion& quaternion() const;
    [[nodiscard]] const Vec3& translation() const { return translation_; }

    /// The rotation in doubles: exact for a matrix, within a few roundings for a quaternion.
    [[nodiscard]] Mat3 rotation() const;
    /// Bounds the error of each entry of `rotation`: 0 for a matrix.
    [[nodiscard]] double rotation_error() const;
    /// R x + t, rounded: for filters, pictures and generators, never for a decision.
    [[nodiscard]] Vec3 apply(const Vec3& point) const;

    [[nodiscard]] bool is_finite() const;

    friend bool operator==(const Pose& left, const Pose& right);

  private:
    Kind kind_ = Kind::Matrix;
    Mat3 matrix_ = Mat3::Identity();
    Quaternion quaternion_;
    Vec3 translation_ = Vec3::Zero();
};

/// Each body's own pose in the world.
struct PosePair {
    Pose a;
    Pose b;

    friend bool operator==(const PosePair&, const PosePair&) = default;
};

/// B's coordinates expressed in A's, rounded, with bounds on what the rounding can do and on how
/// far the matrices are from rigid. A filter's value: decisions take each body's own pose.
///
/// The bounds are small wherever A's matrix is well-conditioned, rigid or not; infinite, never NaN,
/// where numbers overflow or A's matrix is far from rigid.
struct RelativePose {
    Mat3 rotation;                ///< Approximates Ra^-1 Rb.
    Vec3 translation;             ///< Approximates Ra^-1 (tb - ta).
    double rotation_error = 0;    ///< Bounds the error of each entry of `rotation`.
    double translation_error = 0; ///< Bounds the error of each component of `translation`.
    double skew = 0; ///< Bounds each |entry| of R'R - I for the true relative rotation R.
};

[[nodiscard]] RelativePose relative_pose(const PosePair& poses);

} // namespace cd
