// The shared points of two triangles in integers: right on every finite input.
#pragma once

#include "common/geometry/types.hpp"
#include "common/pair/numbers/dyadic.hpp"

#include <vector>

namespace cd {

/// Gives what `SharedPoints` promises, and rounds only the final result.
class ExactPoints {
  public:
    explicit ExactPoints(const PosePair& poses);

    [[nodiscard]] Vec3 origin(const Corners& a) const;
    /// Returns the first corner of A minus `origin`, which is any finite point.
    [[nodiscard]] Vec3 offset(const Corners& a, const Vec3& origin) const;
    /// Returns the points relative to any finite `origin`; none for triangles that share nothing.
    [[nodiscard]] std::vector<Vec3>
    points(const Corners& a, const Corners& b, const Vec3& origin) const;

  private:
    ExactPose a_;
    ExactPose b_;
    Dyadic norm_; ///< Product of both norms; scales the common lattice.
};

} // namespace cd
