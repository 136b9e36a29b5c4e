// Rigid poses, which keep exactly the numbers they are made from (docs/exactness.md).
#pragma once

#include "common/geometry/types.hpp"

#include <cstdint>

namespace cd {

/// A quaternion q that need not be normalised. The rotation is M(q) / q.q, which is exactly rigid;
/// M(q) has entries such as w^2 + x^2 - y^2 - z^2.
struct Quaternion {
    double w = 1;
    double x = 0;
    double y = 0;
    double z = 0;

    friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// Multiplies two quaternions; the product rotates by `right` first. Uses only + - * in a fixed
/// order, so that all hosts get the same bits.
[[nodiscard]] Quaternion operator*(const Quaternion& left, const Quaternion& right);

/// Maps a body's coordinates into the world: x' = R x + t, column vectors.
///
/// A pose keeps exactly the numbers given, also on the wire and on disk: a matrix R and t, twelve
/// doubles taken literally, or a quaternion and t.
class Pose {
  public:
    enum class Kind : std::uint8_t { Matrix = 0, Quaternion = 1 };

    /// Makes the identity, of kind Matrix.
    Pose() = default;
    [[nodiscard]] static Pose from_matrix(const Mat3& rotation, const Vec3& translation);
    /// Makes a pose of kind Quaternion. The quaternion must not be zero.
    [[nodiscard]] static Pose from_quaternion(const Quaternion& quaternion,
                                              const Vec3& translation);

    [[nodiscard]] Kind kind() const { return kind_; }
    /// Returns the matrix as given. The kind must be Matrix.
    [[nodiscard]] const Mat3& matrix() const;
    /// Returns the quaternion as given. The kind must be Quaternion.
    [[nodiscard]] const Quaternion& quaternion() const;
    [[nodiscard]] const Vec3& translation() const { return translation_; }

    /// Returns the rotation in doubles: exact for a matrix, within `rotation_error` for a
    /// quaternion.
    [[nodiscard]] Mat3 rotation() const;
    /// Bounds the absolute error of each entry of `rotation`: 0 for a matrix.
    [[nodiscard]] double rotation_error() const;
    /// Computes R x + t with rounding, for filters, pictures and generators, never for a decision.
    [[nodiscard]] Vec3 apply(const Vec3& point) const;

    [[nodiscard]] bool is_finite() const;

    friend bool operator==(const Pose& left, const Pose& right);

  private:
    Kind kind_ = Kind::Matrix;
    Mat3 matrix_ = Mat3::Identity();
    Quaternion quaternion_;
    Vec3 translation_ = Vec3::Zero();
};

/// The poses of bodies A and B in the world.
struct PosePair {
    Pose a;
    Pose b;

    friend bool operator==(const PosePair&, const PosePair&) = default;
};

/// The rounded map from B's coordinates to A's, with bounds on its rounding errors and on its
/// deviation from a rigid map. For filters only: decisions use each body's own pose.
///
/// The error bounds are small if A's matrix is well-conditioned, rigid or not. Bounds are infinite,
/// never NaN, if numbers overflow or A's matrix is far from rigid.
struct RelativePose {
    Mat3 rotation;                ///< Approximates Ra^-1 Rb.
    Vec3 translation;             ///< Approximates Ra^-1 (tb - ta).
    double rotation_error = 0;    ///< Bounds the error of each entry of `rotation`.
    double translation_error = 0; ///< Bounds the error of each component of `translation`.
    double skew = 0; ///< Bounds each |entry| of R'R - I for the exact relative rotation R.
};

[[nodiscard]] RelativePose relative_pose(const PosePair& poses);

} // namespace cd
