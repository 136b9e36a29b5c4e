#include "common/pair/stages/double_batch/double_triangle_pairs.hpp"

#include "common/core/check.hpp"
#include "common/geometry/simd_target.hpp"

namespace cd {

namespace {

void put(CornersOfMany::Triangles& to, std::size_t number, const Corners& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            to[i][k][number] = corners[i][static_cast<int>(k)];
        }
    }
}

} // namespace

DoubleTrianglePairs::DoubleTrianglePairs(const PosePair& poses, double bound_scale)
    : poses_(poses),
      bound_scale_(bound_scale),
      // Runs before the kernel's first call, so that a forced target takes effect.
      pays_(simd_target() != SimdTarget::Scalar) {}

void DoubleTrianglePairs::add(const Corners& a, const Corners& b) {
    CD_CHECK(count_ < pairs_max);
    put(corners_.a, count_, a);
    put(corners_.b, count_, b);
    ++count_;
}

void DoubleTrianglePairs::decide() {
    classify_in_doubles(poses_, bound_scale_, corners_, count_, classes_.data());
    count_ = 0;
}

} // namespace cd
