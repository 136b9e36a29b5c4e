// With o, p the origins of the nodes of A and B, F and G their frames (rows, floats, exact
// numbers), R, t the true relative pose: x = R y + t holds of every point that both share. With
// alpha = F (x - o) and beta = G (y - p),
//     alpha = T + N beta,  beta = N^-1 (alpha - T),  N = F R G^-1,  T = F (R p + t - o).
// A child's box bounds one of alpha and beta; what it makes of the other is an interval on each
// axis. Children whose intervals are apart on any axis of either frame share no point.
//
// Bounds, with u = 2^-24, e = axes_error_max = 2 u, r = rotation_error, s = skew, w = R p + t - o,
// |.| the sum of sizes, E the largest coordinates, 255 steps on each axis, of a node.
// (1) w is formed in doubles: within abs = r |p| + translation_error + 2^-49 (|p| + |t| + |o|) in
//     each component; as a float within u |w| more.
// (2) T: three products with entries of at most 1.001, two sums: 5 u |w| + 1.8 abs.
// (3) M for N: |G^-1 - G'| and so on as in box_test.cpp: 3.01 (r + e). In floats, R takes u, its
//     product with G' 3 u, and F's with that 3 u, each times at most 3.03. Below 28 u + 3.01 r.
// (4) M' for N^-1: the squares of N's singular values are within 6.1 e + 3.01 s of 1, so
//     |N^-1 - M'| < 41 u + 3.1 (r + s). N^-1 T = G R^-1 w is formed as G R' w: R' for R^-1 costs
//     3.01 s |w|, R in doubles and then in floats 1.75 r |w| + u |w|, w as a float u |w|, two times
//     three products and two sums 6 u |w|; and w itself errs by abs, 1.8 abs in this direction.
//     Below 9 u |w| + 3.1 (r + s) |w| + 1.8 abs.
// (5) An interval T + M (c +- h), divided by the steps: an entry takes three roundings with the
//     quotient, T two; c and h are whole, sums of four take four, their difference one: within
//     12 u (1.74 |w| + 2 E).
// (6) Intervals of boxes. Of B's in A's frame, by (2), (3) and (5):
//         26 u |w| + 52 u E_b + 3.01 r E_b + 1.8 abs.
//     Of A's in B's, by (4) and (5):
//         30 u |w| + 65 u E_a + 3.1 (r + s) (|w| + E_a) + 1.8 abs.
// (7) Intervals of triangles, from their corners y (of B; of A likewise): alpha = T + F R (y - p),
//     beta = -G R^-1 w + G R^-1 (x - o). A leaf's origin and its vertices are floats, so y - p
//     takes one rounding of each component; |y - p| <= 1.74 E. An entry of F R: R as floats one,
//     three products and two sums three, the steps two roundings, each times 1.01, and 1.75 r; R'
//     for R^-1 another 3.01 s |x - o|. Products and sums four, the difference with the margin one:
//     together 12 u 1.74 E + (1.75 r + 3.01 s) 1.74 E, and what T has by (2), (4) and (5).
// (8) All are below 128 u (|w| + E_a + E_b) + 6 (r + s) (|w| + E_a + E_b) + 4 abs. `margin` is that
//     with its own few roundings, and those of |w|, covered. What underflow takes is below 2^-148
//     of a length or an entry, in steps below 2^-20; the margin is at least 255 * 2^-17 steps.
//
// Overflow: coordinates of a wide tree are below 2^50, so that boxes share a point only where |w|
// is below 2^55; steps are within [2^-70, 2^45]. Then all that is made of an interval stays below
// 2^127 or is a margin. So whatever else overflows belongs to boxes that are apart, an infinite
// margin parts nothing, and neither do comparisons with NaN.
#include "common/tree/wide_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/tree/wide_kernel.cpp"
#include <hwy/foreach_target.h>
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

using VRow = hn::Vec<Row>;
constexpr std::size_t row_lanes = hn::MaxLanes(Row());

/// The sum of three columns, each times its weight: the lanes from `i` on.
HWY_INLINE VRow combined(const float* columns, const float* weights, std::size_t i) {
    const Row d;
    VRow sum = hn::Mul(hn::Load(d, columns + i), hn::Set(d, weights[0]));
    sum = hn::MulAdd(hn::Load(d, columns + 4 + i), hn::Set(d, weights[1]), sum);
    return hn::MulAdd(hn::Load(d, columns + 8 + i), hn::Set(d, weights[2]), sum);
}

HWY_INLINE float absolute(float value) {
    return value < 0 ? -value : value;
}

/// What one node makes of coordinates in the other, whose steps count `per_step` (4 floats).
HWY_INLINE void finish_change(const float* columns,
                              const float* offset,
                              float margin,
                              const std::array<float, 4>& steps,
                              const float* per_step,
                              Change& change) {
    const Row d;
    for (std::size_t i = 0; i < 4; i += row_lanes) {
        const VRow scale = hn::Load(d, per_step + i);
        for (std::size_t c = 0; c < 3; ++c) {
            const VRow entry = hn::Mul(hn::Mul(hn::Load(d, columns + 4 * c + i), scale),
                                       hn::Set(d, 0.5F * steps[c]));
            hn::Store(entry, d, change.entries[c] + i);
            hn::Store(hn::Abs(entry), d, change.sizes[c] + i);
        }
        hn::Store(hn::Mul(hn::Load(d, offset + i), scale), d, change.offset + i);
        hn::Store(hn::Mul(hn::Set(d, margin), scale), d, change.margin + i);
    }
}

/// A pair of nodes on its way through a batch, with what both looks at it need.
struct Meeting {
    alignas(16) float columns[3][4]; ///< M: of B's coordinates in A's.
    alignas(16) float offset_a[4];   ///< -N^-1 T.
    alignas(16) float offset_b[4];   ///< T.
    alignas(16) float per_step_a[4];
    alignas(16) float per_step_b[4];
    float margin;
    WidePair nodes;
};

HWY_INLINE void
meet(const WidePose& pose, const WideNode& a, const WideNode& b, WidePair nodes, Meeting& to) {
    const Row d;
    to.nodes = nodes;
    float w[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const double* row = &pose.rotation[3 * i];
        w[i] = static_cast<float>((row[0] * b.origin[0] + row[1] * b.origin[1]) +
                                  (row[2] * b.origin[2] + (pose.translation[i] - a.origin[i])));
    }
    const float back[3] = {-w[0], -w[1], -w[2]};
    const float* frame_a = a.columns[0].data();
    alignas(16) float turned_back[4];
    for (std::size_t i = 0; i < 4; i += row_lanes) {
        hn::Store(combined(pose.rows[0].data(), back, i), d, turned_back + i);
        hn::Store(combined(frame_a, w, i), d, to.offset_b + i);
        hn::Store(hn::Div(hn::Set(d, 1), hn::LoadU(d, a.steps.data() + i)), d, to.per_step_a + i);
        hn::Store(hn::Div(hn::Set(d, 1), hn::LoadU(d, b.steps.data() + i)), d, to.per_step_b + i);
    }
    alignas(16) float turned[3][4];
    for (std::size_t k = 0; k < 3; ++k) {
        const float row[3] = {b.columns[0][k], b.columns[1][k], b.columns[2][k]};
        for (std::size_t i = 0; i < 4; i += row_lanes) {
            hn::Store(combined(pose.columns[0].data(), row, i), d, turned[k] + i);
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 4; i += row_lanes) {
            hn::Store(combined(frame_a, turned[k], i), d, to.columns[k] + i);
        }
    }
    for (std::size_t i = 0; i < 4; i += row_lanes) {
        hn::Store(combined(b.columns[0].data(), turned_back, i), d, to.offset_a + i);
    }
    const float steps =
        (a.steps[0] + a.steps[1] + a.steps[2]) + (b.steps[0] + b.steps[1] + b.steps[2]);
    const float apart = absolute(w[0]) + absolute(w[1]) + absolute(w[2]);
    to.margin = pose.relative_margin * (apart + whole_steps * steps) + pose.absolute_margin;
}

HWY_INLINE Side side_of(const WideNode& node, std::uint32_t index, bool is_whole) {
    if (is_whole) {
        return {&node, true, index, 1};
    }
    return {&node, false, node.is_leaf ? node.first * block_size : node.first, node.count};
}

/// From a body's coordinates to the frame whose columns are given, in its steps.
HWY_INLINE void
make_turn(const float* frame, const float* rotation, const float* per_step, Turn& to) {
    const Row d;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < 4; i += row_lanes) {
            const VRow column = combined(frame, rotation + 4 * c, i);
            hn::Store(hn::Mul(column, hn::Load(d, per_step + i)), d, to.entries[c] + i);
        }
    }
}

template <bool kBothLeaves>
HWY_INLINE std::uint32_t see_b(const WidePose& pose,
                               const WideBody& body,
                               const WideNode& a,
                               const Side& side_b,
                               const Meeting& meeting,
                               Intervals& seen) {
    Change change;
    finish_change(meeting.columns[0],
                  meeting.offset_b,
                  meeting.margin,
                  side_b.node->steps,
                  meeting.per_step_a,
                  change);
    if constexpr (!kBothLeaves) {
        return side_b.is_whole ? see_whole(change, seen) : see(side_b, change, seen);
    }
    Turn turn;
    make_turn(a.columns[0].data(), pose.columns[0].data(), meeting.per_step_a, turn);
    return see_triangles(body, side_b, turn, change, seen);
}

template <bool kBothLeaves>
HWY_INLINE std::uint32_t see_a(const WidePose& pose,
                               const WideBody& body,
                               const WideNode& b,
                               const Side& side_a,
                               const Meeting& meeting,
                               Intervals& seen) {
    alignas(16) float rows[3][4];
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            rows[i][k] = meeting.columns[k][i];
        }
        rows[i][3] = 0;
    }
    Change change;
    finish_change(
        rows[0], meeting.offset_a, meeting.margin, side_a.node->steps, meeting.per_step_b, change);
    if constexpr (!kBothLeaves) {
        return side_a.is_whole ? see_whole(change, seen) : see(side_a, change, seen);
    }
    Turn turn;
    make_turn(b.columns[0].data(), pose.rows[0].data(), meeting.per_step_b, turn);
    return see_triangles(body, side_a, turn, change, seen);
}

/// Writes what is left of a pair of nodes; how many pairs.
template <bool kBothLeaves>
HWY_INLINE std::size_t
visit(const WidePose& pose, WideWalk& walk, const Meeting& meeting, std::uint32_t* to) {
    const WidePair now = meeting.nodes;
    const WideNode& a = walk.a.nodes[now.a];
    const WideNode& b = walk.b.nodes[now.b];
    // A leaf waits until the other is one.
    const Side side_a = side_of(a, now.a, !kBothLeaves && a.is_leaf);
    const Side side_b = side_of(b, now.b, !kBothLeaves && b.is_leaf);
    Intervals seen_b;
    walk.box_tests += side_b.count;
    const std::uint32_t in_a = see_b<kBothLeaves>(pose, walk.b, a, side_b, meeting, seen_b);
    if (in_a == 0) {
        return 0;
    }
    Intervals seen_a;
    walk.box_tests += side_a.count;
    const std::uint32_t in_b = see_a<kBothLeaves>(pose, walk.a, b, side_a, meeting, seen_a);
    if (in_b == 0) {
        return 0;
    }
    const auto rows_a = static_cast<std::size_t>(__builtin_popcount(in_b));
    const auto rows_b = static_cast<std::size_t>(__builtin_popcount(in_a));
    if (side_a.is_whole || (rows_a <= rows_b && !side_b.is_whole)) {
        walk.box_tests += rows_a * side_b.count;
        return pair_up<true>(side_a, seen_a, in_b, side_b, seen_b, to);
    }
    walk.box_tests += rows_b * side_a.count;
    return pair_up<false>(side_b, seen_b, in_a, side_a, seen_a, to);
}

HWY_INLINE void prefetch(const void* from, std::size_t bytes) {
    const auto* line = static_cast<const char*>(from);
    for (std::size_t i = 0; i < bytes; i += 64) {
        __builtin_prefetch(line + i);
    }
}

/// Asks for the triangles of a leaf, of which most have at least so many vertices.
HWY_INLINE void prefetch_triangles(const WideBody& body, const WideNode& leaf) {
    if (body.vertices != nullptr) {
        prefetch(body.vertices + 3 * std::size_t{body.vertex_begin[leaf.first]},
                 children * 3 * sizeof(float));
        prefetch(body.corners + std::size_t{block_size} * leaf.first,
                 children * sizeof(BlockCorners));
    }
}

// Pairs of one batch do not wait for each other: their nodes come from memory at the same time, and
// the processor works on more than one. Pairs of leaves are put aside until there are enough of
// them, so that it can foresee what is done with each.

/// Looks at some of the pairs that wait.
HWY_INLINE void visit_inner(const WidePose& pose, WideWalk& walk) {
    Meeting meetings[wide_batch_max];
    const std::size_t count = walk.waiting_count < walk.batch ? walk.waiting_count : walk.batch;
    walk.waiting_count -= count;
    const WidePair* now = walk.waiting + walk.waiting_count;
    for (std::size_t i = 0; i < count; ++i) {
        prefetch(walk.a.nodes + now[i].a, sizeof(WideNode));
        prefetch(walk.b.nodes + now[i].b, sizeof(WideNode));
    }
    std::size_t inner = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const WideNode& a = walk.a.nodes[now[i].a];
        const WideNode& b = walk.b.nodes[now[i].b];
        if (a.is_leaf && b.is_leaf) {
            prefetch_triangles(walk.a, a);
            prefetch_triangles(walk.b, b);
            walk.leaves[walk.leaf_count++] = now[i];
        } else {
            meet(pose, a, b, now[i], meetings[inner++]);
        }
    }
    for (std::size_t i = 0; i < inner; ++i) {
        auto* to = reinterpret_cast<std::uint32_t*>(walk.waiting + walk.waiting_count);
        walk.waiting_count += visit<false>(pose, walk, meetings[i], to);
    }
    walk.visits_left -=
        inner < walk.visits_left ? static_cast<std::uint32_t>(inner) : walk.visits_left;
}

/// Looks at some of the pairs of leaves.
HWY_INLINE void visit_leaves(const WidePose& pose, WideWalk& walk) {
    Meeting meetings[wide_batch_max];
    const std::size_t count = walk.leaf_count < wide_batch_max ? walk.leaf_count : wide_batch_max;
    walk.leaf_count -= count;
    for (std::size_t i = 0; i < count; ++i) {
        const WidePair now = walk.leaves[walk.leaf_count + i];
        meet(pose, walk.a.nodes[now.a], walk.b.nodes[now.b], now, meetings[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
        auto* to = reinterpret_cast<std::uint32_t*>(walk.candidates + walk.candidate_count);
        walk.candidate_count += visit<true>(pose, walk, meetings[i], to);
    }
    walk.visits_left -=
        count < walk.visits_left ? static_cast<std::uint32_t>(count) : walk.visits_left;
}

void walk_all(const WidePose& pose, WideWalk& walk) {
    while (walk.visits_left > 0 && walk.candidate_count < walk.candidates_wanted &&
           walk.waiting_count + wide_pairs_slack <= walk.waiting_room) {
        if (walk.leaf_count >= walk.leaves_at_once ||
            (walk.waiting_count == 0 && walk.leaf_count > 0)) {
            visit_leaves(pose, walk);
        } else if (walk.waiting_count > 0) {
            visit_inner(pose, walk);
        } else {
            return;
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(walk_all);

void walk_wide(const WidePose& pose, WideWalk& walk) {
    HWY_DYNAMIC_DISPATCH(walk_all)(pose, walk);
}

} // namespace cd

#endif
