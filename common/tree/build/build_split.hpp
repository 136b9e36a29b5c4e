// Chooses where to split the triangles of a node (paper, 6.2).
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

/// Scratch memory that sweeps reuse.
struct SweepScratch {
    std::vector<std::uint64_t> order;
    std::vector<double> low_after;
};

/// A split of a node. The left child has the first `left_count` triangles in the order of their
/// maximal projection on `axis`: the triangles whose rank is at most `last_rank`.
struct Split {
    std::size_t axis = 0;
    std::uint32_t left_count = 0;
    Interval whole;              ///< The node's projection on `axis`.
    bool binned = false;         ///< True if the triangles were sorted into bins only.
    std::uint64_t last_rank = 0; ///< Greatest rank of the left child; if binned, the last bin.
};

/// Finds the split with the least sum of relative segments (`SplitRule`) among all that the rule
/// admits, on all three axes; the widest direction wins a tie. Returns nothing when no axis tells
/// the triangles apart.
[[nodiscard]] std::optional<Split> sweep_split(std::span<const Projection> triangles,
                                               const Projection& whole,
                                               SplitRule rule,
                                               SweepScratch& scratch);

/// Finds the split with the least sum of relative segments (`SplitRule`) among the splits between
/// two bins that leave at least a quarter of the triangles on each side. On an axis without such a
/// split, considers splits between any two triangles.
[[nodiscard]] std::optional<Split> binned_split(std::span<const Projection> triangles,
                                                const Projection& whole,
                                                const Bins& bins,
                                                SweepScratch& scratch);

/// Moves to the front the triangles for whose indices `goes_left` is true; both sides keep their
/// order. Returns the number of triangles that go left. `scratch` is as long as `triangles`.
template <class GoesLeft>
std::uint32_t part_by(std::span<BuildTriangle> triangles,
                      std::span<BuildTriangle> scratch,
                      const GoesLeft& goes_left) {
    // The loop has no branch, as a branch on the side would be unpredictable.
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

/// Moves the triangles of the left child to the front; both sides keep their order. `triangles`
/// begins at `first_index` in the node that was split. Returns the number of triangles that go
/// left. `scratch` is as long as `triangles`.
std::uint32_t part_triangles(std::span<BuildTriangle> triangles,
                             std::span<const Projection> projections,
                             std::uint32_t first_index,
                             const Split& split,
                             std::span<BuildTriangle> scratch);

} // namespace cd
