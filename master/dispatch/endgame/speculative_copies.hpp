// Copies work of stragglers to idle workers that would finish it much earlier.
#pragma once

#include "master/dispatch/blocks/block_needs.hpp"
#include "master/dispatch/endgame/stragglers.hpp"

namespace cd {

/// A copy pays if the helper finishes it `limits::copy_gain_min` times sooner than the straggler.
/// Each position has one copy at most, and the copied share of a job is bounded (`CopyBudget`).
class SpeculativeCopies {
  public:
    /// All parts outlive this object.
    SpeculativeCopies(const MatchingContext& context,
                      TaskTable& tasks,
                      BlockNeeds& blocks,
                      const Stragglers& stragglers)
        : context_(context), tasks_(tasks), blocks_(blocks), stragglers_(stragglers) {}

    /// Copies to the helper the last work of `from` for which a copy pays. False if no copy pays.
    [[nodiscard]] bool copy(const WorkerProxy& from, WorkerProxy& helper, Actions& actions);

  private:
    /// The last candidate of an analysed task, if copying it to the helper pays.
    [[nodiscard]] PositionSet scenario_to_copy(const WorkerProxy& from,
                                               const TaskInFlight& task,
                                               const PositionSet& candidates,
                                               const WorkerProxy& helper) const;
    /// The last candidates of a task without analysis, at most as many as pay.
    [[nodiscard]] PositionSet positions_to_copy(const WorkerProxy& from,
                                                const TaskInFlight& task,
                                                const PositionSet& candidates,
                                                const WorkerProxy& helper) const;

    MatchingContext context_;
    TaskTable& tasks_;
    BlockNeeds& blocks_;
    const Stragglers& stragglers_;
};

} // namespace cd
