// With the edges p, q of A at a0, the edges r, s of B at b0, all in A's coordinates, and d = a0 -
// b0, the differences of points of A and B are d + A' - B', with A' in the triangle of 0, p and q,
// and B' in that of 0, r and s. The lemma of distance_certificate.hpp reads: for any z other than 0
// and any difference y,
//     (z.d + min(0, z.p, z.q) - max(0, z.r, z.s)) / |z|  <=  distance  <=  |y|.
// Each z that is tried is such a difference, but for roundings, and serves as y too.
//
// Bounds, with u = 2^-24. |x| is the Euclidean length. P, R and D bound |p| and |q|, |r| and |s|,
// and |d|; so M = P + R + D bounds every difference.
//
// Input: errors of p, q, r, s and d by vectors of length at most dp, dr and dd move each difference
// by at most i = dp + dr + dd, and so both bounds. float_pair_kernel.cpp derives these:
// `weight_a` P, `weight_b` R, and 1.0001 u D plus the error of B's posed corner.
//
// Upper bound: roundings of y. A component's rounding errs by u of it, so a vector's by u of its
// length. The centroids: sums of 2 P and 2 R, scaled by a third, and two sums err by 1.4 u (P + R)
// + 2 u M. A step: a corner errs by 2 u M, its difference from z, at most 2 M, by 2 u M, the
// product by 2 u M and the sum by u M; weighted by the share, the errors of z and of the corner do
// not add. So a step adds 5 u M, and three steps make less than 18.5 u M. Features: the first
// corners' difference errs by 2 u M, edges, of at most 2 P and 2 R, and their products by 4 u (P +
// R) in all, and two sums by 2 u M. In a face the second share may exceed the rest by u, which is u
// R. Less than 18.5 u M. The computed length errs by 2.5 u M, its sum with e by 1.1 u M: 22.1 u M.
//
// Lower bound: a scalar product with z errs by 3 u of both lengths, the two sums by u M |z| each:
// 5 u M |z|. The length's error, the rounding of d + e and of its product, or of the quotient and
// the difference, make another 5 u M, where the limit is at most M; a greater limit leaves a margin
// of 20 u M. Together 10 u M.
//
// The world: A's pose changes lengths by less than 2^-5 u, relatively, where it is usable.
//
// So e = 25 u M + i covers both. It is computed with constants that are raised by 1 %.
//
// The lengths P, R and D are square roots of sums of squares that are raised by 2^-64, so u M is at
// least 2^-55. Underflow loses at most 2^-148 in a scalar product. That is nothing beside u M |z|
// where |z| is at least 2^-50, which a lower bound requires, and beside the square of u M in an
// upper bound. Sizes beyond 2^38 are not used; NaN fails that test. Shares may then still overflow,
// but are in [0, 1] whatever they are computed from.
#include "common/distance/stages/float/near_pair_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/distance/stages/float/near_pair_kernel.cpp"
#include <hwy/foreach_target.h>
// The headers below are compiled for every target.
#include "common/distance/stages/float/near_pair_proofs-inl.hpp"
#include "common/pair/stages/float/float_pair_columns-inl.hpp"
#include "common/pair/stages/float/float_pair_rows-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

/// Number of candidates that are looked at together: a multiple of the lanes.
constexpr std::size_t near_pairs_at_once = 256;

/// Candidates whose number is rounded up to that of the lanes by repeating the last one.
class NearBlock {
  public:
    HWY_INLINE void add(const std::uint32_t* candidate) {
        std::memcpy(
            numbers_ + candidate_step * count_, candidate, sizeof(*candidate) * candidate_step);
        ++count_;
    }
    HWY_INLINE void pad() {
        for (std::size_t i = count_; i < count_ + lanes && count_ > 0; ++i) {
            std::memcpy(numbers_ + candidate_step * i,
                        numbers_ + candidate_step * (count_ - 1),
                        sizeof(*numbers_) * candidate_step);
        }
    }
    [[nodiscard]] HWY_INLINE std::size_t size() const { return count_; }
    [[nodiscard]] HWY_INLINE const std::uint32_t* at(std::size_t i) const {
        return numbers_ + candidate_step * i;
    }

  private:
    std::uint32_t numbers_[candidate_step * (near_pairs_at_once + lanes)];
    std::size_t count_ = 0;
};

/// Reads pairs of two bodies.
template <class A, class B>
class NearReader {
  public:
    NearReader(const NearPairBatch& batch, const A& a, const B& b, double reach)
        : batch_(batch), a_(a), b_(b) {
        const double error = batch.pose.point_error_reach * reach + batch.pose.point_error;
        hn::Store(hn::Set(Floats(), static_cast<float>(error)), Floats(), rows_.d_error);
    }

    /// Reads the pairs of a vector of candidates, and prefetches later ones that are there.
    HWY_INLINE NearPairs read(const NearBlock& block, std::size_t i) {
        if (i + prefetch_distance + lanes <= block.size()) {
            prefetch_blocks(a_, b_, block.at(i + prefetch_distance));
        }
        load_rows(batch_.pose, a_, b_, block.at(i), rows_);
        load_errors(batch_.pose, b_, block.at(i), rows_);
        return load_pairs(batch_.pose, batch_.errors, rows_);
    }

  private:
    const NearPairBatch& batch_;
    const A& a_;
    const B& b_;
    Rows rows_;
};

/// Writes one verdict per lane.
HWY_INLINE void write_verdicts(const Proofs& proofs, std::uint8_t* to) {
    const Floats df;
    std::uint8_t far[8] = {};
    std::uint8_t near[8] = {};
    hn::StoreMaskBits(df, proofs.far, far);
    hn::StoreMaskBits(df, proofs.near, near);
    for (std::size_t i = 0; i < lanes; ++i) {
        const int is_far = far[i / 8] >> i % 8 & 1;
        const int is_near = near[i / 8] >> i % 8 & 1;
        to[i] =
            static_cast<std::uint8_t>(is_far * near_verdict::far + is_near * near_verdict::near);
    }
}

template <class Reader>
void decide_block(Reader& reader,
                  const NearBlock& block,
                  const NearPairLimit& limit,
                  std::uint8_t* verdicts) {
    std::uint8_t found[near_pairs_at_once + lanes];
    for (std::size_t i = 0; i < block.size(); i += lanes) {
        write_verdicts(decide_by_steps(reader.read(block, i), limit), found + i);
    }
    std::memcpy(verdicts, found, block.size());

    NearBlock left;
    std::uint16_t places[near_pairs_at_once];
    for (std::size_t i = 0; i < block.size(); ++i) {
        if (found[i] == near_verdict::unknown) {
            places[left.size()] = static_cast<std::uint16_t>(i);
            left.add(block.at(i));
        }
    }
    left.pad();
    for (std::size_t i = 0; i < left.size(); i += lanes) {
        const NearPairs pairs = reader.read(left, i);
        const Look look = look_along<false>(pairs, shortest_of_features(pairs));
        write_verdicts(proofs_of(pairs, look, limit), found + i);
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
        verdicts[places[i]] = found[i];
    }
}

/// Bounds of a vector of pairs; 0 and infinity where nothing is proven.
struct VectorBounds {
    V lower;
    V upper;
};

HWY_INLINE VectorBounds bounds_of(const NearPairs& pairs) {
    const Floats df;
    const Look look = look_along<false>(pairs, shortest_of_features(pairs));
    const V length = hn::Sqrt(look.square);
    const V lower = hn::Sub(hn::Div(look.gap, length), pairs.error);
    const M is_sound = hn::And(hn::Ge(look.square, hn::Set(df, 0x1p-100F)), pairs.usable);
    const M is_positive = hn::And(hn::Gt(lower, hn::Zero(df)), is_sound);
    const V infinity = hn::Set(df, std::numeric_limits<float>::infinity());
    return {hn::IfThenElseZero(is_positive, lower),
            hn::IfThenElse(pairs.usable, hn::Add(length, pairs.error), infinity)};
}

template <class Reader>
void bound_block(Reader& reader, const NearBlock& block, float* lower, float* upper) {
    const Floats df;
    alignas(64) float bounds[2][lanes];
    for (std::size_t i = 0; i < block.size(); i += lanes) {
        const VectorBounds found = bounds_of(reader.read(block, i));
        hn::Store(found.lower, df, bounds[0]);
        hn::Store(found.upper, df, bounds[1]);
        const std::size_t size = std::min(lanes, block.size() - i) * sizeof(float);
        std::memcpy(lower + i, bounds[0], size);
        std::memcpy(upper + i, bounds[1], size);
    }
}

/// Calls `use(reader, block, first)` for blocks of all candidates, which begin at `first`.
template <class Use>
void for_each_near_block(const NearPairBatch& batch, const Use& use) {
    with_sources(batch.a, batch.b, [&](const auto& a, const auto& b, double reach) {
        NearReader reader(batch, a, b, reach);
        for (std::size_t first = 0; first < batch.count; first += near_pairs_at_once) {
            const std::size_t size = std::min(near_pairs_at_once, batch.count - first);
            NearBlock block;
            for (std::size_t i = first; i < first + size; ++i) {
                block.add(batch.candidates + candidate_step * i);
            }
            block.pad();
            use(reader, block, first);
        }
    });
}

void decide_all_near(const NearPairBatch& batch,
                     const NearPairLimit& limit,
                     std::uint8_t* verdicts) {
    for_each_near_block(batch, [&](auto& reader, const NearBlock& block, std::size_t first) {
        decide_block(reader, block, limit, verdicts + first);
    });
}

void bound_all_distances(const NearPairBatch& batch, float* lower, float* upper) {
    for_each_near_block(batch, [&](auto& reader, const NearBlock& block, std::size_t first) {
        bound_block(reader, block, lower + first, upper + first);
    });
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(decide_all_near);
HWY_EXPORT(bound_all_distances);

void decide_near_in_floats(const NearPairBatch& batch,
                           const NearPairLimit& limit,
                           std::uint8_t* verdicts) {
    HWY_DYNAMIC_DISPATCH(decide_all_near)(batch, limit, verdicts);
}

void bound_distances_in_floats(const NearPairBatch& batch, float* lower, float* upper) {
    HWY_DYNAMIC_DISPATCH(bound_all_distances)(batch, lower, upper);
}

} // namespace cd

#endif
