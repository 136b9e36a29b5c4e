// Depths of hits in double-double, rounded by Ziv's test.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"
#include "common/shots/line_hit.hpp"

#include <array>
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
    /// The sides of the segment's ends against a triangle's plane.
    struct Sides {
        DoubleDouble of_p;
        DoubleDouble of_q;
        double error = 0; ///< Bounds the error of each.
    };
    [[nodiscard]] std::optional<Sides> sides_in_frame(const Corners& a) const;
    [[nodiscard]] std::optional<Sides> sides_in_world(const Corners& a) const;
    void place_in_frame(const Segment& line);
    void place_in_world(const Segment& line);

    LocalMap a_;
    LocalMap b_;
    double bound_scale_;
    bool is_in_frame_; ///< A's pose is rigid, so that the segment is moved into A's coordinates.
    double length_ = 0;
    std::array<DoubleDoubleVec, 2> ends_; ///< In A's coordinates, if `is_in_frame_`.
    double end_error_ = 0; ///< Bounds the error of each of their components; infinite if unknown.
    Vec3 origin_ = Vec3::Zero();        ///< A point near the segment, else.
    std::optional<LocalTriangle> line_; ///< Relative to `origin_`; empty if that is not finite.
};

} // namespace cd
