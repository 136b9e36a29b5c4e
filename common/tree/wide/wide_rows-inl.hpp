// Finds the pairs of children of two wide nodes that may overlap. Compiled for every target.

// Highway's include guard: it admits the file once for each target.
#if defined(CD_WIDE_ROWS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_WIDE_ROWS_INL_HPP
#undef CD_WIDE_ROWS_INL_HPP
#else
#define CD_WIDE_ROWS_INL_HPP
#endif

#include "common/tree/wide/pair_buckets.hpp"
#include "common/tree/wide/wide_sides-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

/// Bytes as floats: a look-up of single bytes is faster than their conversion.
struct ByteTable {
    std::array<float, 256> values{};

    constexpr ByteTable() {
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<float>(i);
        }
    }
};
inline constexpr ByteTable bytes_as_floats;

/// The children of one of the two nodes of a pair.
struct RowSide {
    const Side& children;
    const Intervals& seen; ///< Intervals of the children in the other node's frame.
    std::uint32_t found;   ///< Bit mask of the children that may overlap the other node.
    const float* least;    ///< Of the children, against the pose's direction (`project`).
};

/// Makes a square of a gap a lower bound: (10) of wide_kernel.cpp.
constexpr float gap_square_factor = 1 - 0x1p-14F;

/// The rank of pairs of children for each row and lane, as pair_buckets.hpp defines it.
struct Ranks {
    alignas(64) std::int32_t of[children][children];
};

/// Returns the distance between the centres of two intervals, divided by the sum of their half
/// widths: 0 if the centres coincide, 1 if the intervals barely meet.
HWY_INLINE V distance_ratio(V low, V high, V other_low, V other_high) {
    const V apart = hn::Abs(hn::Sub(hn::Add(low, high), hn::Add(other_low, other_high)));
    return hn::Div(apart, hn::Add(hn::Sub(high, low), hn::Sub(other_high, other_low)));
}

/// What `find_rows` computes beside the pairs that may overlap.
enum class Rating {
    None,
    Overlap, ///< Ranks by how far boxes overlap (PairBuckets).
    Gap,     ///< Ranks by a lower bound on the boxes' distance (WidePose::rank_base). Pairs beyond
             ///< the reach are left out, also if they are so on no single axis.
};

/// Adds to `square` the square of the gap between two intervals on one axis, as a length; `low` and
/// `high` are wider by `reach`.
HWY_INLINE V add_gap(V square, V low, V high, V other_low, V other_high, float step, float reach) {
    const Floats d;
    const V apart = hn::Max(hn::Sub(low, other_high), hn::Sub(other_low, high));
    const V gap = hn::Max(hn::MulAdd(apart, hn::Set(d, step), hn::Set(d, reach)), hn::Zero(d));
    return hn::MulAdd(gap, gap, square);
}

/// Writes to `found`, for each found child of `one` in turn, the mask of the children of `others`
/// that may overlap that child. Writes the ranks of these pairs as well, if there is a rating.
template <Rating kRating>
HWY_INLINE void find_rows(const RowSide& one,
                          const RowSide& others,
                          const WidePose& pose,
                          float widened,
                          std::uint32_t* found,
                          Ranks* ranks) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    const auto own = [](const WideNode::Bytes& bytes, std::size_t i)
                         HWY_ATTR { return hn::Set(Floats(), bytes_as_floats.values[bytes[i]]); };
    HWY_UNROLL(4)
    for (std::size_t lane = 0; lane < children; lane += lanes) {
        V low[3];
        V high[3];
        V seen_low[3];
        V seen_high[3];
        HWY_UNROLL(3)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = low_of(others.children, k, lane);
            high[k] = high_of(others.children, k, lane);
            seen_low[k] = hn::Load(d, others.seen.low[k] + lane);
            seen_high[k] = hn::Load(d, others.seen.high[k] + lane);
        }
        std::size_t row = 0;
        for (std::uint32_t rest = one.found; rest != 0; rest &= rest - 1) {
            const auto i = static_cast<std::size_t>(__builtin_ctz(rest));
            M apart = hn::FirstN(d, 0);
            V ratio = hn::Zero(d);
            V square_in_one = hn::Zero(d);
            V square_in_others = hn::Zero(d);
            HWY_UNROLL(3)
            for (std::size_t k = 0; k < 3; ++k) {
                const V own_low = own(one.children.low[k], i);
                const V own_high = own(one.children.high[k], i);
                const V one_low = hn::Set(d, one.seen.low[k][i]);
                const V one_high = hn::Set(d, one.seen.high[k][i]);
                if constexpr (kRating != Rating::Gap) {
                    const M in_one =
                        hn::Or(hn::Gt(seen_low[k], own_high), hn::Lt(seen_high[k], own_low));
                    const M in_others = hn::Or(hn::Lt(high[k], one_low), hn::Gt(low[k], one_high));
                    apart = hn::Or(apart, hn::Or(in_one, in_others));
                } else {
                    const float step_one = one.children.node->steps[k];
                    const float step_others = others.children.node->steps[k];
                    square_in_one = add_gap(square_in_one,
                                            seen_low[k],
                                            seen_high[k],
                                            own_low,
                                            own_high,
                                            step_one,
                                            pose.reach);
                    square_in_others = add_gap(square_in_others,
                                               one_low,
                                               one_high,
                                               low[k],
                                               high[k],
                                               step_others,
                                               pose.reach);
                }
                if constexpr (kRating == Rating::Overlap) {
                    ratio = hn::Max(ratio,
                                    distance_ratio(seen_low[k], seen_high[k], own_low, own_high));
                    ratio = hn::Max(ratio, distance_ratio(low[k], high[k], one_low, one_high));
                }
            }
            if constexpr (kRating == Rating::Gap) {
                const V along = hn::Max(hn::Add(hn::Load(d, others.least + lane),
                                                hn::Set(d, one.least[i] + pose.reach - widened)),
                                        hn::Zero(d));
                const V square = hn::Mul(
                    hn::Max(hn::Max(square_in_one, square_in_others), hn::Mul(along, along)),
                    hn::Set(d, gap_square_factor));
                apart = hn::Gt(square, hn::Set(d, pose.reach * pose.reach));
                const auto exponents = hn::ShiftRight<rank_shift>(hn::BitCast(di, square));
                hn::Store(
                    hn::Sub(exponents, hn::Set(di, pose.rank_base)), di, ranks->of[row] + lane);
            }
            if constexpr (kRating == Rating::Overlap) {
                const V scaled = hn::Mul(ratio, hn::Set(d, float{PairBuckets::count}));
                hn::Store(hn::ConvertTo(di, scaled), di, ranks->of[row] + lane);
            }
            const std::uint32_t before = lane == 0 ? 0 : found[row];
            found[row++] = before | bits_of(hn::Not(apart)) << lane;
        }
    }
}

/// Writes to `to` the pairs of child `own` with the other side's children whose bits are set in
/// `found`; bit 0 is child `their_first`. Returns the number of pairs.
HWY_INLINE std::size_t append(bool is_of_a,
                              std::uint32_t own,
                              std::uint32_t their_first,
                              std::uint32_t found,
                              std::uint32_t* to) {
#if HWY_TARGET == HWY_AVX3
    using All = hn::RebindToUnsigned<Floats>;
    const All du;
    const hn::Half<All> dh;
    const auto theirs = hn::Compress(hn::Add(hn::Iota(du, 0), hn::Set(du, their_first)),
                                     hn::Mask<All>{static_cast<__mmask16>(found)});
    const auto store = [&](hn::Vec<hn::Half<All>> their, std::uint32_t* pairs) HWY_ATTR {
        const auto ours = hn::Set(dh, own);
        const hn::Mask<hn::Half<All>> all{static_cast<__mmask8>(is_of_a ? 0xff : 0)};
        hn::StoreInterleaved2(
            hn::IfThenElse(all, ours, their), hn::IfThenElse(all, their, ours), dh, pairs);
    };
    const auto count = static_cast<std::size_t>(__builtin_popcount(found));
    store(hn::LowerHalf(dh, theirs), to);
    if (count > children / 2) {
        store(hn::UpperHalf(dh, theirs), to + children);
    }
    return count;
#else
    // The loop suits few bits, and other targets lack a compress instruction.
    std::size_t count = 0;
    const std::size_t ours = is_of_a ? 0 : 1;
    for (; found != 0; found &= found - 1) {
        to[2 * count + ours] = own;
        to[2 * count + 1 - ours] = their_first + static_cast<std::uint32_t>(__builtin_ctz(found));
        ++count;
    }
    return count;
#endif
}

/// Writes the pairs of children that may overlap, row by row of `one`. Returns their number.
template <Rating kRating>
HWY_INLINE std::size_t pair_up(const RowSide& one,
                               const RowSide& others,
                               bool one_is_a,
                               const WidePose& pose,
                               float widened,
                               std::uint32_t* to) {
    std::uint32_t found[children];
    Ranks ranks;
    find_rows<kRating>(one, others, pose, widened, found, &ranks);
    std::size_t count = 0;
    std::size_t row = 0;
    for (std::uint32_t rest = one.found; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::uint32_t>(__builtin_ctz(rest));
        count += append(one_is_a,
                        one.children.first + i,
                        others.children.first,
                        found[row++] & others.found,
                        to + 2 * count);
    }
    return count;
}

/// Pushes the pairs of children that may overlap to the queue, by their ranks.
template <Rating kRating>
HWY_INLINE void rank_pairs(const RowSide& one,
                           const RowSide& others,
                           bool one_is_a,
                           const WidePose& pose,
                           float widened,
                           PairBuckets& to) {
    std::uint32_t found[children];
    Ranks ranks;
    find_rows<kRating>(one, others, pose, widened, found, &ranks);
    std::size_t row = 0;
    for (std::uint32_t rest = one.found; rest != 0; rest &= rest - 1, ++row) {
        const std::uint32_t own =
            one.children.first + static_cast<std::uint32_t>(__builtin_ctz(rest));
        for (std::uint32_t bits = found[row] & others.found; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::uint32_t>(__builtin_ctz(bits));
            const std::uint32_t theirs = others.children.first + lane;
            to.push(one_is_a ? WidePair{own, theirs} : WidePair{theirs, own}, ranks.of[row][lane]);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
