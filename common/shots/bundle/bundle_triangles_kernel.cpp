#include "common/shots/bundle/bundle_triangles_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/shots/bundle/bundle_triangles_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/shots/bundle/bundle_lanes-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using bundle::bits_of;

using Doubles = hn::CappedTag<double, 8>;
using V = hn::Vec<Doubles>;

struct Vectors {
    V x;
    V y;
    V z;
};

HWY_INLINE Vectors load(const double* from) {
    Vectors v;
    hn::LoadInterleaved3(Doubles(), from, v.x, v.y, v.z);
    return v;
}

HWY_INLINE Vectors load(const float* from) {
    const hn::Rebind<float, Doubles> floats;
    const Doubles d;
    hn::Vec<decltype(floats)> x;
    hn::Vec<decltype(floats)> y;
    hn::Vec<decltype(floats)> z;
    hn::LoadInterleaved3(floats, from, x, y, z);
    return {hn::PromoteTo(d, x), hn::PromoteTo(d, y), hn::PromoteTo(d, z)};
}

using Bins = hn::Rebind<std::int32_t, Doubles>;

HWY_INLINE V set(double value) {
    return hn::Set(Doubles(), value);
}

template <class T>
HWY_INLINE void
place_vertices(const T* from, std::size_t count, const BundleFrame& frame, BlockAcross& placed) {
    const Doubles d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Vectors v = load(from + 3 * i);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::array<double, 3>& row = frame.rows()[k];
            const V linear = hn::Add(hn::Add(hn::Mul(set(row[0]), v.x), hn::Mul(set(row[1]), v.y)),
                                     hn::Mul(set(row[2]), v.z));
            hn::StoreU(hn::Add(linear, set(frame.translation()[k])), d, &placed.vertices[k][i]);
        }
    }
}

/// Returns the bins of coordinates by the operations of ParallelLines::bin_of.
HWY_INLINE hn::Vec<Bins> bins_of(const BundleAcross::Axis& axis, V coordinate) {
    const V place = hn::Mul(hn::Sub(coordinate, set(axis.least)), set(axis.bins_per_length));
    return hn::DemoteTo(Bins(), hn::Min(hn::Max(place, set(0)), set(axis.last_bin)));
}

/// The box of a vector of triangles on one axis.
struct Interval {
    V low;
    V high;

    HWY_INLINE
    Interval(const std::array<BlockAcross::Doubles, 3>& corners, std::size_t begin, V error) {
        const Doubles d;
        const V a = hn::Load(d, &corners[0][begin]);
        const V b = hn::Load(d, &corners[1][begin]);
        const V c = hn::Load(d, &corners[2][begin]);
        low = hn::Sub(hn::Min(hn::Min(a, b), c), error);
        high = hn::Add(hn::Max(hn::Max(a, b), c), error);
    }
};

/// Computes what a vector of triangles from `begin` on needs, from their corners.
HWY_INLINE void
place_triangles(std::size_t begin, const BundleAcross& bundle, BlockAcross& placed) {
    const Doubles d;
    const V error = set(bundle.error);
    V across = hn::Zero(d);
    for (std::size_t which = 0; which < 2; ++which) {
        const Interval box(placed.corners[1 + which], begin, error);
        const BundleAcross::Axis& axis = bundle.axes[which];
        hn::Store(box.low, d, &placed.low[which][begin]);
        hn::Store(box.high, d, &placed.high[which][begin]);
        hn::Store(bins_of(axis, box.low), Bins(), &placed.first[which][begin]);
        hn::Store(bins_of(axis, box.high), Bins(), &placed.last[which][begin]);
        across = hn::Add(across, hn::Add(hn::Sub(box.high, box.low), set(axis.bin_size)));
    }
    const BundleAcross::TurnError& terms = bundle.turn_error;
    const V slope = hn::Add(set(terms.linear), hn::Mul(set(terms.square), across));
    hn::Store(hn::Add(set(terms.constant), hn::Mul(slope, across)), d, &placed.turn_error[begin]);
    const Interval along(placed.corners[0], begin, error);
    const auto between =
        hn::And(hn::Gt(along.low, set(bundle.ends[0])), hn::Lt(along.high, set(bundle.ends[1])));
    placed.between |= bits_of(d, between) << begin;
}

template <class T>
HWY_INLINE void place(const T* from,
                      std::size_t count,
                      const BlockCorners* corners,
                      std::uint32_t triangles,
                      const BundleFrame& frame,
                      const BundleAcross& bundle,
                      BlockAcross& placed) {
    place_vertices(from, count, frame, placed);
    // Copies corners one by one, because SIMD gathers are slow on some processors.
    std::uint32_t placed_count = 0;
    for (; triangles != 0; triangles &= triangles - 1) {
        const std::size_t place = hwy::Num0BitsBelowLS1Bit_Nonzero32(triangles);
        placed.places[placed_count] = static_cast<std::uint8_t>(place);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t vertex = corners[place][i];
            placed.corners[0][i][placed_count] = placed.vertices[0][vertex];
            placed.corners[1][i][placed_count] = placed.vertices[1][vertex];
            placed.corners[2][i][placed_count] = placed.vertices[2][vertex];
        }
        ++placed_count;
    }
    placed.count = placed_count;
    placed.between = 0;
    for (std::size_t begin = 0; begin < placed_count; begin += hn::Lanes(Doubles())) {
        place_triangles(begin, bundle, placed);
    }
    placed.between &= (1u << placed_count) - 1;
}

void place_floats(const float* from,
                  std::size_t count,
                  const BlockCorners* corners,
                  std::uint32_t triangles,
                  const BundleFrame* frame,
                  const BundleAcross* bundle,
                  BlockAcross* placed) {
    place(from, count, corners, triangles, *frame, *bundle, *placed);
}

void place_doubles(const double* from,
                   std::size_t count,
                   const BlockCorners* corners,
                   std::uint32_t triangles,
                   const BundleFrame* frame,
                   const BundleAcross* bundle,
                   BlockAcross* placed) {
    place(from, count, corners, triangles, *frame, *bundle, *placed);
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(place_floats);
HWY_EXPORT(place_doubles);

/// With u = 2^-53, e for the error and L, M for the bounds of differences on the two axes, L + M =
/// S: a computed difference of a corner and a line is at most L and errs by e + u L. The product of
/// two errs by L (e + u M) + M (e + u L) + (e + u S)^2, and rounding by u L M; two products by
/// twice that, and their difference by another 2 u L M. With L M <= S^2 / 4 that is at most
///     2 S e + u S^2 + 2 (e + u S)^2 + u S^2.
/// The terms have room for those in u S of the square, and for the bound's own roundings.
BundleAcross::TurnError turn_error_of(double error, double scale) {
    constexpr double u = 0x1p-53;
    return {scale * (1.01 * 2 * error * error + 0x1p-1000),
            scale * 1.01 * 2 * error,
            scale * 1.01 * 3 * u};
}

BundleAcross bundle_across(const ParallelLines& lines, double error, double bound_scale) {
    BundleAcross across;
    for (std::size_t which = 0; which < 2; ++which) {
        const LineSteps& steps = lines.steps(which);
        across.axes[which] = {lines.least()[which],
                              steps.bins_per_length,
                              static_cast<double>(steps.count() - 1),
                              lines.bin_size(which),
                              steps.least.data(),
                              steps.most.data(),
                              steps.steps_per_length,
                              steps.slack};
    }
    const auto [least, most] = std::minmax(lines.ends()[0], lines.ends()[1]);
    across.ends = {least, most};
    across.error = error;
    across.turn_error = turn_error_of(error, bound_scale);
    return across;
}

void place_block(const TriangleBlocks& blocks,
                 std::uint32_t block,
                 std::uint32_t triangles,
                 const BundleFrame& frame,
                 const BundleAcross& bundle,
                 BlockAcross& placed) {
    const std::size_t first = 3 * std::size_t{blocks.vertex_begin[block]};
    const std::size_t count = blocks.vertex_begin[block + 1] - blocks.vertex_begin[block];
    const BlockCorners* const corners = &blocks.corners[std::size_t{block_size} * block];
    if (blocks.doubles.empty()) {
        HWY_DYNAMIC_DISPATCH(place_floats)
        (&blocks.floats[first], count, corners, triangles, &frame, &bundle, &placed);
    } else {
        HWY_DYNAMIC_DISPATCH(place_doubles)
        (&blocks.doubles[first], count, corners, triangles, &frame, &bundle, &placed);
    }
}

} // namespace cd

#endif
