// The end of a job: nothing waits, and some workers are idle while others still work. Work that a
// straggler has not begun is recalled for a worker that finishes it earlier. Work that is begun or
// not returned gets a speculative copy if that finishes much earlier; the copied share is bounded.
//
// Applies to ranges, and to strategies that move work; the paper's strategies do without it.
#pragma once

#include "master/dispatch/endgame/speculative_copies.hpp"
#include "master/dispatch/endgame/stragglers.hpp"

namespace cd {

class Endgame {
  public:
    Endgame(const MatchingContext& context, TaskTable& tasks, BlockNeeds& blocks)
        : context_(context),
          tasks_(tasks),
          stragglers_(context, tasks),
          copies_(context, tasks, blocks, stragglers_) {}
    Endgame(const Endgame&) = delete;
    Endgame& operator=(const Endgame&) = delete;

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

    MatchingContext context_;
    TaskTable& tasks_;
    Stragglers stragglers_;
    SpeculativeCopies copies_;
    double helped_ = -1; ///< Time of the last check for stragglers, s.
};

} // namespace cd
