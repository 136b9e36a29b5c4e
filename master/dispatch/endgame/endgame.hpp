// The end of a job: nothing waits, and some workers are idle while others still work. Work that a
// straggler has not begun is recalled for a worker that finishes it earlier. Work that is begun or
// not returned gets a speculative copy if that finishes much earlier; the copied share is bounded.
//
// Applies to ranges, and to strategies that move work; the paper's strategies do without it.
#pragma once

#include "master/dispatch/blocks/block_needs.hpp"
#include "master/dispatch/endgame/stragglers.hpp"

#include <cstdint>

namespace cd {

class Endgame {
  public:
    Endgame(const MatchingContext& context, WorkQueue& queue, TaskTable& tasks, BlockNeeds& blocks)
        : context_(context),
          queue_(queue),
          tasks_(tasks),
          blocks_(blocks),
          stragglers_(context, tasks) {}

    /// True if nothing waits, and some workers can help others that work.
    [[nodiscard]] bool has_begun() const;
    /// Recalls or copies work that idle workers would finish earlier. Does nothing if the last
    /// check was less than `period` seconds ago.
    void help(double period, Actions& actions);

  private:
    /// Recalls or copies work of `from` for the helper. False if that would gain nothing.
    [[nodiscard]] bool helps(WorkerProxy& from, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool
    ask_back(const WorkerProxy& from, const WorkerProxy& helper, Actions& actions);
    /// The last positions of an analysed task that the helper would finish earlier, by the job's
    /// policy.
    [[nodiscard]] PositionSet scenarios_to_ask(const WorkerProxy& from,
                                               const TaskInFlight& task,
                                               const WorkerProxy& helper) const;
    /// The last positions of a task without analysis that the helper would finish earlier, by the
    /// workers' measured rates.
    [[nodiscard]] PositionSet positions_to_ask(const WorkerProxy& from,
                                               const TaskInFlight& task,
                                               const WorkerProxy& helper) const;
    /// Number of positions to move so that both workers finish together. 0 unless the helper would
    /// finish one position `gain` times sooner than the straggler, which needs `seconds_here`.
    [[nodiscard]] std::uint64_t positions_to_move(const WorkerProxy& from,
                                                  const DispatchJob& job,
                                                  const WorkerProxy& helper,
                                                  double seconds_here,
                                                  double gain) const;
    [[nodiscard]] bool copy(const WorkerProxy& from, WorkerProxy& helper, Actions& actions);
    /// The last candidate of an analysed task, if copying it to the helper pays.
    [[nodiscard]] PositionSet scenario_to_copy(const WorkerProxy& from,
                                               const TaskInFlight& task,
                                               const PositionSet& candidates,
                                               const WorkerProxy& helper) const;
    /// The last candidates of a task without analysis, as many as pay.
    [[nodiscard]] PositionSet positions_to_copy(const WorkerProxy& from,
                                                const TaskInFlight& task,
                                                const PositionSet& candidates,
                                                const WorkerProxy& helper) const;

    MatchingContext context_;
    WorkQueue& queue_;
    TaskTable& tasks_;
    BlockNeeds& blocks_;
    Stragglers stragglers_;
    double helped_ = -1; ///< Time of the last check for stragglers, s.
};

} // namespace cd
