// A worker's tree: the top, with a slot for each distribution root (paper, section 6.3).
#pragma once

#include "common/tree/cut.hpp"
#include "common/tree/subtree_block.hpp"

#include <memory>
#include <vector>

namespace cd {

/// The paper's "parallel OBB tree". Slots are empty until filled; a scenario holds the subtrees
/// that it uses by shared pointers, so a slot may be emptied while one runs.
class PartialObbTree {
  public:
    explicit PartialObbTree(TreeTop top)
        : top_(std::make_shared<const TreeTop>(std::move(top))), slots_(top_->root_count()) {}

    /// Copies share it.
    [[nodiscard]] const TreeTop& top() const { return *top_; }
    /// Null while the subtree is not here.
    [[nodiscard]] const std::shared_ptr<const Subtree>& at(RootIndex root) const {
        return slots_[root];
    }
    void fill(RootIndex root, std::shared_ptr<const Subtree> subtree) {
        slots_[root] = std::move(subtree);
    }
    void empty(RootIndex root) { slots_[root].reset(); }

    /// Those of `roots` whose slots are empty.
    [[nodiscard]] std::vector<RootIndex> missing(std::span<const RootIndex> roots) const;

  private:
    std::shared_ptr<const TreeTop> top_;
    std::vector<std::shared_ptr<const Subtree>> slots_;
};

} // namespace cd
