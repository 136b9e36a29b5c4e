// Depths of hits in double-double, rounded by Ziv's test.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"
#include "common/shots/line_hit.hpp"

#include <optional>

namespace cd {

class DoubleDoubleDepth {
  public:
    /// Multiplies all error bounds by `bound_scale`. Answers are right only from 1 on; tests use
    /// less to show that the bounds are needed.
    explicit DoubleDoubleDepth(const PosePair& poses, double bound_scale = 1);

    /// Selects the segment, of a length that is rounded to `length`.
    void set_line(const Segment& line, double length);

    /// Returns the depth at which the segment passes through a triangle's plane. The segment's ends
    /// must be on different sides of the plane, or one of them in it. Returns nothing if the bounds
    /// do not prove the rounding.
    [[nodiscard]] std::optional<double> depth(const Corners& a) const;

  private:
    LocalMap a_;
    LocalMap b_;
    double bound_scale_;
    Vec3 origin_ = Vec3::Zero(); ///< A point near the segment, to which corners are relative.
    std::optional<LocalTriangle> line_; ///< Empty if no segment is selected.
    double length_ = 0;
};

} // namespace cd
