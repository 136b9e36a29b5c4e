// Bounds the children of a wide node by intervals in another node's frame. Compiled for every
// target; wide_kernel.cpp derives the margins.

// Highway's include guard: it admits the file once for each target.
#if defined(CD_WIDE_SIDES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_WIDE_SIDES_INL_HPP
#undef CD_WIDE_SIDES_INL_HPP
#else
#define CD_WIDE_SIDES_INL_HPP
#endif

#include "common/tree/wide/wide_kernel.hpp"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A vector has at most as many lanes as a node has children.
using Floats = hn::CappedTag<float, wide_children_max>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;
using Row = hn::CappedTag<float, 4>;

constexpr std::size_t lanes = hn::MaxLanes(Floats());
constexpr std::size_t children = wide_children_max;
constexpr float whole_steps = 255;

/// The children of a node, or the node itself as its own only child (`is_whole`).
struct Side {
    const WideNode* node;
    const WideNode::Bytes* low; ///< Bounds of the children, indexed by axis.
    const WideNode::Bytes* high;
    bool is_whole;
    std::uint32_t first;
    std::uint32_t count;
};

/// The bounds, in steps, of a node treated as its own only child.
struct WholeBounds {
    std::array<WideNode::Bytes, 3> low{};
    std::array<WideNode::Bytes, 3> high{WideNode::Bytes{255}, {255}, {255}};
};
inline constexpr WholeBounds whole_bounds;

HWY_INLINE Side side_of(const WideNode& node, std::uint32_t index, bool is_whole) {
    if (is_whole) {
        return {&node, whole_bounds.low.data(), whole_bounds.high.data(), true, index, 1};
    }
    const std::uint32_t first = node.is_leaf ? node.first * block_size : node.first;
    return {&node, node.low.data(), node.high.data(), false, first, node.count};
}

/// Intervals of a side's children on the three axes of a frame.
struct Intervals {
    alignas(64) float low[3][children];
    alignas(64) float high[3][children];
};

/// A linear map from steps in one frame to steps in another. Entries are halved, because the map is
/// applied to sums and differences of a child's two bounds.
template <bool kByAxis>
struct Change {
    alignas(
        16) float entries[3][4];   ///< By axis of the other frame if `kByAxis`; otherwise columns.
    alignas(16) float sizes[3][4]; ///< Absolute values of the entries.
    alignas(16) float offset[4];   ///< In steps of the other frame, like `margin`.
    alignas(16) float margin[4];

    /// Returns the contribution of coordinate `c` to axis `k`.
    [[nodiscard]] HWY_INLINE float entry(std::size_t c, std::size_t k) const {
        return kByAxis ? entries[k][c] : entries[c][k];
    }
    [[nodiscard]] HWY_INLINE float size(std::size_t c, std::size_t k) const {
        return kByAxis ? sizes[k][c] : sizes[c][k];
    }
};

/// A linear map from a body's coordinates to steps in the other node's frame, by columns.
struct Turn {
    alignas(16) float entries[3][4];
};

HWY_INLINE V from_bytes(const std::uint8_t* bytes) {
    const hn::Rebind<std::uint8_t, Floats> d8;
    const hn::RebindToSigned<Floats> di;
    return hn::ConvertTo(Floats(), hn::PromoteTo(di, hn::LoadU(d8, bytes)));
}

/// Returns the lower bounds, in steps, of the children from `lane` on, on axis `k` of their frame.
HWY_INLINE V low_of(const Side& side, std::size_t k, std::size_t lane) {
    return from_bytes(side.low[k].data() + lane);
}
HWY_INLINE V high_of(const Side& side, std::size_t k, std::size_t lane) {
    return from_bytes(side.high[k].data() + lane);
}

HWY_INLINE std::uint32_t bits_of(M mask) {
#if HWY_TARGET == HWY_AVX3
    return mask.raw; // Avoids a round trip through memory.
#else
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Floats(), mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
#endif
}

HWY_INLINE std::uint32_t children_mask(const Side& side) {
    return (1u << side.count) - 1;
}

/// Returns the least of the first `count` numbers.
HWY_INLINE float least_of(const float* numbers, std::uint32_t count) {
    float least = numbers[0];
    for (std::uint32_t i = 1; i < count; ++i) {
        least = std::min(least, numbers[i]);
    }
    return least;
}

/// Returns a bit mask of the numbers, of the first `count`, that are not above a limit.
HWY_INLINE std::uint32_t not_above(const float* numbers, std::uint32_t count, float limit) {
    const Floats d;
    std::uint32_t found = 0;
    for (std::size_t lane = 0; lane < children; lane += lanes) {
        found |= bits_of(hn::Not(hn::Gt(hn::Load(d, numbers + lane), hn::Set(d, limit)))) << lane;
    }
    return found & ((1u << count) - 1);
}

/// Computes the intervals of the children in the other node's frame and returns the mask of
/// children that may overlap the other node's whole box.
template <bool kByAxis>
HWY_INLINE std::uint32_t see(const Side& side, const Change<kByAxis>& change, Intervals& seen) {
    const Floats d;
    const V end = hn::Set(d, whole_steps);
    std::uint32_t found = 0;
    HWY_UNROLL(4)
    for (std::size_t lane = 0; lane < children; lane += lanes) {
        const V low[3] = {low_of(side, 0, lane), low_of(side, 1, lane), low_of(side, 2, lane)};
        const V high[3] = {high_of(side, 0, lane), high_of(side, 1, lane), high_of(side, 2, lane)};
        const V middle[3] = {
            hn::Add(low[0], high[0]), hn::Add(low[1], high[1]), hn::Add(low[2], high[2])};
        const V size[3] = {
            hn::Sub(high[0], low[0]), hn::Sub(high[1], low[1]), hn::Sub(high[2], low[2])};
        M apart = hn::FirstN(d, 0);
        HWY_UNROLL(3)
        for (std::size_t k = 0; k < 3; ++k) {
            V at = hn::Set(d, change.offset[k]);
            V reach = hn::Set(d, change.margin[k]);
            HWY_UNROLL(3)
            for (std::size_t c = 0; c < 3; ++c) {
                at = hn::MulAdd(hn::Set(d, change.entry(c, k)), middle[c], at);
                reach = hn::MulAdd(hn::Set(d, change.size(c, k)), size[c], reach);
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

/// Like `see`, for a node that counts as its own only child.
template <bool kByAxis>
HWY_INLINE std::uint32_t see_whole(const Change<kByAxis>& change, Intervals& seen) {
    bool is_apart = false;
    HWY_UNROLL(3)
    for (std::size_t k = 0; k < 3; ++k) {
        const float at = change.offset[k] + whole_steps * (change.entry(0, k) + change.entry(1, k) +
                                                           change.entry(2, k));
        const float reach =
            change.margin[k] +
            whole_steps * (change.size(0, k) + change.size(1, k) + change.size(2, k));
        seen.low[k][0] = at - reach;
        seen.high[k][0] = at + reach;
        is_apart = is_apart || seen.low[k][0] > whole_steps || seen.high[k][0] < 0;
    }
    return is_apart ? 0 : 1;
}

#if HWY_TARGET == HWY_SCALAR || HWY_MAX_BYTES < 32

/// Zero, because the vectors have too few lanes for look-ups of corners in registers.
constexpr std::uint32_t vertices_max = 0;

template <bool kByAxis>
HWY_INLINE std::uint32_t see_triangles(const WideBody&,
                                       const Side& side,
                                       const Turn&,
                                       const Change<kByAxis>& change,
                                       Intervals& seen) {
    return see(side, change, seen);
}

/// Projects no triangles, because the vectors have too few lanes.
HWY_INLINE bool project_triangles(const WideBody&, const Side&, const float*, float, float*) {
    return false;
}

#else

/// The most vertices of a block whose triangles are bounded corner by corner: two SIMD vectors hold
/// this many values of one coordinate.
constexpr std::uint32_t vertices_max = 2 * lanes;

/// One number for each of up to `kHalves * lanes` vertices.
template <std::size_t kHalves>
struct Table {
    V numbers[kHalves];

    [[nodiscard]] HWY_INLINE V at(hn::Vec<hn::RebindToSigned<Floats>> index) const {
        const Floats d;
        const hn::RebindToSigned<Floats> di;
        if constexpr (kHalves == 1) {
            return hn::TableLookupLanes(numbers[0], hn::IndicesFromVec(d, index));
        } else {
#if HWY_TARGET == HWY_AVX3
            return V{_mm512_permutex2var_ps(numbers[0].raw, index.raw, numbers[1].raw)};
#else
            const auto lane = hn::IndicesFromVec(d, hn::And(index, hn::Set(di, int{lanes} - 1)));
            const auto is_first = hn::RebindMask(d, hn::Lt(index, hn::Set(di, int{lanes})));
            return hn::IfThenElse(is_first,
                                  hn::TableLookupLanes(numbers[0], lane),
                                  hn::TableLookupLanes(numbers[1], lane));
#endif
        }
    }
};

/// Loads as many vertices as there are lanes, relative to an origin.
HWY_INLINE void
load_vertices(const float* vertices, const std::array<double, 3>& origin, V& x, V& y, V& z) {
    const Floats d;
    hn::LoadInterleaved3(d, vertices, x, y, z);
    x = hn::Sub(x, hn::Set(d, static_cast<float>(origin[0])));
    y = hn::Sub(y, hn::Set(d, static_cast<float>(origin[1])));
    z = hn::Sub(z, hn::Set(d, static_cast<float>(origin[2])));
}

HWY_INLINE void
load_vertices(const double* vertices, const std::array<double, 3>& origin, V& x, V& y, V& z) {
    const Floats d;
    const hn::Half<Floats> half;
    const hn::Rebind<double, hn::Half<Floats>> dd;
    hn::Vec<decltype(dd)> low[3];
    hn::Vec<decltype(dd)> high[3];
    hn::LoadInterleaved3(dd, vertices, low[0], low[1], low[2]);
    hn::LoadInterleaved3(dd, vertices + 3 * hn::MaxLanes(dd), high[0], high[1], high[2]);
    const auto narrowed = [&](std::size_t k) HWY_ATTR {
        const auto from = hn::Set(dd, origin[k]);
        return hn::Combine(d,
                           hn::DemoteTo(half, hn::Sub(high[k], from)),
                           hn::DemoteTo(half, hn::Sub(low[k], from)));
    };
    x = narrowed(0);
    y = narrowed(1);
    z = narrowed(2);
}

/// Computes what `see` does, with intervals around triangles instead of around their boxes. The
/// triangles' block has at most `kHalves * lanes` vertices, from `vertices` on.
template <std::size_t kHalves, class T, bool kByAxis>
HWY_INLINE std::uint32_t see_corners(const T* vertices,
                                     const BlockCorners* corners,
                                     const Side& side,
                                     const Turn& turn,
                                     const Change<kByAxis>& change,
                                     Intervals& seen) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    // The vertices' coordinates in the other node's frame, in steps.
    Table<kHalves> seen_at[3];
    HWY_UNROLL(2)
    for (std::size_t half = 0; half < kHalves; ++half) {
        V x;
        V y;
        V z;
        load_vertices(vertices + 3 * half * lanes, side.node->origin, x, y, z);
        HWY_UNROLL(3)
        for (std::size_t k = 0; k < 3; ++k) {
            V sum = hn::MulAdd(hn::Set(d, turn.entries[0][k]), x, hn::Set(d, change.offset[k]));
            sum = hn::MulAdd(hn::Set(d, turn.entries[1][k]), y, sum);
            seen_at[k].numbers[half] = hn::MulAdd(hn::Set(d, turn.entries[2][k]), z, sum);
        }
    }
    const V end = hn::Set(d, whole_steps);
    const auto byte = hn::Set(di, 0xff);
    std::uint32_t found = 0;
    HWY_UNROLL(4)
    for (std::size_t lane = 0; lane < children; lane += lanes) {
        const auto all = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(corners + lane));
        const auto i0 = hn::And(all, byte);
        const auto i1 = hn::And(hn::ShiftRight<8>(all), byte);
        const auto i2 = hn::And(hn::ShiftRight<16>(all), byte);
        M apart = hn::FirstN(d, 0);
        HWY_UNROLL(3)
        for (std::size_t k = 0; k < 3; ++k) {
            const V c0 = seen_at[k].at(i0);
            const V c1 = seen_at[k].at(i1);
            const V c2 = seen_at[k].at(i2);
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

/// Computes what `see` does, with intervals around the triangles themselves if their block has at
/// most `vertices_max` vertices.
template <bool kByAxis>
HWY_INLINE std::uint32_t see_triangles(const WideBody& body,
                                       const Side& side,
                                       const Turn& turn,
                                       const Change<kByAxis>& change,
                                       Intervals& seen) {
    const std::uint32_t* begin = body.vertex_begin + side.node->first;
    const std::uint32_t count = begin[1] - begin[0];
    if (count > vertices_max) {
        return see(side, change, seen);
    }
    const BlockCorners* corners = body.corners + side.first;
    const auto see_them = [&](const auto* vertices) HWY_ATTR {
        return count <= lanes ? see_corners<1>(vertices, corners, side, turn, change, seen)
                              : see_corners<2>(vertices, corners, side, turn, change, seen);
    };
    const std::size_t first = 3 * std::size_t{begin[0]};
    return body.floats != nullptr ? see_them(body.floats + first) : see_them(body.doubles + first);
}

/// Computes for each triangle of a leaf the least product of `direction` and a corner relative to
/// the node's origin, plus `offset`.
template <class T>
HWY_INLINE void project_corners(const T* vertices,
                                std::size_t count,
                                const BlockCorners* corners,
                                const Side& side,
                                const float* direction,
                                float offset,
                                float* least) {
    const Floats d;
    alignas(64) float at[block_vertices_max + lanes];
    for (std::size_t i = 0; i < count; i += lanes) {
        V x;
        V y;
        V z;
        load_vertices(vertices + 3 * i, side.node->origin, x, y, z);
        V sum = hn::MulAdd(hn::Set(d, direction[0]), x, hn::Set(d, offset));
        sum = hn::MulAdd(hn::Set(d, direction[1]), y, sum);
        hn::Store(hn::MulAdd(hn::Set(d, direction[2]), z, sum), d, at + i);
    }
    for (std::size_t i = 0; i < side.count; ++i) {
        const BlockCorners& of = corners[i];
        least[i] = std::min(std::min(at[of[0]], at[of[1]]), at[of[2]]);
    }
}

HWY_INLINE bool project_triangles(
    const WideBody& body, const Side& side, const float* direction, float offset, float* least) {
    const std::uint32_t* begin = body.vertex_begin + side.node->first;
    const std::size_t count = begin[1] - begin[0];
    const std::size_t first = 3 * std::size_t{begin[0]};
    const BlockCorners* corners = body.corners + side.first;
    const auto project_them = [&](const auto* vertices) HWY_ATTR {
        project_corners(vertices, count, corners, side, direction, offset, least);
    };
    if (body.floats != nullptr) {
        project_them(body.floats + first);
    } else {
        project_them(body.doubles + first);
    }
    return true;
}

#endif

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
