// Chooses the depth of a body's cut if the job names none, so that blocks suit single requests.
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
    double triangles = 0; ///< Triangles under a triangle's root, averaged over all triangles.
};

/// Returns the cuts at depths 0, 1 and so on, while there is something left to cut, up to the first
/// with more than `limits::roots_chosen_max` roots.
[[nodiscard]] std::vector<CutSize> cut_sizes(const ObbTree& tree);

/// Returns the least depth at which a block takes at most `limits::block_bytes_wanted`, or a lower
/// one if that gives too many roots. Smaller blocks cost more requests, more root pairs per
/// scenario, and more bytes per triangle; larger blocks carry bytes that no scenario touches.
/// `cuts` are those of a tree, from depth 0 on.
[[nodiscard]] std::uint32_t choose_depth(std::span<const CutSize> cuts, double bytes_per_triangle);

/// Chooses the depth for blocks of this form. Depends on the tree alone, so that jobs share blocks.
[[nodiscard]] std::uint32_t choose_depth(const ObbTree& tree, SubtreeForm form);

} // namespace cd
