// Builds OBB trees.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace cd {

enum class BoxKind : std::uint8_t {
    Obb,  ///< Fits each node's frame to a Gaussian of the node's points (paper, 6.1).
    Aabb, ///< Uses the body's own axes for every node.
};

enum class SplitRule : std::uint8_t {
    /// Minimises the sum of relative segments (the two children's extents on an axis, relative to
    /// the node's) among the splits that leave at least a quarter of the triangles on each side.
    Quarter,
    /// Follows the paper's 6.2 to the letter: any split is allowed. This rule peels off single
    /// triangles on some meshes.
    Bare,
};

struct BuildOptions {
    BoxKind boxes = BoxKind::Obb;
    SplitRule rule = SplitRule::Quarter;
    /// A node with more triangles is split. Two is the fastest measured on vehicles; one takes half
    /// as much memory again for the same time.
    std::uint32_t leaf_triangles_max = 2;
    /// Under SplitRule::Quarter, a node with more triangles is split between two of 16 bins on an
    /// axis; a smaller node is split between any two triangles in sorted order.
    std::uint32_t sweep_triangles_max = 32;
    /// Calls ObbTree::prepare_search. False suits a caller that only cuts and sends the tree.
    bool prepare_search = true;
};

/// Builds the tree of a mesh. The number of threads does not change the tree. Takes about n log n
/// time with the quarter rule. The depth of the stack does not depend on the input.
[[nodiscard]] ObbTree
build_tree(std::shared_ptr<const Mesh> mesh, const BuildOptions& options, ThreadPool& pool);

/// Builds the same tree. Returns nothing soon after `stop` returns true, which only the calling
/// thread polls and which may not throw.
[[nodiscard]] std::optional<ObbTree> build_tree_until(const StopCheck& stop,
                                                      std::shared_ptr<const Mesh> mesh,
                                                      const BuildOptions& options,
                                                      ThreadPool& pool);

} // namespace cd
