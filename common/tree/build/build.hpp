// Builds OBB trees.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/obb_tree.hpp"

namespace cd {

enum class BoxKind : std::uint8_t {
    Obb,  ///< A frame fitted to each node's points as a Gaussian (paper, 6.1).
    Aabb, ///< The body's own axes for every node.
};

enum class SplitRule : std::uint8_t {
    /// Minimal sum of relative segments among the splits that leave at least a quarter of the
    /// triangles on each side.
    Quarter,
    /// The paper's 6.2 to the letter: any split. It peels off single triangles on some meshes.
    Bare,
};

struct BuildOptions {
    BoxKind boxes = BoxKind::Obb;
    SplitRule rule = SplitRule::Quarter;
    /// Two measured fastest on vehicles; one costs half as much memory again for the same time.
    std::uint32_t leaf_triangles_max = 2;
    /// Under the quarter rule, a node with more triangles is split between two of 16 bins on an
    /// axis, by the same sum, instead of between any two triangles in a sorted order.
    std::uint32_t sweep_triangles_max = 32;
    bool prepare_search = true; ///< ObbTree::prepare_search. False: for who cuts and sends it only.
};

/// The same tree for any number of threads. Near n log n with the quarter rule; needs no stack
/// whose depth the input decides.
[[nodiscard]] ObbTree
build_tree(std::shared_ptr<const Mesh> mesh, const BuildOptions& options, ThreadPool& pool);

} // namespace cd
