// A self-contained copy of one distribution root's part of a tree.
#pragma once

#include "common/tree/obb_tree.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// The form of a subtree.
enum class SubtreeForm : std::uint8_t {
    Binary, ///< The paper's tree, node for node, for bodies that a wide tree cannot hold.
    Wide,   ///< The tree of all other searches, for bodies that `suits_wide_tree` accepts.
};

/// A self-contained subtree with its own vertices and local indices.
class Subtree {
  public:
    /// Makes a binary subtree. Nodes, vertices and triangles are numbered from 0 within the
    /// subtree; `triangle_ids` are indices in the mesh.
    Subtree(std::vector<ObbNode> nodes,
            std::vector<Vec3> vertices,
            std::vector<Triangle> triangles,
            std::vector<std::uint32_t> triangle_ids);
    /// Makes a wide subtree; `wide` has nodes.
    explicit Subtree(WideTree wide);

    /// Returns a view in which only the arrays of `form()` are filled.
    [[nodiscard]] TreeView view() const;
    [[nodiscard]] SubtreeForm form() const {
        return nodes_.empty() ? SubtreeForm::Wide : SubtreeForm::Binary;
    }
    [[nodiscard]] std::size_t triangle_count() const { return triangle_count_; }
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    std::vector<ObbNode> nodes_;
    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> triangle_ids_;
    WideTree wide_{WideView(), nullptr};
    std::size_t triangle_count_ = 0;
};

/// Copies the part of the tree under `node` together with its vertices, numbered in the order of
/// first use. Vertices with equal coordinates become one.
[[nodiscard]] Subtree
extract_subtree(const ObbTree& tree, std::uint32_t node, SubtreeForm form = SubtreeForm::Binary);

} // namespace cd
