#include "common/pair/stages/double_batch/double_triangle_pairs.hpp"

#include "common/core/check.hpp"
#include "common/geometry/simd_target.hpp"

namespace cd {

DoubleTrianglePairs::DoubleTrianglePairs(const PosePair& poses, double bound_scale)
    : poses_(poses),
      bound_scale_(bound_scale),
      // Runs before the kernel's first call, so that a forced target takes effect.
      pays_(simd_target() != SimdTarget::Scalar) {}

void DoubleTrianglePairs::add(const Corners& a, const Corners& b) {
    CD_CHECK(count_ < pairs_max);
    corners_.set(count_, a, b);
    ++count_;
}

void DoubleTrianglePairs::decide() {
    classify_in_doubles(poses_, bound_scale_, corners_, count_, classes_.data());
    count_ = 0;
}

} // namespace cd
