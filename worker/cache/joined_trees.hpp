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
/// points after many more, so that short jobs do not pay for either. A joined tree belongs to one
/// snapshot of the blocks (`SubtreeCache::snapshot`), which a parked tree keeps: later jobs with
/// the same bodies use it again. Not thread-safe.
class JoinedTrees {
  public:
    using Blocks = std::shared_ptr<const PartialObbTree>;
    using Joined = std::shared_ptr<const WideTree>;

    /// The work of joining the blocks of a tree, or of adding support points to the joined tree.
    struct Step {
        Blocks blocks; ///< All blocks of the tree, in the wide form.
        Joined joined; ///< The tree that gets support points; null if the blocks are to be joined.

        /// Returns the new joined tree. Support points take about half a second for a million
        /// triangles. Any thread may call it.
        [[nodiscard]] Joined run() const;
    };

    /// Counts a descent of a tree with these blocks. Returns the next step if it is due and fits
    /// into about `bytes_max` bytes beside the other joined trees. To make room, drops the ones
    /// that no recent descent has used. Returns no other step before `end`.
    [[nodiscard]] std::optional<Step> count(const Blocks& blocks, std::uint64_t bytes_max);
    /// Ends a step. Stores the joined tree unless `keep_within` has dropped its blocks' entry.
    void end(const Step& step, Joined joined);
    /// The joined tree of these blocks; null if there is none.
    [[nodiscard]] Joined find(const Blocks& blocks) const;
    /// Drops joined trees of released blocks, then the least recently used ones until the others
    /// take at most `bytes_max`.
    void keep_within(std::uint64_t bytes_max);
    [[nodiscard]] std::uint64_t bytes() const; ///< Memory of the joined trees.

  private:
    struct Entry {
        std::weak_ptr<const PartialObbTree> blocks;
        bool is_joinable = false; ///< No block is missing, and all have the wide form.
        std::uint32_t descents = 0;
        std::uint64_t last_use = 0; ///< The value of `descents_` at the last descent.
        bool is_under_way = false;  ///< A step has begun.
        Joined joined;              ///< Null before the first step has ended.
    };
    using Entries = std::map<const PartialObbTree*, Entry>;

    /// Returns the entry of the blocks; makes one if there is none.
    Entry& entry_of(const Blocks& blocks);
    /// The joined tree whose last use is longest ago; the end if there is none.
    [[nodiscard]] Entries::iterator least_recently_used();

    Entries entries_;            ///< Once its tree is released, a new tree may get its address.
    std::uint64_t descents_ = 0; ///< Of all trees.
};

} // namespace cd
