// One distribution root's part of a tree, on its own.
#pragma once

#include "common/tree/obb_tree.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// Which tree a subtree has.
enum class SubtreeForm : std::uint8_t {
    Binary, ///< The paper's, node for node: which boxes a tolerance leaves open hangs on it.
    Wide,   ///< What exact searches walk. Of bodies that `suits_wide_tree` takes.
};

/// A subtree that stands on its own: its own vertices, local indices.
class Subtree {
  public:
    /// Binary, its nodes renumbered from 0.
    Subtree(std::vector<ObbNode> nodes,
            std::vector<Vec3> vertices,
            std::vector<Triangle> triangles,
            std::vector<std::uint32_t> triangle_ids);
    /// With nodes.
    explicit Subtree(WideTree wide);

    /// Shows one of the two trees.
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

/// The part of the tree under `node`, with each vertex that it uses once, numbered in the order of
/// first use. Vertices with equal coordinates become one.
[[nodiscard]] Subtree
extract_subtree(const ObbTree& tree, std::uint32_t node, SubtreeForm form = SubtreeForm::Binary);

} // namespace cd
