// With the edges p, q of A at a0, the edges r, s of B at b0, all in A's coordinates, d = a0 - b0,
// NA = p x q and NB = r x s, all fifteen determinants of a pair are sums of ten triple products.
// Edges are differences of a triangle's own corners, and d is formed in double. So every float is
// as small as the triangles and their distance, wherever they are, and so are its errors.
//
// Bounds, with u = 2^-24. |x| is the Euclidean length. A computed x differs from the true one by a
// vector of length at most dx; X bounds the lengths of both.
//
// Input: |det(x, y, z)| <= |x||y||z|, and a determinant is linear in its rows. So errors of the
// input change a triple product by at most dx Y Z + X dy Z + X Y dz, except for products of errors.
// Arithmetic, for |x| = |y| = |z| = 1: a component ci of c = y x z is two products and a
// difference, so within u mi + u |ci|, with mi the sum of the products' sizes. The sum of all mi^2
// is 1 + (y.z)^2 - 2 (sum of (yi zi)^2), and that last sum is at least (y.z)^2 / 3: |m|^2 <= 4/3.
// So c is within 2.155 u. The dot product with x inherits this error. It rounds three products xi
// ci, whose sizes sum to at most |x||c| = 1, a sum of two of them, and the result, each at most 1:
// 3 u. A determinant adds up to eight triple products along a tree of depth three: another 3 u for
// each. Together that is 8.155 u XYZ, raised to 8.25 for products of errors and for the bound's own
// roundings: fewer than thirty, all of positive numbers. So a triple product within a determinant
// is within
//     wx X Y Z + wy X Y Z + wz X Y Z, wx = 1.01 dx / X + 2.75 u.
//
// Errors of the input. An edge of A is the difference of floats, or is rounded from a double that
// is one of doubles: dx = 1.0001 u |x|. So is an edge e of B, which the matrix R then turns in
// floats. Each product has five roundings: of its entry, of its edge, its own, and of two sums.
// With |M| for a matrix of the entries' sizes, that errs by 5 u | |R| |e| | <= 5 u n |e|, where n
// bounds the spectral norm of |R|. |e| is at most `stretch` times the turned edge, so dx = 5.01 u n
// stretch x. The entries' own error, of doubles, is below u n / 1000 for usable poses. The corner
// b0 is posed in doubles: each of three products is rounded four times and has its entry's error;
// the translation is rounded once and has its own error. Then d = a0 - b0 is rounded to a double
// and to a float. The length of a vector is at most sqrt(3) times its largest component: dx =
// 1.0001 u |x| + point_error_reach |b0| + point_error, |b0| being the largest component.
//
// The lengths X are square roots of sums of squares: raised by 2^-64, they are at least 2^-32.
// Underflow loses at most 2^-150 a product or conversion. That is nothing beside u X in a
// conversion. In a cross product it is less than 2^-148, beside u Y Z / 100 >= 2^-95, and in a
// triple product 2^-148 beside u X Y Z / 100 >= 2^-127; the 8.25 covers both. Lengths beyond 2^38
// are not used; smaller ones overflow nothing. A NaN input reaches the fifth edge determinant,
// which uses all inputs, and is detected there: maxima may lose a NaN.
#include "common/pair/stages/float/float_pair_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/pair/stages/float/float_pair_kernel.cpp"
#include <hwy/foreach_target.h>
// The headers below are compiled for every target.
#include "common/pair/stages/float/float_pair_rows-inl.hpp"
#include "common/pair/stages/float/float_pair_signs-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

constexpr std::size_t byte_pairs = lanes < 8 ? lanes : 8;
constexpr std::size_t block_pairs = 8 * byte_pairs;

/// Provides a candidate for each lane: surplus lanes repeat the last candidate.
class PaddedCandidates {
  public:
    HWY_INLINE const std::uint32_t* of(const std::uint32_t* candidates, std::size_t count) {
        if (count >= lanes) {
            return candidates;
        }
        for (std::size_t i = 0; i < lanes; ++i) {
            const std::size_t from = i < count ? i : count - 1;
            places_[candidate_step * i] = candidates[candidate_step * from];
            places_[candidate_step * i + 1] = candidates[candidate_step * from + 1];
        }
        return places_;
    }

  private:
    std::uint32_t places_[candidate_step * lanes];
};

struct Batch {
    const std::uint32_t* candidates;
    std::size_t count;
    std::uint8_t* verdicts;
};

/// Classifies all pairs of a batch. `reach` bounds every |coordinate| of B's blocks; 0 for a mesh.
template <class A, class B>
void classify_from(
    const FloatPairPose& pose, const A& a, const B& b, double reach, const Batch& batch) {
    Rows rows;
    const double error = pose.point_error_reach * reach + pose.point_error;
    hn::Store(hn::Set(Floats(), static_cast<float>(error)), Floats(), rows.d_error);
    SignBits bits;
    PaddedCandidates padded;
    for (std::size_t first = 0; first < batch.count; first += block_pairs) {
        const std::uint32_t* candidates = batch.candidates + candidate_step * first;
        const std::size_t left = batch.count - first;
        const std::size_t size = left < block_pairs ? left : block_pairs;
        for (std::size_t i = 0; i < size; i += lanes) {
            const std::uint32_t* some = padded.of(candidates + candidate_step * i, left - i);
            if (i + prefetch_distance + lanes <= left) {
                prefetch_blocks(a, b, some + candidate_step * prefetch_distance);
            }
            load_rows(pose, a, b, some, rows);
            load_errors(pose, b, some, rows);
            write_signs(pose, rows, {bits, i / byte_pairs});
        }
        decide_in_floats(bits, size, byte_pairs, batch.verdicts + first);
    }
}

/// Calls `classify_from` with each body's kind.
void classify_all(const FloatPairPose& pose,
                  const FloatPairBody& a,
                  const FloatPairBody& b,
                  const std::uint32_t* candidates,
                  std::size_t count,
                  std::uint8_t* verdicts) {
    const Batch batch{candidates, count, verdicts};
    with_sources(a, b, [&](const auto& from_a, const auto& from_b, double reach) {
        classify_from(pose, from_a, from_b, reach, batch);
    });
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(classify_all);

void classify_in_floats(const FloatPairPose& pose,
                        const FloatPairBody& a,
                        const FloatPairBody& b,
                        const std::uint32_t* candidates,
                        std::size_t count,
                        std::uint8_t* verdicts) {
    HWY_DYNAMIC_DISPATCH(classify_all)(pose, a, b, candidates, count, verdicts);
}

} // namespace cd

#endif
