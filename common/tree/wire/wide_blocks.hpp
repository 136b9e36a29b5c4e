// Makes blocks of the triangles of a wide tree's leaves, by several threads.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/wide/wide_leaves.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The arrays that a TriangleBlocks views, without spare capacity.
struct WideBlocks {
    std::vector<float> floats;
    std::vector<double> doubles;
    std::vector<std::uint32_t> vertex_begin;
    std::vector<BlockCorners> corners;
    std::vector<std::uint32_t> ids;
    double reach = 0; ///< Largest absolute coordinate.

    [[nodiscard]] TriangleBlocks view() const {
        return {floats, doubles, vertex_begin, corners, ids, reach};
    }
};

/// Makes block k from the triangles of leaf `leaf_of_block[k]`. With Precision::Float, all vertices
/// must be floats. The result is equal for any number of threads.
[[nodiscard]] WideBlocks make_wide_blocks(const TreeView& tree,
                                          const WideLeaves& leaves,
                                          std::span<const std::uint32_t> leaf_of_block,
                                          Precision precision,
                                          ThreadPool* pool);

} // namespace cd
