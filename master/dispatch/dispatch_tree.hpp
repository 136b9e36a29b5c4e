// The dispatcher's view of a job's trees: the sizes of their subtrees.
#pragma once

#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

struct DispatchTree {
    TreeId tree;
    std::vector<std::uint32_t> root_triangles; ///< Triangles below each distribution root.
    /// Wire size of each root's block, bytes. If empty, `BlockPlan` estimates the sizes.
    std::vector<std::uint64_t> root_bytes = {};
};

/// The tree of each body of a job. Bodies of one mesh may share a tree.
class DispatchTrees {
  public:
    using Tree = std::shared_ptr<const DispatchTree>;

    explicit DispatchTrees(std::vector<Tree> by_body);
    /// The trees of two bodies.
    DispatchTrees(DispatchTree a, DispatchTree b);

    [[nodiscard]] const DispatchTree& of(std::uint32_t body) const { return *by_body_.at(body); }
    /// Each tree once, ascending by its id.
    [[nodiscard]] std::span<const Tree> distinct() const { return distinct_; }
    /// Whether a body has the tree.
    [[nodiscard]] bool have(TreeId tree) const;

  private:
    std::vector<Tree> by_body_;
    std::vector<Tree> distinct_;
};

} // namespace cd
