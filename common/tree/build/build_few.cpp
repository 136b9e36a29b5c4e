#include "common/tree/build/build_few.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Swaps the keys at two indices, if need be, so that the smaller key is at `low`.
struct Comparator {
    std::uint8_t low;
    std::uint8_t high;
};

/// Calls `put(low, high)` for each comparator of Batcher's network for odd-even merging of `count`
/// keys (Knuth, The Art of Computer Programming 3, 5.2.2, algorithm M).
template <class Put>
constexpr void for_each_comparator(std::size_t count, const Put& put) {
    const std::size_t top = std::bit_ceil(count) / 2;
    for (std::size_t p = top; p > 0; p /= 2) {
        std::size_t q = top;
        std::size_t r = 0;
        std::size_t d = p;
        for (;;) {
            for (std::size_t i = 0; i + d < count; ++i) {
                if ((i & p) == r) {
                    put(i, i + d);
                }
            }
            if (q == p) {
                break;
            }
            d = q - p;
            q /= 2;
            r = p;
        }
    }
}

constexpr std::size_t comparator_count(std::size_t keys) {
    std::size_t count = 0;
    for_each_comparator(keys, [&](std::size_t, std::size_t) { ++count; });
    return count;
}

constexpr std::size_t comparators_before(std::size_t keys) {
    std::size_t count = 0;
    for (std::size_t i = 2; i < keys; ++i) {
        count += comparator_count(i);
    }
    return count;
}

/// Sorting networks for 2 to `few_triangles_max` keys, in one array.
struct Networks {
    std::array<Comparator, comparators_before(few_triangles_max + 1)> comparators{};
    std::array<std::uint16_t, few_triangles_max + 2> begins{};

    constexpr Networks() {
        std::size_t end = 0;
        for (std::size_t keys = 2; keys <= few_triangles_max; ++keys) {
            begins[keys] = static_cast<std::uint16_t>(end);
            for_each_comparator(keys, [&](std::size_t low, std::size_t high) {
                comparators[end++] = {static_cast<std::uint8_t>(low),
                                      static_cast<std::uint8_t>(high)};
            });
        }
        begins[few_triangles_max + 1] = static_cast<std::uint16_t>(end);
    }

    [[nodiscard]] std::span<const Comparator> of(std::size_t keys) const {
        return std::span(comparators).subspan(begins[keys], begins[keys + 1] - begins[keys]);
    }
};

constexpr Networks networks;

/// Replaces the lowest bits of `value`, as many as `tag_max` has, by `tag`. Positive tagged numbers
/// compare by value first, then by tag.
double tagged(double value, std::uint64_t tag, std::uint64_t tag_max) {
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(value) & ~tag_max) | tag);
}

constexpr std::uint64_t index_max = few_triangles_max - 1;

std::uint32_t index_of(double key) {
    return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(key) & index_max);
}

/// For each triangle and axis, the high end relative to the node, tagged with the triangle's index.
using Keys = std::array<std::array<double, 3>, few_triangles_max>;

void sort_keys(Keys& keys, std::size_t count) {
    for (const Comparator& comparator : networks.of(count)) {
        for (std::size_t k = 0; k < 3; ++k) {
            double& low = keys[comparator.low][k];
            double& high = keys[comparator.high][k];
            const double less = std::min(low, high);
            high = std::max(low, high);
            low = less;
        }
    }
}

constexpr std::uint64_t choice_max = 4 * few_triangles_max - 1;

/// Returns the least sum of relative segments on an axis, tagged with the number of triangles that
/// go left.
double least_sum(std::span<const Projection> triangles,
                 const Keys& keys,
                 std::size_t axis,
                 const Interval& whole,
                 std::size_t side) {
    const std::size_t count = triangles.size();
    std::array<double, few_triangles_max> low_from;
    double low = infinity;
    for (std::size_t i = count; i-- > side;) {
        low = std::min(low, triangles[index_of(keys[i][axis])][axis].low);
        low_from[i] = low;
    }
    const double factor = 1 / (whole.high - whole.low);
    Interval first{infinity, -infinity};
    double least = infinity;
    for (std::size_t i = 0; i < count - side; ++i) {
        const Interval& triangle = triangles[index_of(keys[i][axis])][axis];
        first.low = std::min(first.low, triangle.low);
        first.high = std::max(first.high, triangle.high);
        if (i + 1 >= side) {
            const double sum = factor * ((first.high - first.low) + (whole.high - low_from[i + 1]));
            // The widest axis has index 2; its tag is the smallest, so it wins a tie.
            const std::uint64_t tag = (2 - axis) * few_triangles_max + i;
            least = std::min(least, tagged(sum, tag, choice_max));
        }
    }
    return least;
}

} // namespace

std::optional<FewSplit>
sweep_few(std::span<const Projection> triangles, const Projection& whole, SplitRule rule) {
    const std::size_t count = triangles.size();
    std::array<double, 3> factors{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double factor = 1 / (whole[k].high - whole[k].low);
        factors[k] = std::isfinite(factor) ? factor : 0;
    }
    Keys keys;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            keys[i][k] =
                tagged(1 + (triangles[i][k].high - whole[k].low) * factors[k], i, index_max);
        }
    }
    sort_keys(keys, count);
    const std::size_t side = rule == SplitRule::Quarter ? (count + 3) / 4 : 1;
    double least = infinity;
    for (std::size_t k = 0; k < 3; ++k) {
        if (factors[k] > 0) {
            least = std::min(least, least_sum(triangles, keys, k, whole[k], side));
        }
    }
    if (!(least < infinity)) {
        return std::nullopt;
    }
    const std::uint64_t choice = std::bit_cast<std::uint64_t>(least) & choice_max;
    const std::size_t axis = 2 - choice / few_triangles_max;
    FewSplit split;
    split.left_count = static_cast<std::uint32_t>(choice % few_triangles_max) + 1;
    for (std::size_t i = 0; i < split.left_count; ++i) {
        split.left |= 1u << index_of(keys[i][axis]);
    }
    return split;
}

} // namespace cd
