// Exact points, and one exact frame that two posed bodies share.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/numbers/dyadic.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace cd {

using DyadicVec = std::array<Dyadic, 3>;

[[nodiscard]] DyadicVec to_dyadic(const Vec3& v);
[[nodiscard]] DyadicVec operator+(const DyadicVec& left, const DyadicVec& right);
[[nodiscard]] DyadicVec operator-(const DyadicVec& left, const DyadicVec& right);
[[nodiscard]] DyadicVec operator*(const Dyadic& factor, const DyadicVec& v);
[[nodiscard]] DyadicVec cross(const DyadicVec& left, const DyadicVec& right);
[[nodiscard]] Dyadic dot(const DyadicVec& left, const DyadicVec& right);
[[nodiscard]] bool is_zero(const DyadicVec& v);

[[nodiscard]] inline int sign_of(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}
[[nodiscard]] inline int sign_of(const Dyadic& value) {
    return value.mantissa.sign();
}

/// Returns the sign of a value that errs by at most `error`, or nothing if the error leaves it
/// open.
[[nodiscard]] inline std::optional<int> proven_sign(double value, double error) {
    // The bound assumes finite intermediate results; NaN and infinity decide nothing.
    return std::isfinite(value) && std::abs(value) > error ? std::optional(sign_of(value))
                                                           : std::nullopt;
}

/// Returns the sign of det(seen[0], seen[1], seen[2]) for rounded differences of vectors. Each
/// component of these vectors errs by at most `error`. Returns nothing if that leaves the sign
/// open.
[[nodiscard]] std::optional<int> proven_volume_sign(const std::array<Vec3, 3>& seen, double error);

/// The point `value` / `weight`; the weight is positive.
struct ExactPoint {
    DyadicVec value;
    Dyadic weight{1, 0};
};

/// An exact frame for two posed bodies: the outer body's coordinates, multiplied by a positive
/// scale so that no pose needs a division.
class ExactFrame {
  public:
    ExactFrame(const Pose& outer, const Pose& inner);

    /// Returns -1 if the relative pose mirrors the inner body, 1 if not, and 0 if either body's
    /// matrix is singular.
    [[nodiscard]] int orientation() const { return outer_orientation_ * inner_orientation_; }
    /// Returns whether the outer body's matrix is invertible. The members below require that.
    [[nodiscard]] bool has_inverse() const { return outer_orientation_ != 0; }

    [[nodiscard]] DyadicVec of_inner(const Vec3& point) const;
    [[nodiscard]] DyadicVec of_outer(const Vec3& point) const;
    [[nodiscard]] const Dyadic& scale() const { return scale_; }

  private:
    std::array<DyadicVec, 3> linear_; ///< Rows of the matrix from the inner body to the frame.
    DyadicVec translation_;
    Dyadic scale_;
    int outer_orientation_ = 0;
    int inner_orientation_ = 0;
};

} // namespace cd
