// The children of two wide nodes: intervals that bound them in each other's frames, and which of
// them may overlap. Compiled for every target; wide_kernel.cpp has the bounds.

// Highway's guard: once for each target.
#if defined(CD_WIDE_SIDES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_WIDE_SIDES_INL_HPP
#undef CD_WIDE_SIDES_INL_HPP
#else
#define CD_WIDE_SIDES_INL_HPP
#endif

#include "common/tree/wide_kernel.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// No more lanes than a node has children.
using Floats = hn::CappedTag<float, wide_children_max>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;
using Row = hn::CappedTag<float, 4>;

constexpr std::size_t lanes = hn::MaxLanes(Floats());
constexpr std::size_t children = wide_children_max;
constexpr float whole_steps = 255;

/// The children of a node, or the node itself as the only one.
struct Side {
    const WideNode* node;
    bool is_whole;
    std::uint32_t first;
    std::uint32_t count;
};

/// Intervals of a side's children on the three axes of a frame.
struct Intervals {
    alignas(64) float low[3][children];
    alignas(64) float high[3][children];
};

/// How steps in one frame become steps in another: columns. Entries count half a step, for sums and
/// differences of two bounds.
struct Change {
    alignas(16) float entries[3][4];
    alignas(16) float sizes[3][4]; ///< Of the entries.
    alignas(16) float offset[4];
    alignas(16) float margin[4];
};

/// How lengths in a body's coordinates become steps in the other's frame: columns.
struct Turn {
    alignas(16) float entries[3][4];
};

HWY_INLINE V from_bytes(const WideNode::Bytes& bytes, std::size_t first) {
    const hn::Rebind<std::uint8_t, Floats> d8;
    const hn::RebindToSigned<Floats> di;
    return hn::ConvertTo(Floats(), hn::PromoteTo(di, hn::LoadU(d8, bytes.data() + first)));
}

/// The bounds of a lane's children on axis `k` of their own frame, in steps.
HWY_INLINE V low_of(const Side& side, std::size_t k, std::size_t lane) {
    return from_bytes(side.node->low[k], lane);
}
HWY_INLINE V high_of(const Side& side, std::size_t k, std::size_t lane) {
    return from_bytes(side.node->high[k], lane);
}

HWY_INLINE std::uint32_t bits_of(M mask) {
#if HWY_TARGET == HWY_AVX3
    return mask.raw; // Not by way of memory.
#else
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Floats(), mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
#endif
}

/// Where the other node sees the children; which of them may reach into its whole box.
HWY_INLINE std::uint32_t see(const Side& side, const Change& change, Intervals& seen) {
    const Floats d;
    const V end = hn::Set(d, whole_steps);
    std::uint32_t found = 0;
    for (std::size_t lane = 0; lane < side.count; lane += lanes) {
        const V low[3] = {low_of(side, 0, lane), low_of(side, 1, lane), low_of(side, 2, lane)};
        const V high[3] = {high_of(side, 0, lane), high_of(side, 1, lane), high_of(side, 2, lane)};
        const V middle[3] = {
            hn::Add(low[0], high[0]), hn::Add(low[1], high[1]), hn::Add(low[2], high[2])};
        const V size[3] = {
            hn::Sub(high[0], low[0]), hn::Sub(high[1], low[1]), hn::Sub(high[2], low[2])};
        M apart = hn::FirstN(d, 0);
        for (std::size_t k = 0; k < 3; ++k) {
            V at = hn::Set(d, change.offset[k]);
            V reach = hn::Set(d, change.margin[k]);
            for (std::size_t c = 0; c < 3; ++c) {
                at = hn::MulAdd(hn::Set(d, change.entries[c][k]), middle[c], at);
                reach = hn::MulAdd(hn::Set(d, change.sizes[c][k]), size[c], reach);
            }
            const V from = hn::Sub(at, reach);
            const V to = hn::Add(at, reach);
            hn::Store(from, d, seen.low[k] + lane);
            hn::Store(to, d, seen.high[k] + lane);
            apart = hn::Or(apart, hn::Or(hn::Gt(from, end), hn::Lt(to, hn::Zero(d))));
        }
        found |= bits_of(hn::Not(apart)) << lane;
    }
    return found & ((1u << side.count) - 1);
}

/// As `see`, of a node as its own only child.
HWY_INLINE std::uint32_t see_whole(const Change& change, Intervals& seen) {
    bool is_apart = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const float at =
            change.offset[k] +
            whole_steps * (change.entries[0][k] + change.entries[1][k] + change.entries[2][k]);
        const float reach =
            change.margin[k] +
            whole_steps * (change.sizes[0][k] + change.sizes[1][k] + change.sizes[2][k]);
        seen.low[k][0] = at - reach;
        seen.high[k][0] = at + reach;
        is_apart = is_apart || seen.low[k][0] > whole_steps || seen.high[k][0] < 0;
    }
    return is_apart ? 0 : 1;
}

#if HWY_TARGET == HWY_SCALAR || HWY_MAX_BYTES < 32

/// Too few lanes to look corners up in registers.
constexpr std::uint32_t vertices_max = 0;

HWY_INLINE std::uint32_t see_triangles(
    const WideBody&, const Side& side, const Turn&, const Change& change, Intervals& seen) {
    return see(side, change, seen);
}

#else

/// The most vertices of a block whose triangles are seen corner by corner: two vectors of sixteen
/// lanes hold as many of one coordinate, or two of eight half as many.
constexpr std::uint32_t vertices_max = 2 * lanes;

/// From a table of `vertices_max` numbers.
HWY_INLINE V look_up(V first, V second, hn::Vec<hn::RebindToSigned<Floats>> index) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    const auto lane = hn::IndicesFromVec(d, hn::And(index, hn::Set(di, int{lanes} - 1)));
    const auto is_first = hn::RebindMask(d, hn::Lt(index, hn::Set(di, int{lanes})));
    return hn::IfThenElse(
        is_first, hn::TableLookupLanes(first, lane), hn::TableLookupLanes(second, lane));
}

/// As `see`, with intervals around the triangles themselves instead of around their boxes.
HWY_INLINE std::uint32_t see_triangles(const WideBody& body,
                                       const Side& side,
                                       const Turn& turn,
                                       const Change& change,
                                       Intervals& seen) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    const std::uint32_t* begin = body.vertex_begin + side.node->first;
    const std::uint32_t vertices = begin[1] - begin[0];
    if (body.vertices == nullptr || vertices > vertices_max) {
        return see(side, change, seen);
    }
    // The vertices' coordinates in the other's frame.
    V at[3][2];
    for (std::size_t half = 0; half < 2; ++half) {
        if (half == 1 && vertices <= lanes) {
            at[0][1] = at[1][1] = at[2][1] = hn::Zero(d);
            break;
        }
        V x;
        V y;
        V z;
        hn::LoadInterleaved3(
            d, body.vertices + 3 * (std::size_t{begin[0]} + half * lanes), x, y, z);
        const auto& origin = side.node->origin;
        x = hn::Sub(x, hn::Set(d, static_cast<float>(origin[0])));
        y = hn::Sub(y, hn::Set(d, static_cast<float>(origin[1])));
        z = hn::Sub(z, hn::Set(d, static_cast<float>(origin[2])));
        for (std::size_t k = 0; k < 3; ++k) {
            V sum = hn::MulAdd(hn::Set(d, turn.entries[0][k]), x, hn::Set(d, change.offset[k]));
            sum = hn::MulAdd(hn::Set(d, turn.entries[1][k]), y, sum);
            at[k][half] = hn::MulAdd(hn::Set(d, turn.entries[2][k]), z, sum);
        }
    }
    const V end = hn::Set(d, whole_steps);
    const auto byte = hn::Set(di, 0xff);
    std::uint32_t found = 0;
    for (std::size_t lane = 0; lane < side.count; lane += lanes) {
        const auto corners = hn::LoadU(
            di, reinterpret_cast<const std::int32_t*>(body.corners + (side.first + lane)));
        const auto i0 = hn::And(corners, byte);
        const auto i1 = hn::And(hn::ShiftRight<8>(corners), byte);
        const auto i2 = hn::And(hn::ShiftRight<16>(corners), byte);
        M apart = hn::FirstN(d, 0);
        for (std::size_t k = 0; k < 3; ++k) {
            const V c0 = look_up(at[k][0], at[k][1], i0);
            const V c1 = look_up(at[k][0], at[k][1], i1);
            const V c2 = look_up(at[k][0], at[k][1], i2);
            const V margin = hn::Set(d, change.margin[k]);
            const V from = hn::Sub(hn::Min(hn::Min(c0, c1), c2), margin);
            const V to = hn::Add(hn::Max(hn::Max(c0, c1), c2), margin);
            hn::Store(from, d, seen.low[k] + lane);
            hn::Store(to, d, seen.high[k] + lane);
            apart = hn::Or(apart, hn::Or(hn::Gt(from, end), hn::Lt(to, hn::Zero(d))));
        }
        found |= bits_of(hn::Not(apart)) << lane;
    }
    return found & ((1u << side.count) - 1);
}

#endif

/// Writes the pairs of one child with those of the other node's from `their_first` on that the mask
/// names; how many.
template <bool kRowsOfA>
HWY_INLINE std::size_t
append(std::uint32_t own, std::uint32_t their_first, M found, std::uint32_t* to) {
#if HWY_TARGET == HWY_AVX3
    const hn::RebindToUnsigned<Floats> du;
    const auto theirs = hn::Compress(hn::Iota(du, their_first), hn::RebindMask(du, found));
    if constexpr (kRowsOfA) {
        hn::StoreInterleaved2(hn::Set(du, own), theirs, du, to);
    } else {
        hn::StoreInterleaved2(theirs, hn::Set(du, own), du, to);
    }
    return hn::CountTrue(Floats(), found);
#else
    // Few are found, and other targets have no such instruction.
    std::size_t count = 0;
    for (std::uint32_t bits = bits_of(found); bits != 0; bits &= bits - 1) {
        const std::uint32_t their = their_first + static_cast<std::uint32_t>(__builtin_ctz(bits));
        to[2 * count] = kRowsOfA ? own : their;
        to[2 * count + 1] = kRowsOfA ? their : own;
        ++count;
    }
    return count;
#endif
}

/// Writes the pairs of a row's child of one side with those of the other that may overlap it; how
/// many.
template <bool kRowsOfA>
HWY_INLINE std::size_t pair_up(const Side& one,
                               const Intervals& one_seen,
                               std::uint32_t rows,
                               const Side& others,
                               const Intervals& others_seen,
                               std::uint32_t* to) {
    const Floats d;
    Intervals own;
    for (std::size_t k = 0; k < 3; ++k) {
        if (one.is_whole) {
            own.low[k][0] = 0;
            own.high[k][0] = whole_steps;
            continue;
        }
        for (std::size_t lane = 0; lane < one.count; lane += lanes) {
            hn::Store(low_of(one, k, lane), d, own.low[k] + lane);
            hn::Store(high_of(one, k, lane), d, own.high[k] + lane);
        }
    }
    std::size_t count = 0;
    for (std::size_t lane = 0; lane < others.count; lane += lanes) {
        const V low[3] = {
            low_of(others, 0, lane), low_of(others, 1, lane), low_of(others, 2, lane)};
        const V high[3] = {
            high_of(others, 0, lane), high_of(others, 1, lane), high_of(others, 2, lane)};
        const auto left = static_cast<std::uint32_t>(others.count - lane);
        const M used = hn::FirstN(d, left < lanes ? left : lanes);
        for (std::uint32_t rest = rows; rest != 0; rest &= rest - 1) {
            const auto i = static_cast<std::uint32_t>(__builtin_ctz(rest));
            const auto apart_on = [&](std::size_t k) HWY_ATTR {
                const M in_one = hn::Or(
                    hn::Gt(hn::Load(d, others_seen.low[k] + lane), hn::Set(d, own.high[k][i])),
                    hn::Lt(hn::Load(d, others_seen.high[k] + lane), hn::Set(d, own.low[k][i])));
                const M in_others = hn::Or(hn::Lt(high[k], hn::Set(d, one_seen.low[k][i])),
                                           hn::Gt(low[k], hn::Set(d, one_seen.high[k][i])));
                return hn::Or(in_one, in_others);
            };
            const M apart = hn::Or(hn::Or(apart_on(0), apart_on(1)), apart_on(2));
            const M found = hn::AndNot(apart, used);
            const std::uint32_t their_first = others.first + static_cast<std::uint32_t>(lane);
            count += append<kRowsOfA>(one.first + i, their_first, found, to + 2 * count);
        }
    }
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
