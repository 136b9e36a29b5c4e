// The double-double stage of nearest points. The stage proves all of a pair's numbers or gives
// none.
#pragma once

#include "common/distance/distance_certificate.hpp"
#include "common/distance/nearest_points.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace cd {

class DoubleDoubleNearest {
  public:
    /// Multiplies all error bounds by `error_scale`. Answers are right only from 1 on; tests use
    /// less to show that the error bounds are needed.
    explicit DoubleDoubleNearest(const PosePair& poses, double error_scale = 1);

    /// Returns the nearest points; nothing if a number is unproven. `likely` is the feature that is
    /// probably the nearest. `origin` is the first corner of A in the world, rounded, and
    /// `offset()` the exact corner minus it, rounded, which is asked for only if needed.
    [[nodiscard]] std::optional<NearestPoints> nearest(const Corners& a,
                                                       const Corners& b,
                                                       const Vec3& origin,
                                                       std::size_t likely,
                                                       const std::function<Vec3()>& offset) const;

  private:
    struct Pair;

    LocalMap a_;
    LocalMap b_;
    double scale_;
};

} // namespace cd
