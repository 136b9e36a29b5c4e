#include "common/pair/stages/double_batch/double_pairs_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/pair/stages/double_batch/double_pairs_kernel.cpp"
#include <hwy/foreach_target.h>
// The headers below are compiled for every target.
#include "common/pair/stages/double_batch/double_pairs_decide-inl.hpp"
#include "common/pair/stages/double_batch/double_pairs_frame-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

void classify_many(const RoundedPoses& poses,
                   double bound_scale,
                   const CornersOfMany& corners,
                   std::size_t count,
                   std::uint8_t* classes) {
    using namespace double_pairs;
    alignas(64) double found[CornersOfMany::pairs];
    for (std::size_t first = 0; first < count; first += lanes) {
        const Given given = load(corners, first);
        V verdicts;
        ExactFrame exact;
        if (!poses.are_rotated && fill(poses, given, exact)) {
            verdicts = decide(exact, bound_scale);
        } else {
            PosedFrame posed;
            fill(poses, given, posed);
            verdicts = decide(posed, bound_scale);
        }
        hn::Store(verdicts, Doubles(), found + first);
    }
    for (std::size_t i = 0; i < count; ++i) {
        classes[i] = static_cast<std::uint8_t>(found[i]);
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(classify_many);

void classify_in_doubles(const RoundedPoses& poses,
                         double bound_scale,
                         const CornersOfMany& corners,
                         std::size_t count,
                         std::uint8_t* classes) {
    HWY_DYNAMIC_DISPATCH(classify_many)(poses, bound_scale, corners, count, classes);
}

} // namespace cd

#endif
