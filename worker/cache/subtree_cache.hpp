// The subtrees that a worker holds, within a limit of memory, and the tops of their trees.
#pragma once

#include "common/core/result.hpp"
#include "common/tree/partial_tree.hpp"
#include "proto/messages/work_messages.hpp"

#include <compare>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <variant>
#include <vector>

namespace cd {

struct SubtreeKey {
    TreeId tree;
    RootIndex root = 0; ///< Where documented, also `top_root`.

    friend auto operator<=>(const SubtreeKey&, const SubtreeKey&) = default;
};

/// The decoded content of a block.
using OpenedBlock = std::variant<std::shared_ptr<const Subtree>, std::shared_ptr<const TreeTop>>;

/// Decompresses a block, checks its hash and decodes it. Independent of any cache, for any thread.
/// Errors: BadFrame, TooLarge.
[[nodiscard]] Result<OpenedBlock> open_block(const SubtreeBlock& block);

/// The trees that the master has named, with their slots. Beyond the limit the subtrees that went
/// unused for longest leave, except those that are pinned; so the limit may be overshot by what
/// is pinned. A top stays with its tree. One thread at a time.
class SubtreeCache {
  public:
    explicit SubtreeCache(std::uint64_t bytes_max) : bytes_max_(bytes_max) {}

    /// What is parked under this name of its blocks is there at once. Errors: BadFrame for a tree
    /// that is there already, or has no roots, or more than triangles.
    [[nodiscard]] Status add_tree(const AddTree& add);
    /// The numbers of all trees mean nothing any more: they wait under their names for a tree of
    /// the same name, and may leave like any others. Nothing is pinned.
    void park();
    /// The names of parked trees of which blocks are here, ascending.
    [[nodiscard]] std::vector<Sha256> parked() const;
    void drop_parked();
    /// The trees that are not parked, ascending.
    [[nodiscard]] std::vector<TreeId> trees() const;
    /// The blocks that are here, ascending: roots, and `top_root`.
    [[nodiscard]] std::vector<RootIndex> held(TreeId tree) const;
    /// Frees the tree with its blocks. Unknown trees are ignored.
    void remove_tree(TreeId tree);
    /// Null for an unknown tree.
    [[nodiscard]] const PartialObbTree* find(TreeId tree) const;
    /// The form of the subtrees of a known tree.
    [[nodiscard]] SubtreeForm form_of(TreeId tree) const { return trees_.at(tree).named.form; }

    /// Fills a slot, or sets the top. What is there already, or of an unknown tree, is ignored.
    /// `block`, what it was made of, is kept with it to be handed on; null: it is not. Errors:
    /// BadFrame for a root that the tree does not have, a subtree of another form than the tree's,
    /// a top of another number of roots or triangles, or a top and a subtree that do not agree.
    [[nodiscard]] Status insert(const SubtreeKey& key,
                                OpenedBlock opened,
                                std::shared_ptr<const SubtreeBlock> block = nullptr);
    /// The tree with what is here now, whatever leaves later; what has left stays in memory until
    /// all of it have gone. Null for an unknown tree.
    [[nodiscard]] std::shared_ptr<const PartialObbTree> snapshot(TreeId tree);
    /// Counts as a use of a subtree, if it is here.
    void touch(const SubtreeKey& key);
    /// Null while it is not here.
    [[nodiscard]] std::shared_ptr<const Subtree> at(const SubtreeKey& key) const;
    /// The subtree is here, or the top.
    [[nodiscard]] bool has(const SubtreeKey& key) const;
    /// Null while it is not here, or was not kept. Of the top as well.
    [[nodiscard]] std::shared_ptr<const SubtreeBlock> block_at(const SubtreeKey& key) const;

    /// A pinned slot keeps its subtree, also one that has yet to come. Unpinning counts as a use.
    void pin(const SubtreeKey& key);
    void unpin(const SubtreeKey& key);

    /// Evicts as if this were the limit. Returns how many subtrees left.
    std::size_t let_go(std::uint64_t bytes);
    /// The subtrees evicted since the last call, in order, except those of removed trees.
    [[nodiscard]] std::vector<SubtreeKey> take_evicted();

    /// What the subtree, or the top, will take in memory, roughly; known before it is here.
    [[nodiscard]] std::uint64_t bytes_expected(const SubtreeKey& key) const;
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    /// Counts since the start.
    [[nodiscard]] std::uint64_t evictions() const { return evictions_; }
    [[nodiscard]] std::uint64_t bytes_max() const { return bytes_max_; }

  private:
    struct Slot {
        std::shared_ptr<const SubtreeBlock> block;
        bool is_pinned = false;
        bool is_idle = false; ///< Is in `idle_`.
        std::list<SubtreeKey>::iterator place;
    };
    struct Tree {
        explicit Tree(const AddTree& add) : named(add), partial(add.roots), slots(add.roots) {}
        AddTree named;
        PartialObbTree partial;
        std::shared_ptr<const PartialObbTree> snapshot; ///< Of `partial`; null when it has changed.
        std::vector<Slot> slots;
        std::shared_ptr<const SubtreeBlock> top_block;
    };

    /// Of a slot that is filled.
    [[nodiscard]] static std::uint64_t bytes_of(const Tree& tree, RootIndex root);
    [[nodiscard]] static std::uint64_t bytes_of_top(const Tree& tree); ///< 0 while it is not here.
    [[nodiscard]] Status fill(const SubtreeKey& key,
                              Tree& tree,
                              std::shared_ptr<const Subtree> subtree,
                              std::shared_ptr<const SubtreeBlock> block);
    [[nodiscard]] Status set_top(Tree& tree,
                                 std::shared_ptr<const TreeTop> top,
                                 std::shared_ptr<const SubtreeBlock> block);
    [[nodiscard]] static bool is_parked(TreeId tree);
    void rename(TreeId from, TreeId to);
    Tree* find_tree(const SubtreeKey& key); ///< Null also for a root out of range.
    void set_idle(Slot& slot, const SubtreeKey& key);
    void evict_beyond_limit() { evict_beyond(bytes_max_); }
    void evict_beyond(std::uint64_t bytes_max);

    std::uint64_t bytes_max_;
    std::uint64_t bytes_ = 0;
    std::map<TreeId, Tree> trees_;
    std::list<SubtreeKey> idle_; ///< Filled and not pinned; the longest unused first.
    std::vector<SubtreeKey> evicted_;
    std::uint64_t evictions_ = 0;
    std::uint64_t parked_last_ = 0; ///< Parked trees have numbers of their own.
};

} // namespace cd
