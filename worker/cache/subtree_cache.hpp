// A worker's cache of subtrees within a memory limit, and the upper trees above them.
#pragma once

#include "worker/cache/cached_tree.hpp"

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <variant>
#include <vector>

namespace cd {

/// A decoded block: a subtree or an upper tree.
using OpenedBlock = std::variant<std::shared_ptr<const Subtree>, std::shared_ptr<const TreeTop>>;

/// Decompresses a block, checks its hash and decodes it. Any thread may call it.
/// Errors: BadFrame, TooLarge.
[[nodiscard]] Result<OpenedBlock> open_block(const SubtreeBlock& block);

/// Contains the trees that the master has named, and parked trees: those that it named before,
/// under ids that are no longer valid. A parked tree keeps its blocks until `add_tree` names its
/// cut again.
///
/// Above the limit, evicts blocks of parked trees first, in the order in which the trees were
/// parked, each upper tree last; then the least recently used subtrees. Never evicts pinned
/// subtrees, which may exceed the limit, nor upper trees that are not parked. Not thread-safe.
class SubtreeCache {
  public:
    explicit SubtreeCache(std::uint64_t bytes_max) : bytes_max_(bytes_max) {}

    /// Adds a tree and reuses the parked blocks with the same `cut`. Errors: BadFrame for a tree
    /// that exists already, has no roots, or has more roots than triangles.
    [[nodiscard]] Status add_tree(const AddTree& add);
    /// Parks the tree, with its subtrees unpinned. Drops a tree without blocks, and above
    /// `limits::parked_trees_max` the tree that was parked first. Ignores unknown trees.
    void park(TreeId tree);
    /// Parks all trees, at the end of a session.
    void park_all();
    /// The cuts of parked trees with cached blocks, ascending.
    [[nodiscard]] std::vector<Sha256> parked() const;
    void drop_parked();
    /// The trees that are not parked, ascending by id.
    [[nodiscard]] std::vector<TreeId> trees() const;
    /// The roots of the tree's cached blocks, ascending; `top_root` means the upper tree.
    [[nodiscard]] std::vector<RootIndex> held(TreeId tree) const;
    /// The tree with its cached blocks; null for an unknown tree.
    [[nodiscard]] const PartialObbTree* find(TreeId tree) const;
    /// The form of the tree's subtrees. The tree must be known.
    [[nodiscard]] SubtreeForm form_of(TreeId tree) const { return trees_.at(tree).named().form; }

    /// Adds a subtree or an upper tree. Ignores unknown trees and blocks that are cached already.
    /// Keeps `block`, the encoded form, for other workers; null keeps nothing. Errors: those of
    /// `CachedTree::fill` and `CachedTree::set_top`.
    [[nodiscard]] Status insert(const SubtreeKey& key,
                                OpenedBlock opened,
                                std::shared_ptr<const SubtreeBlock> block = nullptr);
    /// An immutable view of the tree with the blocks cached now. The view keeps subtrees in memory
    /// that are evicted later, until it is released. Null for an unknown tree.
    [[nodiscard]] std::shared_ptr<const PartialObbTree> snapshot(TreeId tree);
    /// Marks a cached subtree as just used.
    void touch(const SubtreeKey& key);
    /// The subtree; null if it is not cached.
    [[nodiscard]] std::shared_ptr<const Subtree> at(const SubtreeKey& key) const;
    /// Whether the subtree, or the upper tree, is cached.
    [[nodiscard]] bool has(const SubtreeKey& key) const;
    /// The encoded form of a cached subtree or upper tree; null if not cached or not kept.
    [[nodiscard]] std::shared_ptr<const SubtreeBlock> block_at(const SubtreeKey& key) const;

    /// Protects a subtree, even before it arrives, from eviction until `unpin`, which is a use.
    void pin(const SubtreeKey& key);
    void unpin(const SubtreeKey& key);

    /// Evicts blocks until the cache takes at most `bytes`. Returns the number evicted.
    std::size_t let_go(std::uint64_t bytes);
    /// The subtrees evicted since the last call, in order, except those of parked trees.
    [[nodiscard]] std::vector<SubtreeKey> take_evicted();

    /// Estimated memory of a subtree or upper tree, in bytes, before the block has arrived.
    [[nodiscard]] std::uint64_t bytes_expected(const SubtreeKey& key) const;
    /// Memory of all cached blocks, in bytes.
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    /// Memory of the blocks of trees that are not parked, in bytes.
    [[nodiscard]] std::uint64_t bytes_in_use() const { return bytes_ - parked_.bytes; }
    /// Number of evictions in all sessions of the process.
    [[nodiscard]] std::uint64_t evictions() const { return evictions_; }
    [[nodiscard]] std::uint64_t bytes_max() const { return bytes_max_; }

  private:
    using Slot = CachedTree::Slot;
    using Trees = std::map<TreeId, CachedTree>;

    struct ParkedTrees {
        /// Of each tree the cached subtrees, then `top_root`; first those of the tree parked first.
        std::list<SubtreeKey> blocks;
        std::size_t trees = 0;
        std::uint64_t bytes = 0;
        std::uint64_t last = 0; ///< Counter for the ids of parked trees.
    };

    void unpark(Trees::iterator parked, TreeId id);
    void drop(Trees::iterator parked);
    CachedTree* find_tree(const SubtreeKey& key); ///< Null for an unknown tree or root.
    void set_idle(Slot& slot, const SubtreeKey& key);
    void evict_beyond(std::uint64_t bytes_max);

    std::uint64_t bytes_max_;
    std::uint64_t bytes_ = 0;
    Trees trees_; ///< The parked ones last, in the order in which they were parked.
    /// Cached subtrees of trees that are not parked, not pinned; least recently used first.
    std::list<SubtreeKey> idle_;
    ParkedTrees parked_;
    std::vector<SubtreeKey> evicted_; ///< Subtrees evicted since the last `take_evicted`.
    std::uint64_t evictions_ = 0;
};

} // namespace cd
