// The points that two touching triangles share, in integers: right on every finite input.
#pragma once

#include "common/geometry/types.hpp"
#include "common/pair/numbers/dyadic.hpp"

#include <vector>

namespace cd {

/// What `SharedPoints` promises, with nothing rounded before the end. See there.
class ExactPoints {
  public:
    explicit ExactPoints(const PosePair& poses);

    [[nodiscard]] Vec3 origin(const Corners& a) const;
    /// The first corner of A minus `origin`, any finite point.
    [[nodiscard]] Vec3 offset(const Corners& a, const Vec3& origin) const;
    /// Relative to `origin`, likewise; empty for triangles that share nothing.
    [[nodiscard]] std::vector<Vec3>
    points(const Corners& a, const Corners& b, const Vec3& origin) const;

  private:
    ExactPose a_;
    ExactPose b_;
    Dyadic norm_; ///< Of both: what the common lattice is scaled by.
};

} // namespace cd
