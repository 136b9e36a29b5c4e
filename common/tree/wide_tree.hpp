// The tree that queries walk: made of the paper's binary tree, sixteen children to a node.
#pragma once

#include "common/geometry/triangle_blocks.hpp"
#include "common/tree/obb_tree.hpp"
#include "common/tree/wide_node.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// An immutable wide tree with its triangles, shared freely between threads.
class WideTree {
  public:
    /// Collapses the binary tree at hand. Without nodes where coordinates are so large or the body
    /// so small that floats cannot hold what is made of them, and where a binary leaf has too many
    /// triangles: such bodies are searched in the binary tree.
    explicit WideTree(const TreeView& binary);

    [[nodiscard]] WideView view() const { return {nodes_, triangles_.view(), extent_}; }
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    std::vector<WideNode> nodes_;
    TriangleBlockArrays triangles_;
    double extent_ = 0;
};

} // namespace cd
