#include "common/shots/bundle/bundle_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/shots/bundle/bundle_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, wide_children_max>;
using Doubles = hn::CappedTag<double, 8>;
using V = hn::Vec<Doubles>;

HWY_INLINE hn::Vec<Floats> load_bytes(const WideNode::Bytes& bytes, std::size_t first) {
    const hn::Rebind<std::int32_t, Floats> whole;
    const hn::Rebind<std::uint8_t, Floats> small;
    return hn::ConvertTo(Floats(), hn::PromoteTo(whole, hn::LoadU(small, bytes.data() + first)));
}

/// Returns a bit for each lane of a mask, the first one lowest.
template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// Returns the places of coordinates from the middle, counted in bins and rounded to whole ones.
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, Floats>>
bin_of(const LinesAcross::Axis& axis, hn::Vec<Floats> coordinate, float slack) {
    const Floats d;
    const auto place = hn::Add(hn::Mul(coordinate, hn::Set(d, axis.per_length)),
                               hn::Set(d, axis.first_bin + slack));
    const auto last = hn::Set(d, static_cast<float>(axis.last));
    return hn::ConvertTo(hn::Rebind<std::int32_t, Floats>(),
                         hn::Min(hn::Max(place, hn::Zero(d)), last));
}

/// Returns the children of which some line has a coordinate in the interval on an axis.
HWY_INLINE hn::Mask<Floats>
holds_a_line(const LinesAcross::Axis& axis, hn::Vec<Floats> low, hn::Vec<Floats> high) {
    const Floats d;
    const hn::Rebind<std::int32_t, Floats> whole;
    const auto first = bin_of(axis, low, -axis.slack);
    const auto last = bin_of(axis, high, axis.slack);
    const auto is_below = hn::Le(low, hn::GatherIndex(d, axis.most, first));
    const auto is_above = hn::Ge(high, hn::GatherIndex(d, axis.least, last));
    const auto is_one = hn::RebindMask(d, hn::Eq(first, last));
    const auto is_between = hn::RebindMask(d, hn::Gt(hn::Sub(last, first), hn::Set(whole, 1)));
    const auto both = hn::And(is_below, is_above);
    const auto any = hn::Or(hn::Or(is_below, is_above), is_between);
    return hn::Or(hn::And(is_one, both), hn::AndNot(is_one, any));
}

std::uint32_t children_with_lines_on(const WideNode* node,
                                     const NodeAcross* across,
                                     const LinesAcross* lines,
                                     ChildrenAcross* boxes) {
    const Floats d;
    std::uint32_t mask = 0;
    for (std::size_t first = 0; first < wide_children_max; first += hn::Lanes(d)) {
        auto held = hn::Eq(hn::Zero(d), hn::Zero(d));
        for (std::size_t which = 0; which < 2; ++which) {
            const NodeAcross::Axis& axis = across->axes[which];
            hn::Vec<Floats> low = hn::Set(d, axis.base - axis.margin);
            hn::Vec<Floats> high = hn::Set(d, axis.base + axis.margin);
            for (std::size_t k = 0; k < 3; ++k) {
                const bool rises = axis.steps[k] >= 0;
                const auto step = hn::Set(d, axis.steps[k]);
                const auto lesser = load_bytes(rises ? node->low[k] : node->high[k], first);
                const auto greater = load_bytes(rises ? node->high[k] : node->low[k], first);
                low = hn::Add(low, hn::Mul(step, lesser));
                high = hn::Add(high, hn::Mul(step, greater));
            }
            hn::Store(low, d, &boxes->low[which][first]);
            hn::Store(high, d, &boxes->high[which][first]);
            const LinesAcross::Axis& of = lines->axes[which];
            const auto half = hn::Set(d, of.half);
            const auto overlaps = hn::And(hn::Le(low, half), hn::Ge(high, hn::Neg(half)));
            held = hn::And(held, hn::And(overlaps, holds_a_line(of, low, high)));
        }
        mask |= bits_of(d, held) << first;
    }
    return mask;
}

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

template <class T>
HWY_INLINE void
place_all(const T* from, std::size_t count, const BundleFrame& frame, BlockAcross& placed) {
    const Doubles d;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Vectors v = load(from + 3 * i);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::array<double, 3>& row = frame.rows()[k];
            const V linear =
                hn::Add(hn::Add(hn::Mul(hn::Set(d, row[0]), v.x), hn::Mul(hn::Set(d, row[1]), v.y)),
                        hn::Mul(hn::Set(d, row[2]), v.z));
            hn::StoreU(hn::Add(linear, hn::Set(d, frame.translation()[k])), d, &placed.at[k][i]);
        }
    }
}

void place_floats(const float* from,
                  std::size_t count,
                  const BundleFrame* frame,
                  BlockAcross* placed) {
    place_all(from, count, *frame, *placed);
}

void place_doubles(const double* from,
                   std::size_t count,
                   const BundleFrame* frame,
                   BlockAcross* placed) {
    place_all(from, count, *frame, *placed);
}

/// Returns twice the area of the triangle of the origin and two points, positive if it turns left.
HWY_INLINE V turn(V from_x, V from_y, V to_x, V to_y) {
    return hn::Sub(hn::Mul(from_x, to_y), hn::Mul(from_y, to_x));
}

/// The corners of a triangle and the bound of its turns, the same in all lanes.
struct Target {
    HWY_INLINE explicit Target(const TriangleAcross& triangle)
        : error(hn::Set(Doubles(), triangle.error)) {
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = hn::Set(Doubles(), triangle.corners[0][i]);
            y[i] = hn::Set(Doubles(), triangle.corners[1][i]);
        }
    }

    V x[3];
    V y[3];
    V error;
};

/// Marks the lines of one vector, of which the first `valid` count.
HWY_INLINE void mark_vector(const Target& target,
                            const LineRows& lines,
                            std::uint32_t first,
                            std::uint32_t valid,
                            MarkedLines& marked) {
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
        marked.passes[marked.count] =
            static_cast<LinePasses>((along >> lane & 1) | (against >> lane & 1) << 1);
        ++marked.count;
    }
}

bool mark_lines_on(TriangleAcross* triangle, const LineRows* lines, MarkedLines* marked) {
    constexpr auto lanes = static_cast<std::uint32_t>(hn::MaxLanes(Doubles()));
    const Target target(*triangle);
    marked->count = 0;
    marked->tested = 0;
    BinRange& bins = triangle->bins;
    for (; bins.first[1] <= bins.last[1]; ++bins.first[1], triangle->skipped = 0) {
        const std::uint32_t begin = lines->begin_of(bins.first[0], bins.first[1]);
        const std::uint32_t end = lines->begin_of(bins.last[0] + 1, bins.first[1]);
        for (std::uint32_t i = begin + triangle->skipped; i < end; i += lanes) {
            if (marked->count + lanes > MarkedLines::most) {
                triangle->skipped = i - begin;
                return false;
            }
            const std::uint32_t valid = end - i < lanes ? end - i : lanes;
            mark_vector(target, *lines, i, valid, *marked);
            marked->tested += valid;
        }
    }
    return true;
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(children_with_lines_on);
HWY_EXPORT(place_floats);
HWY_EXPORT(place_doubles);
HWY_EXPORT(mark_lines_on);

/// With v = 2^-24 and n for the count of bins: places that count are within n of 0, so that their
/// product and sum err by at most 2 v n, and the coordinate, the middle's place and the factor by v
/// n each; places are clamped in the end. 16 v n has room.
LinesAcross lines_across(const ParallelLines& lines) {
    LinesAcross across;
    const std::array<double, 2> middle = lines.middle();
    const std::array<float, 2> half = lines.half();
    for (std::size_t which = 0; which < 2; ++which) {
        const LineSteps& steps = lines.steps(which);
        LinesAcross::Axis& axis = across.axes[which];
        axis.half = half[which];
        axis.first_bin =
            static_cast<float>((middle[which] - lines.least()[which]) * steps.bins_per_length);
        axis.per_length = static_cast<float>(steps.bins_per_length);
        axis.slack = 0x1p-20F * static_cast<float>(steps.count());
        axis.last = static_cast<std::int32_t>(steps.count() - 1);
        axis.least = steps.least_from_middle.data();
        axis.most = steps.most_from_middle.data();
    }
    return across;
}

std::uint32_t children_with_lines(const WideNode& node,
                                  const NodeAcross& across,
                                  const LinesAcross& lines,
                                  ChildrenAcross& boxes) {
    return HWY_DYNAMIC_DISPATCH(children_with_lines_on)(&node, &across, &lines, &boxes);
}

void place_block(const TriangleBlocks& blocks,
                 std::uint32_t block,
                 const BundleFrame& frame,
                 BlockAcross& placed) {
    const std::size_t first = 3 * std::size_t{blocks.vertex_begin[block]};
    const std::size_t count = blocks.vertex_begin[block + 1] - blocks.vertex_begin[block];
    if (blocks.doubles.empty()) {
        HWY_DYNAMIC_DISPATCH(place_floats)(&blocks.floats[first], count, &frame, &placed);
    } else {
        HWY_DYNAMIC_DISPATCH(place_doubles)(&blocks.doubles[first], count, &frame, &placed);
    }
}

bool mark_lines(TriangleAcross& triangle, const LineRows& lines, MarkedLines& marked) {
    return HWY_DYNAMIC_DISPATCH(mark_lines_on)(&triangle, &lines, &marked);
}

} // namespace cd

#endif
