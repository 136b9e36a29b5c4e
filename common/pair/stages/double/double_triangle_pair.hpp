// The double stage of the decision: signs with error bounds. The stage proves an answer or gives
// none.
#pragma once

#include "common/pair/pair_decision.hpp"
#include "common/pair/poses/rounded_poses.hpp"
#include "common/pair/stages/double/double_signs.hpp"
#include "common/pair/triangle_pair.hpp"

#include <optional>

namespace cd {

class DoubleTrianglePair {
  public:
    /// Multiplies all error bounds by `bound_scale`. Answers are right only from 1 on; tests use
    /// less to show that the bounds are needed.
    explicit DoubleTrianglePair(const PosePair& poses, double bound_scale = 1);

    /// Selects the constructor for poses that are plain already.
    struct Plain {};
    DoubleTrianglePair(Plain, const PosePair& poses) : poses_(poses) {}

    /// Returns the class that is proven under the exact poses; nothing if rounding leaves it open.
    /// Never allocates.
    [[nodiscard]] std::optional<PairClass> classify(const Corners& a, const Corners& b) const;

    /// Returns `use(signs)` for the pair's DoubleSigns, of ExactCorners or of PosedCorners. The
    /// signs are valid until `use` returns.
    template <class Use>
    [[nodiscard]] auto with_signs(const Corners& a, const Corners& b, const Use& use) const {
        if (!poses_.are_rotated) {
            const ExactCorners frame(poses_, a, b);
            if (frame.are_exact()) {
                return use(DoubleSigns(frame, bound_scale_));
            }
        }
        const PosedCorners frame(poses_, a, b);
        return use(DoubleSigns(frame, bound_scale_));
    }

  private:
    RoundedPoses poses_;
    double bound_scale_ = 1;
};

/// Models CornerSigns with the signs that `signs` proves. Once an unproven sign is asked for,
/// `are_enough` is false, and all answers are meaningless; they end the decision quickly.
template <class Signs>
class ProvenSigns {
  public:
    explicit ProvenSigns(const Signs& signs) : signs_(signs) {}

    [[nodiscard]] bool are_enough() const { return enough_; }

    [[nodiscard]] PlaneSides sides_of_a() { return proven(signs_.sides_of_a()); }
    [[nodiscard]] PlaneSides sides_of_b() { return proven(signs_.sides_of_b()); }
    [[nodiscard]] int edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) {
        return proven(signs_.edge_side(i, i_to, j, j_to));
    }
    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) {
        return proven(signs_.turn(i, j, k, axis));
    }
    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) {
        return proven(signs_.difference(i, j, axis));
    }

  private:
    [[nodiscard]] int proven(int sign) {
        enough_ = enough_ && sign != unknown_sign;
        return sign;
    }
    [[nodiscard]] PlaneSides proven(const PlaneSides& sides) {
        enough_ = enough_ && !is_any_unknown(sides);
        return enough_ ? sides : PlaneSides{1, 1, 1};
    }

    const Signs& signs_;
    bool enough_ = true;
};

} // namespace cd
