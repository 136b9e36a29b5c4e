// The motion of two bodies between two keys.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"
#include "common/motion/body_path.hpp"
#include "common/motion/motion_bound.hpp"

namespace cd {

/// Returns the least K with 2^-K M <= `resolution`, which is positive. Errors: TooLarge if K
/// exceeds `limits::motion_depth_max`.
[[nodiscard]] Result<unsigned> depth_for(double bound, double resolution);

/// Returns K, the least number of halvings after which M of the whole motion between two keys is at
/// most `resolution`, a length in the job's unit. The keys may be on too fine a grid. Errors:
/// BadInput for a resolution that is not positive and finite, and for keys without a path
/// (`path_between`); TooLarge if K exceeds `limits::motion_depth_max`.
[[nodiscard]] Result<unsigned>
motion_depth(const PosePair& from, const PosePair& to, const BodyRadii& radii, double resolution);

/// Two bodies that move between two keys, for tau in [0, 1]. Every pose that the search over cells
/// needs is exact in doubles, and rigid.
class Motion {
  public:
    /// Makes the motion from one pair of poses to the next, which are on a grid (`round_keys`).
    /// Errors: those of `motion_depth`; BadInput for keys on too fine a grid.
    [[nodiscard]] static Result<Motion>
    create(const PosePair& from, const PosePair& to, const BodyRadii& radii, double resolution);

    /// Returns K: M of every cell of level K is at most the resolution. No cell is deeper.
    [[nodiscard]] unsigned depth() const { return depth_; }
    [[nodiscard]] double resolution() const { return resolution_; }

    /// Returns the exact poses at tau = index / 2^level, where the level is at most K + 1.
    [[nodiscard]] PosePair at(std::uint32_t index, unsigned level) const;
    /// Returns the exact poses at the cell's middle.
    [[nodiscard]] PosePair at_middle(const TimeCell& cell) const;

    /// Returns M of the whole motion: how far a point of A and one of B can move against each other
    /// between tau = 1/2 and any other time.
    [[nodiscard]] double bound() const;
    /// Returns M of a cell (`cell_bound`).
    [[nodiscard]] double bound(const TimeCell& cell, double bound_of_parent) const {
        return cell_bound(a_, b_, radii_, cell, bound_of_parent);
    }

  private:
    Motion(const BodyPath& a,
           const BodyPath& b,
           const BodyRadii& radii,
           double resolution,
           unsigned depth)
        : a_(a), b_(b), radii_(radii), resolution_(resolution), depth_(depth) {}

    BodyPath a_;
    BodyPath b_;
    BodyRadii radii_;
    double resolution_;
    unsigned depth_;
};

} // namespace cd
