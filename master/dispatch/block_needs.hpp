// Which blocks workers miss for scenarios and ranges, and what that costs.
#pragma once

#include "master/dispatch/dispatch_actions.hpp"
#include "master/dispatch/work_queue.hpp"
#include "master/dispatch/workers/cluster_pace.hpp"
#include "master/dispatch/workers/worker_pool.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Missing blocks of both trees of a job.
struct MissingOfJob {
    WorkerPool::Missing a;
    WorkerPool::Missing b;

    [[nodiscard]] bool is_nothing() const { return a.roots.empty() && b.roots.empty(); }
    /// Announces the blocks to the worker.
    void hint(const WorkerProxy& proxy, const DispatchJob& job, Actions& actions);
};

/// Marks blocks as held by the workers that get them, and measures what they miss.
class BlockNeeds {
  public:
    BlockNeeds(WorkerPool& pool, const ClusterPace& pace) : pool_(pool), pace_(pace) {}

    /// The worker gets the scenario: what it misses is under way, and is sampled. Returns it.
    MissingOfJob hold(DispatchJob& job, DispatchScenario& scenario, WorkerProxy& proxy);
    /// The worker gets these roots, not sampled. Returns the missing blocks, which are under way.
    MissingOfJob hold_roots(const DispatchJob& job, const ScenarioRoots& roots, WorkerProxy& proxy);
    /// The worker requests these blocks for the ranges that it has, and counts as holding them.
    void hold_wanted(WorkQueue& queue,
                     WorkerProxy& proxy,
                     TreeId tree,
                     std::span<const RootIndex> roots);
    /// As `Dispatcher::missing_costs`.
    [[nodiscard]] MissingCosts costs_of(const DispatchJob& job) const;

  private:
    [[nodiscard]] double seconds_with_any(const DispatchJob& job, const DispatchScenario& scenario);
    /// Fraction of both trees' roots that the worker does not hold.
    [[nodiscard]] double missing_share(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] double seconds_of(const MissingOfJob& missing, const WorkerProxy& proxy) const;

    WorkerPool& pool_;
    const ClusterPace& pace_;
    std::vector<std::uint64_t> held_triangles_; ///< Scratch buffer, indexed by slot.
};

} // namespace cd
