// Bit masks of SIMD lanes. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_BUNDLE_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_BUNDLE_LANES_INL_HPP
#undef CD_BUNDLE_LANES_INL_HPP
#else
#define CD_BUNDLE_LANES_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace bundle {

namespace hn = hwy::HWY_NAMESPACE;

/// Returns a bit for each lane of a mask, the first one lowest.
template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8;
}

} // namespace bundle
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
