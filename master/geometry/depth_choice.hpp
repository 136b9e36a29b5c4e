// Where a body's tree is cut if nobody says: into blocks that are worth asking for one by one.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/subtree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// What a cut at one depth makes of a tree.
struct CutSize {
    std::uint64_t roots = 0;
    double triangles = 0; ///< With a triangle under its root, on the mean over all triangles.
};

/// At depths 0, 1 and so on: as far as there is something left to cut, and not beyond the first
/// with more than `limits::roots_chosen_max` roots.
[[nodiscard]] std::vector<CutSize> cut_sizes(const ObbTree& tree);

/// The least depth at which a block takes at most `limits::block_bytes_wanted`. Smaller blocks cost
/// more requests, more pairs of roots to be found for each scenario and begun at a worker, and more
/// bytes a triangle; larger ones, bytes that no scenario touches. Shallower where there would be
/// too many roots. `cuts` are those of a tree, from depth 0 on.
[[nodiscard]] std::uint32_t choose_depth(std::span<const CutSize> cuts, double bytes_per_triangle);

/// The same for blocks of this form. A function of the tree alone, so that jobs share blocks.
[[nodiscard]] std::uint32_t choose_depth(const ObbTree& tree, SubtreeForm form);

} // namespace cd
