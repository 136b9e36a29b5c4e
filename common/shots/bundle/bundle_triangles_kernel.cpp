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

/// Returns twice the area of the triangle of the origin and two points, positive if it turns left.
HWY_INLINE V turn(V from_x, V from_y, V to_x, V to_y) {
    return hn::Sub(hn::Mul(from_x, to_y), hn::Mul(from_y, to_x));
}

/// A triangle's corners across the lines and the bound of its turns, the same in all lanes.
struct Target {
    HWY_INLINE Target(const BlockAcross& placed, std::size_t triangle)
        : error(set(placed.turn_error[triangle])) {
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = set(placed.corners[1][i][triangle]);
            y[i] = set(placed.corners[2][i][triangle]);
        }
    }

    V x[3];
    V y[3];
    V error;
};

/// Marks the lines of one vector, of which the first `valid` count.
HWY_INLINE void mark_vector(const Target& target,
                            std::uint32_t triangle,
                            const LineRows& lines,
                            std::uint32_t first,
                            std::uint32_t valid,
                            MarkedPairs& marked) {
    const Doubles d;
    const V line_x = hn::LoadU(d, lines.across[0] + first);
    const V line_y = hn::LoadU(d, lines.across[1] + first);
    V x[3];
    V y[3];
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = hn::Sub(target.x[i], line_x);
        y[i] = hn::Sub(target.y[i], line_y);
    }
    const V turns[3] = {
        turn(x[0], y[0], x[1], y[1]), turn(x[1], y[1], x[2], y[2]), turn(x[2], y[2], x[0], y[0])};
    const V least = hn::Min(hn::Min(turns[0], turns[1]), turns[2]);
    const V most = hn::Max(hn::Max(turns[0], turns[1]), turns[2]);
    const V minus_error = hn::Neg(target.error);
    const auto misses = hn::And(hn::Lt(least, minus_error), hn::Gt(most, target.error));
    std::uint32_t left = ~bits_of(d, misses) & ((1u << valid) - 1);
    if (left == 0) {
        return;
    }
    const std::uint32_t along = bits_of(d, hn::Gt(least, target.error));
    const std::uint32_t against = bits_of(d, hn::Lt(most, minus_error));
    for (; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(left));
        marked.lines[marked.count] = first + lane;
        marked.triangles[marked.count] = static_cast<std::uint8_t>(triangle);
        marked.passes[marked.count] =
            static_cast<LinePasses>((along >> lane & 1) | (against >> lane & 1) << 1);
        ++marked.count;
    }
}

/// Returns whether some line may have a coordinate in a triangle's box on one axis. A line in the
/// first bin does if the box begins before the bin's last line, one in the last bin if the box ends
/// behind its first line, and any line between these bins does.
HWY_INLINE bool holds_coordinate(const BlockAcross& placed,
                                 const BundleAcross& bundle,
                                 std::size_t which,
                                 std::size_t triangle) {
    const BundleAcross::Axis& axis = bundle.axes[which];
    const std::int32_t first = placed.first[which][triangle];
    const std::int32_t last = placed.last[which][triangle];
    const bool is_below = placed.low[which][triangle] <= axis.most_of_bins[first];
    const bool is_above = placed.high[which][triangle] >= axis.least_of_bins[last];
    return first == last ? is_below & is_above : is_below | is_above | (last - first > 1);
}

bool mark_pairs_on(const BlockAcross* placed,
                   const BundleAcross* bundle,
                   const LineRows* lines,
                   LineWalk* walk,
                   MarkedPairs* marked) {
    constexpr auto lanes = static_cast<std::uint32_t>(hn::MaxLanes(Doubles()));
    marked->count = 0;
    marked->tested = 0;
    for (; walk->triangle < placed->count; ++walk->triangle, walk->row = 0) {
        const std::uint32_t triangle = walk->triangle;
        if (!(holds_coordinate(*placed, *bundle, 0, triangle) &
              holds_coordinate(*placed, *bundle, 1, triangle))) {
            continue;
        }
        const Target target(*placed, triangle);
        const auto column = static_cast<std::uint32_t>(placed->first[0][triangle]);
        const auto column_end = static_cast<std::uint32_t>(placed->last[0][triangle]) + 1;
        const auto first_row = static_cast<std::uint32_t>(placed->first[1][triangle]);
        const auto rows = static_cast<std::uint32_t>(placed->last[1][triangle]) + 1 - first_row;
        for (; walk->row < rows; ++walk->row, walk->line = 0) {
            const std::uint32_t begin = lines->begin_of(column, first_row + walk->row);
            const std::uint32_t end = lines->begin_of(column_end, first_row + walk->row);
            for (std::uint32_t i = begin + walk->line; i < end; i += lanes) {
                if (marked->count + lanes > MarkedPairs::most) {
                    walk->line = i - begin;
                    return false;
                }
                const std::uint32_t valid = end - i < lanes ? end - i : lanes;
                mark_vector(target, triangle, *lines, i, valid, *marked);
                marked->tested += valid;
            }
        }
    }
    return true;
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(place_floats);
HWY_EXPORT(place_doubles);
HWY_EXPORT(mark_pairs_on);

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
                              steps.most.data()};
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

bool mark_pairs(const BlockAcross& placed,
                const BundleAcross& bundle,
                const LineRows& lines,
                LineWalk& walk,
                MarkedPairs& marked) {
    return HWY_DYNAMIC_DISPATCH(mark_pairs_on)(&placed, &bundle, &lines, &walk, &marked);
}

} // namespace cd

#endif
