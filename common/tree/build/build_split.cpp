#include "common/tree/build/build_split.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A split with its sum of relative segments (`SplitRule`).
struct Candidate {
    double sum = infinity;
    std::uint32_t left_count = 0;
    std::uint64_t last_rank = 0;
};

/// Returns the sort key of a triangle along an axis: the maximum of its interval relative to the
/// whole, then its index. Keys of different indices are different.
std::uint64_t rank_of(const Interval& triangle, const Interval& whole, std::uint32_t index) {
    // The quotient is in [0, 1], where the bit patterns of floats sort as their values do.
    // Differences below 2^-24 of the whole do not matter to the choice.
    const auto key = static_cast<float>((triangle.high - whole.low) / (whole.high - whole.low));
    return std::uint64_t{std::bit_cast<std::uint32_t>(key)} << 32 | index;
}

std::uint32_t index_of(std::uint64_t rank) {
    return static_cast<std::uint32_t>(rank);
}

/// Returns the least number of triangles that the rule leaves on either side.
std::uint32_t side_min(SplitRule rule, std::size_t count) {
    return rule == SplitRule::Quarter ? static_cast<std::uint32_t>((count + 3) / 4) : 1;
}

/// Sorts only as far as the rule needs: afterwards order[side - 1 .. count - side) is as in the
/// sorted order, with no greater rank before that range and no smaller rank behind it.
void sort_ranks(std::vector<std::uint64_t>& order, std::size_t side) {
    const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(0), at(side - 1), order.end());
    std::nth_element(at(side), at(order.size() - side), order.end());
    std::sort(at(side), at(order.size() - side));
}

Candidate sweep_axis(std::span<const Projection> triangles,
                     std::size_t axis,
                     const Interval& whole,
                     std::size_t side,
                     SweepScratch& scratch) {
    Candidate best;
    const double length = whole.high - whole.low;
    if (!(length > 0) || !std::isfinite(length)) {
        return best;
    }
    const std::size_t count = triangles.size();
    std::vector<std::uint64_t>& order = scratch.order;
    order.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        order[i] = rank_of(triangles[i][axis], whole, i);
    }
    sort_ranks(order, side);

    // Entry i is the low end of the second side if the first side has `side` + i triangles.
    std::vector<double>& low_after = scratch.low_after;
    low_after.resize(count - 2 * side + 1);
    double low = infinity;
    for (std::size_t i = count; i-- > side;) {
        low = std::min(low, triangles[index_of(order[i])][axis].low);
        if (i <= count - side) {
            low_after[i - side] = low;
        }
    }
    Interval first{infinity, -infinity};
    for (std::size_t i = 0; i < count - side; ++i) {
        const Interval& triangle = triangles[index_of(order[i])][axis];
        first.low = std::min(first.low, triangle.low);
        first.high = std::max(first.high, triangle.high);
        if (i + 1 < side) {
            continue;
        }
        const double second_low = low_after[i + 1 - side];
        const double sum = ((first.high - first.low) + (whole.high - second_low)) / length;
        if (sum < best.sum) {
            best = {sum, static_cast<std::uint32_t>(i + 1), order[i]};
        }
    }
    return best;
}

} // namespace

std::optional<Split> sweep_split(std::span<const Projection> triangles,
                                 const Projection& whole,
                                 SplitRule rule,
                                 SweepScratch& scratch) {
    const std::size_t side = side_min(rule, triangles.size());
    std::optional<Split> split;
    double sum_min = infinity;
    for (std::size_t axis = 3; axis-- > 0;) {
        const Candidate best = sweep_axis(triangles, axis, whole[axis], side, scratch);
        if (best.sum < sum_min) {
            sum_min = best.sum;
            split = Split{axis, best.left_count, whole[axis], false, best.last_rank};
        }
    }
    return split;
}

std::optional<Split> binned_split(std::span<const Projection> triangles,
                                  const Projection& whole,
                                  const Bins& bins,
                                  SweepScratch& scratch) {
    const std::uint32_t side = side_min(SplitRule::Quarter, triangles.size());
    std::optional<Split> split;
    double sum_min = infinity;
    for (std::size_t axis = 3; axis-- > 0;) {
        if (const auto best = bins.best(axis, side)) {
            if (best->sum < sum_min) {
                sum_min = best->sum;
                split = Split{axis, best->left_count, whole[axis], true, best->last_bin};
            }
            continue;
        }
        const Candidate best = sweep_axis(triangles, axis, whole[axis], side, scratch);
        if (best.sum < sum_min) {
            sum_min = best.sum;
            split = Split{axis, best.left_count, whole[axis], false, best.last_rank};
        }
    }
    return split;
}

std::uint32_t part_triangles(std::span<BuildTriangle> triangles,
                             std::span<const Projection> projections,
                             std::uint32_t first_index,
                             const Split& split,
                             std::span<BuildTriangle> scratch) {
    if (split.binned) {
        const BinScale scale(split.whole);
        return part_by(triangles, scratch, [&](std::uint32_t i) {
            return scale.bin_of(projections[i][split.axis]) <= split.last_rank;
        });
    }
    return part_by(triangles, scratch, [&](std::uint32_t i) {
        return rank_of(projections[i][split.axis], split.whole, first_index + i) <= split.last_rank;
    });
}

} // namespace cd
