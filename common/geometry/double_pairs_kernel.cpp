#include "common/geometry/double_pairs_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/geometry/double_pairs_kernel.cpp"
#include <hwy/foreach_target.h>
// What follows is compiled for every target.
#include "common/geometry/double_pairs_decide-inl.hpp"
#include "common/geometry/double_pairs_frame-inl.hpp"

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
        Frame frame;
        fill(poses, load(corners, first), frame);
        hn::Store(decide(frame, bound_scale), Doubles(), found + first);
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
