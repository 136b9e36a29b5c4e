#include "common/tree/build_split.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace cd {

namespace {

/// A split and its sum of relative segments.
struct Candidate {
    double sum = std::numeric_limits<double>::infinity();
    std::uint32_t left_count = 0;
    std::uint64_t last_rank = 0;
};

std::uint32_t place_of(std::uint64_t rank) {
    return static_cast<std::uint32_t>(rank);
}

/// The fewest triangles that the rule leaves on either side.
std::size_t side_min(SplitRule rule, std::size_t count) {
    return rule == SplitRule::Quarter ? (count + 3) / 4 : 1;
}

/// Sorts only as far as the rule needs: afterwards order[side - 1 .. count - side) stands as in the
/// sorted order, with no greater rank before it and no smaller one behind.
void sort_ranks(std::span<const Interval> triangles,
                const Interval& whole,
                std::size_t side,
                std::vector<std::uint64_t>& order) {
    order.resize(triangles.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        order[i] = split_rank(triangles[i], whole, i);
    }
    const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(0), at(side - 1), order.end());
    std::nth_element(at(side), at(order.size() - side), order.end());
    std::sort(at(side), at(order.size() - side));
}

Candidate best_on_axis(std::span<const Interval> triangles,
                       const Interval& whole,
                       SplitRule rule,
                       SplitScratch::Axis& scratch) {
    Candidate best;
    const double length = whole.high - whole.low;
    if (!(length > 0) || !std::isfinite(length)) {
        return best;
    }
    const std::size_t count = triangles.size();
    const std::size_t side = side_min(rule, count);
    std::vector<std::uint64_t>& order = scratch.order;
    sort_ranks(triangles, whole, side, order);

    // Where the second submesh begins, if the first takes in `side` + i triangles.
    std::vector<double>& low_after = scratch.low_after;
    low_after.resize(count - 2 * side + 1);
    double low = std::numeric_limits<double>::infinity();
    for (std::size_t i = count; i-- > side;) {
        low = std::min(low, triangles[place_of(order[i])].low);
        if (i <= count - side) {
            low_after[i - side] = low;
        }
    }
    Interval first{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < count - side; ++i) {
        const Interval& triangle = triangles[place_of(order[i])];
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

std::uint64_t split_rank(const Interval& triangle, const Interval& whole, std::uint32_t place) {
    // In [0, 1], where the bits of floats stand in the order of their values. Differences below
    // 2^-24 of the whole do not matter to the choice.
    const auto key = static_cast<float>((triangle.high - whole.low) / (whole.high - whole.low));
    return std::uint64_t{std::bit_cast<std::uint32_t>(key)} << 32 | place;
}

std::optional<Split> choose_split(const Projections& projections,
                                  SplitRule rule,
                                  SplitScratch& scratch,
                                  ThreadPool* pool) {
    std::array<Candidate, 3> candidates;
    const auto run = [&](std::size_t axis) {
        candidates[axis] = best_on_axis(
            projections.triangles[axis], projections.whole[axis], rule, scratch.axes[axis]);
    };
    if (pool != nullptr) {
        parallel_for(*pool, 3, run);
    } else {
        run(0);
        run(1);
        run(2);
    }
    std::optional<Split> split;
    double sum_min = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 3; axis-- > 0;) { // The widest direction wins a tie.
        if (candidates[axis].sum < sum_min) {
            sum_min = candidates[axis].sum;
            split = Split{axis, candidates[axis].left_count, candidates[axis].last_rank};
        }
    }
    return split;
}

} // namespace cd
