// Chooses the distribution depth of a body if the job gives none, so that blocks have a good size.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/subtree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Size of the cut at one depth.
struct CutSize {
    std::uint64_t roots = 0;
    double triangles = 0; ///< Triangles in the subtree of a triangle, averaged over the triangles.
};

/// Returns the sizes of the cuts at depths 0, 1 and so on. Ends with the cut in which all roots are
/// leaves, or with the first that has more than `limits::roots_chosen_max` roots.
[[nodiscard]] std::vector<CutSize> cut_sizes(const ObbTree& tree);

/// Returns the least depth at which a block takes about `limits::block_bytes_wanted`, or a lower
/// depth if that one has too many roots. Smaller blocks cost more requests, more root pairs per
/// scenario, and more bytes per triangle; larger blocks contain bytes that no scenario needs.
/// `cuts`: the result of `cut_sizes`.
[[nodiscard]] std::uint32_t choose_depth(std::span<const CutSize> cuts, double bytes_per_triangle);

/// Chooses the depth for blocks of this form. It depends only on tree and form: jobs share blocks.
[[nodiscard]] std::uint32_t choose_depth(const ObbTree& tree, SubtreeForm form);

} // namespace cd
