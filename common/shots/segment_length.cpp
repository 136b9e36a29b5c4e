#include "common/shots/segment_length.hpp"

#include "common/distance/stages/exact/exact_distance.hpp"
#include "common/pair/numbers/double_double.hpp"
#include "common/pair/numbers/dyadic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace cd {

namespace {

using Differences = std::array<DoubleDouble, 3>;

/// Between these magnitudes of the largest difference nothing overflows, and underflow loses far
/// less than the error bound.
constexpr double least = 0x1p-200;
constexpr double most = 0x1p200;

/// Returns the length of a segment along one axis, if it is a double.
std::optional<double> length_along_axis(const Differences& d) {
    std::size_t zeros = 0;
    DoubleDouble along;
    for (const DoubleDouble& difference : d) {
        zeros += difference.high == 0 ? 1u : 0u;
        along = difference.high == 0 ? along : difference;
    }
    return zeros >= 2 && along.low == 0 ? std::optional(std::abs(along.high)) : std::nullopt;
}

/// Rounds the root by Ziv's test. The differences are exact. With e for `double_double_error`, each
/// square errs by e, relatively, and each of two sums of positive numbers by e: 3 e, and 1.5 e for
/// the root. One step of Newton's method errs by less than e more, so 4 e has room.
std::optional<double> length_in_double_double(const Differences& d) {
    const DoubleDouble square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double first = std::sqrt(square.high);
    const DoubleDouble rest = square - exact_product(first, first);
    const DoubleDouble root = exact_sum_ordered(first, rest.high / (2 * first));
    const double margin = 4 * double_double_error * root.high;
    const double low = root.high + (root.low - margin);
    return low == root.high + (root.low + margin) ? std::optional(low) : std::nullopt;
}

double exact_length(const Segment& segment) {
    Dyadic square;
    for (int k = 0; k < 3; ++k) {
        const Dyadic difference = to_dyadic(segment.q[k]) - to_dyadic(segment.p[k]);
        square = square + difference * difference;
    }
    // The root takes an even exponent.
    const bool is_odd = square.exponent % 2 != 0;
    const ExactInt mantissa = is_odd ? ExactInt(2 * square.mantissa) : square.mantissa;
    return nearest_root(mantissa, 1, (square.exponent - (is_odd ? 1 : 0)) / 2);
}

} // namespace

double segment_length(const Segment& segment) {
    Differences d;
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        d[k] = exact_sum(segment.q[axis], -segment.p[axis]);
        largest = std::max(largest, std::abs(d[k].high));
    }
    if (largest >= least && largest <= most) {
        if (const auto length = length_along_axis(d)) {
            return *length;
        }
        if (const auto length = length_in_double_double(d)) {
            return *length;
        }
    }
    return exact_length(segment);
}

} // namespace cd
