#include "common/pair/stages/float/float_triangle_pair.hpp"

#include "common/core/check.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/pair/stages/float/float_pair_input.hpp"

#include <algorithm>

namespace cd {

namespace {

static_assert(sizeof(FloatVerdict) == sizeof(std::uint8_t));

} // namespace

FloatTrianglePair::FloatTrianglePair(const PosePair& poses, double bound_scale)
    : pose_(float_pair_pose(poses, bound_scale)) {
    // Runs before the kernel's first call, so that a forced target takes effect.
    static_cast<void>(simd_target());
}

template <class Triangles>
void FloatTrianglePair::classify(const Triangles& a,
                                 const Triangles& b,
                                 std::span<const Candidate> candidates,
                                 std::span<FloatVerdict> verdicts) const {
    CD_CHECK(candidates.size() == verdicts.size());
    if (!pose_.is_usable || candidates.empty()) {
        std::fill(verdicts.begin(), verdicts.end(), FloatVerdict::Unknown);
        return;
    }
    classify_in_floats(pose_,
                       float_pair_body(a),
                       float_pair_body(b),
                       &candidates.front().a,
                       candidates.size(),
                       reinterpret_cast<std::uint8_t*>(verdicts.data()));
}

template void FloatTrianglePair::classify(const TriangleSpan&,
                                          const TriangleSpan&,
                                          std::span<const Candidate>,
                                          std::span<FloatVerdict>) const;
template void FloatTrianglePair::classify(const TriangleBlocks&,
                                          const TriangleBlocks&,
                                          std::span<const Candidate>,
                                          std::span<FloatVerdict>) const;

} // namespace cd
