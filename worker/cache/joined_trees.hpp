// Wide trees of whole bodies, joined of cached blocks.
#pragma once

#include "common/tree/partial_tree.hpp"
#include "common/tree/wide/wide_tree.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

namespace cd {

/// Joins a tree once many descents have found all of its blocks cached, and later adds support
/// points. A descent takes about `timing::walk_seconds`, so a step begins when about as much work
/// has been done on the tree as the step takes. A joined tree is valid for one snapshot of the
/// blocks (`SubtreeCache::snapshot`). Not thread-safe.
class JoinedTrees {
  public:
    using Blocks = std::shared_ptr<const PartialObbTree>;
    using Joined = std::shared_ptr<const WideTree>;

    /// The work of joining the blocks of a tree, or of adding support points to the joined tree.
    struct Step {
        TreeId tree;
        Blocks blocks; ///< All of the tree's, of the wide form.
        Joined joined; ///< Null: to be made.

        /// Returns the new joined tree. Takes some milliseconds, and for support points half a
        /// second for a million triangles. Any thread may call it.
        [[nodiscard]] Joined run() const;
    };

    /// Counts a descent of a tree with these blocks. Returns the next step if it is due, and its
    /// tree takes at most about `room` bytes. No further one is due until `end`.
    [[nodiscard]] std::optional<Step> count(TreeId tree, const Blocks& blocks, std::uint64_t room);
    /// Ends a step. Keeps its tree unless the blocks have changed since.
    void end(const Step& step, Joined joined);
    /// The joined tree of these blocks; null if there is none.
    [[nodiscard]] Joined find(TreeId tree, const Blocks& blocks) const;
    /// Drops joined trees whose blocks have changed, and all if they take more than `bytes`.
    void keep_within(std::uint64_t bytes);
    [[nodiscard]] std::uint64_t bytes() const; ///< Memory of the joined trees.

  private:
    struct Entry {
        std::weak_ptr<const PartialObbTree> blocks;
        bool is_joinable = false; ///< No block is missing, and all have the wide form.
        std::uint32_t descents = 0;
        bool is_under_way = false; ///< A step has begun.
        Joined joined;             ///< Null before the first step has ended.
    };

    /// Returns the entry of a tree, which is a new one if the blocks have changed.
    Entry& entry_of(TreeId tree, const Blocks& blocks);

    std::map<TreeId, Entry> entries_;
};

} // namespace cd
