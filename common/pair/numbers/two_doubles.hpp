// Arithmetic on two doubles in one SIMD register of 128 bits, which every supported processor has.
#pragma once

#include <cstdint>

namespace cd {

__extension__ typedef double TwoDoubles __attribute__((vector_size(16)));
__extension__ typedef std::int64_t TwoMasks __attribute__((vector_size(16)));

/// Lane 0 belongs to body A, lane 1 to body B.
using BothBodies = TwoDoubles;

namespace two_doubles {

inline constexpr TwoMasks sign_bits{INT64_MIN, INT64_MIN};

inline TwoDoubles magnitudes(TwoDoubles x) {
    return TwoDoubles(TwoMasks(x) & ~sign_bits);
}

/// Keeps `value` in lanes whose `mask` is set; 0 elsewhere.
inline TwoDoubles where(TwoMasks mask, TwoDoubles value) {
    return TwoDoubles(mask & TwoMasks(value));
}

struct Sums {
    TwoDoubles high;
    TwoDoubles low;
};

/// Applies `exact_sum` of double_double.hpp to both lanes.
inline Sums exact_sums(TwoDoubles left, TwoDoubles right) {
    const TwoDoubles sum = left + right;
    const TwoDoubles right_part = sum - left;
    const TwoDoubles left_part = sum - right_part;
    return {sum, (left - left_part) + (right - right_part)};
}

} // namespace two_doubles

} // namespace cd
