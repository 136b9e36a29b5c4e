// Wide trees of whole bodies that a worker makes of cached blocks.
#pragma once

#include "common/tree/partial_tree.hpp"
#include "common/tree/wide/wide_tree.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

namespace cd {

/// Joins the blocks of a tree after many descents of it with all blocks cached, and adds support
/// points after many more, so that short jobs do not pay for either. A joined tree is valid for one
/// snapshot of the blocks (`SubtreeCache::snapshot`). Not thread-safe.
class JoinedTrees {
  public:
    using Blocks = std::shared_ptr<const PartialObbTree>;
    using Joined = std::shared_ptr<const WideTree>;

    /// The work of joining the blocks of a tree, or of adding support points to the joined tree.
    struct Step {
        TreeId tree;
        Blocks blocks; ///< All blocks of the tree, in the wide form.
        Joined joined; ///< The tree that gets support points; null if the blocks are to be joined.

        /// Returns the new joined tree. Support points take about half a second for a million
        /// triangles. Any thread may call it.
        [[nodiscard]] Joined run() const;
    };

    /// Counts a descent of a tree with these blocks. Returns the next step if it is due and the
    /// joined tree fits into about `room` bytes. Returns no other step before `end`.
    [[nodiscard]] std::optional<Step> count(TreeId tree, const Blocks& blocks, std::uint64_t room);
    /// Ends a step. Stores the joined tree unless the blocks have changed in the meantime.
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

    /// Returns the entry of a tree, and replaces it by a new one if the blocks have changed.
    Entry& entry_of(TreeId tree, const Blocks& blocks);

    std::map<TreeId, Entry> entries_;
};

} // namespace cd
