// The cached blocks of one tree: its subtrees and the upper tree above them.
#pragma once

#include "common/core/result.hpp"
#include "common/tree/partial_tree.hpp"
#include "proto/messages/work_messages.hpp"

#include <compare>
#include <cstdint>
#include <list>
#include <memory>
#include <vector>

namespace cd {

struct SubtreeKey {
    TreeId tree;
    RootIndex root = 0; ///< May be `top_root` where documented.

    friend auto operator<=>(const SubtreeKey&, const SubtreeKey&) = default;
};

/// The cached blocks of one tree. Checks that blocks belong to the tree. Not thread-safe.
class CachedTree {
  public:
    /// State of one subtree, or of the upper tree, in a `SubtreeCache`, cached or not.
    struct Slot {
        std::shared_ptr<const SubtreeBlock> block; ///< The encoded form; null: not kept.
        bool is_pinned = false;                    ///< True: must not be evicted.
        bool is_idle = false;                      ///< True: in a list of blocks to evict.
        std::list<SubtreeKey>::iterator place;     ///< Position in that list, if `is_idle`.
    };

    explicit CachedTree(const AddTree& add) : named_(add), partial_(add.roots), slots_(add.roots) {}

    /// Fills an empty slot. `block` is the encoded form, or null. Errors: BadFrame for a root that
    /// the tree lacks, and for a subtree of the wrong form or one that disagrees with the upper
    /// tree.
    [[nodiscard]] Status fill(RootIndex root,
                              std::shared_ptr<const Subtree> subtree,
                              std::shared_ptr<const SubtreeBlock> block);
    /// Sets the upper tree. Errors: BadFrame for a wrong number of roots or triangles, or for an
    /// upper tree that disagrees with a cached subtree.
    [[nodiscard]] Status set_top(std::shared_ptr<const TreeTop> top,
                                 std::shared_ptr<const SubtreeBlock> block);
    /// Drops the subtree and the block of a filled slot.
    void empty(RootIndex root);

    [[nodiscard]] const AddTree& named() const { return named_; }
    [[nodiscard]] const PartialObbTree& partial() const { return partial_; }
    /// Returns an immutable copy of `partial()`, shared until a block is added or evicted.
    [[nodiscard]] std::shared_ptr<const PartialObbTree> snapshot();
    [[nodiscard]] std::vector<Slot>& slots() { return slots_; } ///< Those of the subtrees.
    [[nodiscard]] Slot& top_slot() { return top_; }
    /// The encoded block of a subtree or of the upper tree; null if it is not cached or not kept.
    [[nodiscard]] std::shared_ptr<const SubtreeBlock> block_at(RootIndex root) const;
    /// Memory of a filled slot's subtree and encoded block, in bytes.
    [[nodiscard]] std::uint64_t bytes_of(RootIndex root) const;
    /// Memory of the upper tree and its encoded block, in bytes; 0 if not cached.
    [[nodiscard]] std::uint64_t bytes_of_top() const;
    /// Memory of all cached blocks of the tree, in bytes.
    [[nodiscard]] std::uint64_t bytes() const;
    /// Estimated memory of a subtree or of the upper tree, in bytes, before the block has arrived.
    [[nodiscard]] std::uint64_t bytes_expected(RootIndex root) const;

  private:
    AddTree named_;
    PartialObbTree partial_;
    std::shared_ptr<const PartialObbTree> snapshot_; ///< Last copy; null after `partial_` changes.
    std::vector<Slot> slots_;
    Slot top_;
};

} // namespace cd
