// Planned blocks of each worker: the blocks that it has once its scenarios are sent.
#pragma once

#include "common/tree/root_holders.hpp"
#include "master/dispatch/dispatch_tree.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace cd {

/// A tree, and for each distribution root the workers that hold it, by their slots.
struct PlannedTree {
    /// For each root, the workers that hold it, or soon will because they got a scenario that needs
    /// it (paper, 5.1 and 6.4.5).
    RootHolders held;
    /// The part of `held` whose blocks may still be under way.
    RootHolders coming;
    std::vector<std::uint32_t> triangles; ///< Number of triangles below each root.
    std::vector<std::uint32_t> bytes_64;  ///< Wire size of each root's block, in units of 64 bytes.
    std::uint64_t triangles_total = 0;
    std::uint64_t bytes_total = 0;

    /// Wire size of the root's block, rounded up.
    [[nodiscard]] std::uint64_t bytes_of(RootIndex root) const {
        return bytes_unit * bytes_64[root];
    }
    static constexpr std::uint64_t bytes_unit = 64;
};

/// Matching decides on this plan. A block counts as held from the moment when a scenario that needs
/// it is assigned to the worker, before anything is sent. `BlockIndex` (master/blocks) has what
/// workers report instead, and decides on transfers
/// (docs/decisions/030-a-plan-and-an-index-of-blocks.md).
///
/// A worker is named by its slot in the `WorkerPool`, which decides which slots are taken.
class BlockPlan {
  public:
    // ---- Workers ------------------------------------------------------------------------------
    /// Adds a new worker at a free slot. It holds nothing yet.
    void join(std::uint32_t slot);
    /// Removes the worker at the slot, and forgets the blocks that it held.
    void leave(std::uint32_t slot);
    /// Triangles of all blocks that the worker holds.
    [[nodiscard]] std::uint64_t held_triangles(std::uint32_t slot) const {
        return held_triangles_[slot];
    }

    // ---- Trees --------------------------------------------------------------------------------
    /// Does nothing if the plan has the tree already.
    void add_tree(const DispatchTree& tree);
    void remove_tree(TreeId tree);
    /// The tree must have been added.
    [[nodiscard]] const PlannedTree& tree(TreeId tree) const;

    // ---- Blocks -------------------------------------------------------------------------------
    /// Blocks of a tree that a worker lacks and must receive.
    struct Missing {
        TreeId tree;
        std::vector<RootIndex> roots; ///< In the order passed to `hold`.
        std::uint64_t bytes = 0;
    };
    /// Marks the roots as held by the worker. Returns the roots that it did not hold before, and
    /// marks these as coming.
    Missing hold(std::uint32_t slot, TreeId tree, std::span<const WeightedRoot> roots);
    Missing hold(std::uint32_t slot, TreeId tree, std::span<const RootIndex> roots);
    /// Marks blocks that the worker has reported as held and arrived. Ignores unknown trees and
    /// roots out of range.
    void arrived(std::uint32_t slot, TreeId tree, std::span<const RootIndex> roots);
    /// Marks the blocks of an answered scenario as arrived. Ignores unknown trees.
    void arrived(std::uint32_t slot, TreeId tree, std::span<const WeightedRoot> roots);
    /// Marks roots as no longer held by the worker. Ignores unknown trees and roots out of range.
    void release(std::uint32_t slot, TreeId tree, std::span<const RootIndex> roots);

    /// Aborts unless free slots hold nothing, coming roots count as held, and all sums are right.
    /// `taken`: for each slot, whether a worker has it.
    void check(const std::vector<bool>& taken) const;

  private:
    void hold_root(std::uint32_t slot, PlannedTree& tree, RootIndex root, Missing& missing);
    /// Checks the tree, and adds the triangles that each slot holds of it to `sums`.
    static void check_tree(const PlannedTree& tree,
                           const std::vector<bool>& taken,
                           std::vector<std::uint64_t>& sums);

    std::map<TreeId, PlannedTree> trees_;
    std::vector<std::uint64_t> held_triangles_; ///< Indexed by slot.
};

} // namespace cd
