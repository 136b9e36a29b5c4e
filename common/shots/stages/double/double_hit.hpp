// The double stage of hits: signs with error bounds. The stage proves an answer or gives none.
//
// Sides and edges are signs of DoubleSigns. A tie is a determinant of two rows: the segment's
// vector and an edge's, both differences within a triangle, so the bound of double_signs.hpp for
// two rows holds.
#pragma once

#include "common/pair/stages/double/double_signs.hpp"
#include "common/pair/stages/float/rounded_poses.hpp"
#include "common/shots/hit_decision.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// Provides the signs of HitSigns that doubles prove, and `unknown_sign` for others. `Frame` is
/// ExactCorners or PosedCorners of a triangle and a segment's `corners`.
template <class Frame>
class DoubleHitSigns {
  public:
    /// Multiplies all error bounds by `bound_scale`.
    explicit DoubleHitSigns(const Frame& frame, double bound_scale = 1)
        : frame_(frame), signs_(frame, bound_scale), scale_(bound_scale) {}

    [[nodiscard]] std::array<int, 2> sides() const {
        const PlaneSides sides = signs_.sides_of_b();
        return {sides[0], sides[1]};
    }
    [[nodiscard]] int edge(std::size_t i) const { return signs_.edge_side(3, 4, i, (i + 1) % 3); }
    [[nodiscard]] int tie(std::size_t i, std::size_t axis) const {
        using namespace double_signs;
        const std::size_t x = (axis + 1) % 3;
        const std::size_t y = (axis + 2) % 3;
        const std::size_t to = (i + 1) % 3;
        const Sized area = determinant(frame_.within(3, 4, x),
                                       frame_.within(3, 4, y),
                                       frame_.within(i, to, x),
                                       frame_.within(i, to, y));
        const bool is_zero = frame_.are_tame() && area.size() == 0;
        return sign_of(area.value(), scale_ * area_bound * area.size() + underflow, is_zero);
    }

  private:
    const Frame& frame_;
    DoubleSigns<Frame> signs_;
    double scale_;
};

class DoubleHit {
  public:
    /// Multiplies all error bounds by `bound_scale`. Answers are right only from 1 on; tests use
    /// less to show that the bounds are needed.
    explicit DoubleHit(const PosePair& poses, double bound_scale = 1)
        : poses_(poses), bound_scale_(bound_scale) {}

    /// Returns `use(signs)` for the DoubleHitSigns of a triangle and a segment, which are valid
    /// until `use` returns.
    template <class Use>
    [[nodiscard]] auto with_signs(const Corners& a, const Segment& line, const Use& use) const {
        const Corners b = line.corners();
        if (!poses_.are_rotated) {
            const ExactCorners frame(poses_, a, b);
            if (frame.are_exact()) {
                return use(DoubleHitSigns(frame, bound_scale_));
            }
        }
        const PosedCorners frame(poses_, a, b);
        return use(DoubleHitSigns(frame, bound_scale_));
    }

    /// Returns the decision that is proven under the exact poses; nothing if rounding leaves it
    /// open. Never allocates.
    [[nodiscard]] std::optional<HitDecision> decide(const Corners& a, const Segment& line) const {
        return with_signs(a, line, [](const auto& signs) {
            ProvenHitSigns proven(signs);
            const HitDecision decision = decide_hit(proven);
            return proven.are_enough() ? std::optional(decision) : std::nullopt;
        });
    }

  private:
    RoundedPoses poses_; ///< Of the given poses: simpler ones would turn the world's axes.
    double bound_scale_ = 1;
};

} // namespace cd
