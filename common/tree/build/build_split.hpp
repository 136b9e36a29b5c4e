// Where to split the triangles of a node (paper, 6.2).
#pragma once

#include "common/tree/build/build.hpp"
#include "common/tree/build/build_bins.hpp"
#include "common/tree/build/build_fit.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// Memory that the sweeps use again.
struct SweepScratch {
    std::vector<std::uint64_t> order;
    std::vector<double> low_after;
};

/// The triangles of the left child are the first `left_count` in the order of their maximal
/// projection on `axis`: those whose rank is at most `last_rank`.
struct Split {
    std::size_t axis = 0;
    std::uint32_t left_count = 0;
    Interval whole; ///< The node's projection on the axis.
    bool binned = false;
    std::uint64_t last_rank = 0;
};

/// The minimal sum of relative segments among all splits that the rule admits, on all three axes;
/// the widest direction wins a tie. Nothing when no axis tells the triangles apart.
[[nodiscard]] std::optional<Split> sweep_split(std::span<const Projection> triangles,
                                               const Projection& whole,
                                               SplitRule rule,
                                               SweepScratch& scratch);

/// The same among the splits between two bins, with a quarter of the triangles on each side at
/// least. An axis on which no such split exists is swept.
[[nodiscard]] std::optional<Split> binned_split(std::span<const Projection> triangles,
                                                const Projection& whole,
                                                const Bins& bins,
                                                SweepScratch& scratch);

/// Puts the triangles first of whose places `goes_left` is true; both sides keep their order. How
/// many these are. `scratch` is as long as `triangles`.
template <class GoesLeft>
std::uint32_t part_by(std::span<BuildTriangle> triangles,
                      std::span<BuildTriangle> scratch,
                      const GoesLeft& goes_left) {
    // No branch: which side is anyone's guess.
    std::uint32_t left = 0;
    std::uint32_t right = 0;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const BuildTriangle triangle = triangles[i];
        const std::uint32_t is_left = goes_left(i) ? 1 : 0;
        triangles[left] = triangle;
        scratch[right] = triangle;
        left += is_left;
        right += 1 - is_left;
    }
    std::copy_n(scratch.begin(), right, triangles.begin() + left);
    return left;
}

/// Puts the triangles of the left child first; both sides keep their order. They are those at
/// `first_place` and after in the node that was split. How many go left. `scratch` is as long as
/// `triangles`.
std::uint32_t part_triangles(std::span<BuildTriangle> triangles,
                             std::span<const Projection> projections,
                             std::uint32_t first_place,
                             const Split& split,
                             std::span<BuildTriangle> scratch);

} // namespace cd
