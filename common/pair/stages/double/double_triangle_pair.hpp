// The double stage of the decision: signs with error bounds. The stage proves a sign or gives none.
#pragma once

#include "common/pair/poses/rounded_poses.hpp"
#include "common/pair/stages/double/double_signs.hpp"
#include "common/pair/triangle_pair.hpp"

namespace cd {

class DoubleTrianglePair {
  public:
    /// The poses must be plain (see `plain_poses`). Multiplies all error bounds by `bound_scale`.
    /// Signs are right only from 1 on; tests use less to show that the bounds are needed.
    explicit DoubleTrianglePair(const PosePair& poses, double bound_scale = 1)
        : poses_(poses), bound_scale_(bound_scale) {}

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
    double bound_scale_;
};

} // namespace cd
