// Finds the blocks that workers miss for scenarios and ranges, and the time to fetch them.
#pragma once

#include "master/dispatch/blocks/block_plan.hpp"
#include "master/dispatch/dispatch_actions.hpp"
#include "master/dispatch/work_queue.hpp"
#include "master/dispatch/workers/cluster_pace.hpp"
#include "master/dispatch/workers/worker_pool.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Blocks of a scenario's two trees that a worker lacks.
struct MissingBlocks {
    std::array<BlockPlan::Missing, 2> of_trees;

    [[nodiscard]] bool is_nothing() const {
        return of_trees[0].roots.empty() && of_trees[1].roots.empty();
    }
    /// Adds actions that announce the blocks to the worker. Empties both lists of roots.
    void hint(const WorkerProxy& proxy, const DispatchJob& job, Actions& actions);
};

/// Marks blocks as held by the workers that get them, and measures the time to fetch missing ones.
class BlockNeeds {
  public:
    BlockNeeds(BlockPlan& plan, const WorkerPool& pool, const ClusterPace& pace)
        : plan_(plan), pool_(pool), pace_(pace) {}

    /// Marks the scenario's blocks as held by the worker, and measures the time to fetch the
    /// missing ones. Returns the missing blocks, which now count as under way.
    MissingBlocks hold(DispatchJob& job, DispatchScenario& scenario, WorkerProxy& proxy);
    /// Like `hold`, but measures nothing.
    MissingBlocks hold_roots(const ScenarioRoots& roots, WorkerProxy& proxy);
    /// Marks blocks as held by a worker that requests them for ranges, and measures their transfer.
    void hold_wanted(WorkQueue& queue,
                     WorkerProxy& proxy,
                     TreeId tree,
                     std::span<const RootIndex> roots);
    /// Time to fetch missing blocks, for the choice of ranges (`DispatchView::missing_costs`).
    [[nodiscard]] MissingCosts costs_of(const DispatchJob& job) const;

  private:
    /// Time to fetch the scenario's missing blocks, averaged over all workers.
    [[nodiscard]] double seconds_with_any(const DispatchScenario& scenario);
    /// Fraction of the job's roots, over all its trees, that the worker does not hold.
    [[nodiscard]] double missing_share(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] double seconds_of(const MissingBlocks& missing, const WorkerProxy& proxy) const;

    BlockPlan& plan_;
    const WorkerPool& pool_;
    const ClusterPace& pace_;
    std::vector<std::uint64_t> held_triangles_; ///< Scratch buffer, indexed by worker slot.
};

} // namespace cd
