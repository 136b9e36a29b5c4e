// A worker's tree: the upper tree, with a slot for each distribution root (paper, section 6.3).
#pragma once

#include "common/tree/cut.hpp"
#include "common/tree/wire/subtree_block.hpp"

#include <memory>
#include <vector>

namespace cd {

/// The paper's "parallel OBB tree". Slots are empty until filled. A scenario holds the subtrees
/// that it uses by shared pointers, so a slot may be emptied while the scenario runs. The upper
/// tree may arrive after subtrees: a worker that receives the colliding roots needs no upper tree
/// unless it looks twice (`common/job/distance_looks.hpp`).
class PartialObbTree {
  public:
    explicit PartialObbTree(std::uint32_t root_count) : slots_(root_count) {}

    [[nodiscard]] std::uint32_t root_count() const {
        return static_cast<std::uint32_t>(slots_.size());
    }
    [[nodiscard]] bool has_top() const { return top_ != nullptr; }
    /// Returns the upper tree. Requires `has_top()`.
    [[nodiscard]] const TreeTop& top() const { return *top_; }
    /// Sets the upper tree, which has as many roots as there are slots.
    void set_top(std::shared_ptr<const TreeTop> top) { top_ = std::move(top); }

    /// Returns a root's subtree; null while the slot is empty.
    [[nodiscard]] const std::shared_ptr<const Subtree>& at(RootIndex root) const {
        return slots_[root];
    }
    void fill(RootIndex root, std::shared_ptr<const Subtree> subtree) {
        slots_[root] = std::move(subtree);
    }
    void empty(RootIndex root) { slots_[root].reset(); }

    /// Returns the elements of `roots` whose slots are empty.
    [[nodiscard]] std::vector<RootIndex> missing(std::span<const RootIndex> roots) const;

  private:
    std::shared_ptr<const TreeTop> top_;
    std::vector<std::shared_ptr<const Subtree>> slots_;
};

} // namespace cd
