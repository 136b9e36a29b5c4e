// The shared points of two triangles in integers: right on every finite input.
#pragma once

#include "common/geometry/types.hpp"
#include "common/pair/numbers/dyadic.hpp"

#include <vector>

namespace cd {

/// Computes the origin and the points that `SharedPoints` promises. Rounds only the final results.
class ExactPoints {
  public:
    explicit ExactPoints(const PosePair& poses);

    [[nodiscard]] Vec3 origin(const Corners& a) const;
    /// Returns the first corner of A minus `origin`, rounded once. `origin` may be any finite
    /// point.
    [[nodiscard]] Vec3 offset(const Corners& a, const Vec3& origin) const;
    /// Returns the shared points minus `origin`, any finite point; none for triangles that share no
    /// point.
    [[nodiscard]] std::vector<Vec3>
    points(const Corners& a, const Corners& b, const Vec3& origin) const;

  private:
    ExactPose a_;
    ExactPose b_;
    Dyadic norm_; ///< Product of both poses' norms, by which the coordinates of both bodies are
                  ///< scaled.
};

} // namespace cd
