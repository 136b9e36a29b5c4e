// Loads SIMD vectors from scattered addresses by plain loads and shuffles. SIMD gathers are slow on
// some processors. A copy into a buffer is slow as well: a vector load cannot be forwarded from
// several smaller stores. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_BUNDLE_COLUMNS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_BUNDLE_COLUMNS_INL_HPP
#undef CD_BUNDLE_COLUMNS_INL_HPP
#else
#define CD_BUNDLE_COLUMNS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace bundle {

namespace hn = hwy::HWY_NAMESPACE;

/// Rows of four numbers.
using Row = double[4];

/// Loads four numbers.
template <class D4>
HWY_INLINE hn::Vec<D4> load_row(D4 d, const double* row) {
    return hn::LoadU(d, row);
}

template <class D4>
HWY_INLINE hn::Vec<D4> load_row(D4 d, const float* row) {
    return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D4>(), row));
}

/// Four vectors that hold one row of four numbers in each lane (a transposition).
template <class D>
struct Columns {
    hn::Vec<D> at[4];

    /// `row_of(lane)` returns a pointer to the lane's four floats or doubles.
    template <class RowOf>
    HWY_INLINE Columns(D d, const RowOf& row_of) {
#if HWY_TARGET == HWY_SCALAR
        for (std::size_t i = 0; i < 4; ++i) {
            at[i] = hn::Set(d, row_of(0)[i]);
        }
#else
        if constexpr (hn::MaxLanes(d) == 8) {
            const hn::Half<D> half;
            const auto two = [&](std::size_t i) {
                return hn::Combine(d, load_row(half, row_of(i + 1)), load_row(half, row_of(i)));
            };
            const auto first = two(0);
            const auto second = two(2);
            const auto third = two(4);
            const auto fourth = two(6);
            const auto even = hn::ConcatEven(d, second, first);
            const auto odd = hn::ConcatOdd(d, second, first);
            const auto later_even = hn::ConcatEven(d, fourth, third);
            const auto later_odd = hn::ConcatOdd(d, fourth, third);
            at[0] = hn::ConcatEven(d, later_even, even);
            at[1] = hn::ConcatEven(d, later_odd, odd);
            at[2] = hn::ConcatOdd(d, later_even, even);
            at[3] = hn::ConcatOdd(d, later_odd, odd);
        } else if constexpr (hn::MaxLanes(d) == 4) {
            const auto row = [&](std::size_t i) { return load_row(d, row_of(i)); };
            const auto lower = hn::InterleaveLower(d, row(0), row(1));
            const auto upper = hn::InterleaveUpper(d, row(0), row(1));
            const auto later_lower = hn::InterleaveLower(d, row(2), row(3));
            const auto later_upper = hn::InterleaveUpper(d, row(2), row(3));
            at[0] = hn::ConcatLowerLower(d, later_lower, lower);
            at[1] = hn::ConcatLowerLower(d, later_upper, upper);
            at[2] = hn::ConcatUpperUpper(d, later_lower, lower);
            at[3] = hn::ConcatUpperUpper(d, later_upper, upper);
        } else {
            alignas(32) Row rows[hn::MaxLanes(d)];
            for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
                for (std::size_t i = 0; i < 4; ++i) {
                    rows[lane][i] = row_of(lane)[i];
                }
            }
            hn::LoadInterleaved4(d, rows[0], at[0], at[1], at[2], at[3]);
        }
#endif
    }
};

/// Returns the vector of `list[numbers[lane]]`.
template <class D>
HWY_INLINE hn::Vec<D> load_each(D d, const double* list, const std::uint32_t* numbers) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(d, list[numbers[0]]);
#else
    if constexpr (hn::MaxLanes(d) == 2) {
        return hn::InterleaveLower(d, hn::Set(d, list[numbers[0]]), hn::Set(d, list[numbers[1]]));
    } else {
        const hn::Half<D> half;
        return hn::Combine(
            d, load_each(half, list, numbers + hn::MaxLanes(half)), load_each(half, list, numbers));
    }
#endif
}

} // namespace bundle
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
