// The end of a job: nothing waits, and some workers are idle while others still work. Work that a
// straggler has not begun is recalled for a worker that finishes it earlier. Work that is begun or
// not returned gets a speculative copy if that finishes much earlier; the copied share is bounded.
//
// Applies to matching by time and to ranges; the paper's strategies do without it.
#pragma once

#include "master/dispatch/block_needs.hpp"
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
    /// Returns a request for the scenarios of a batch that the helper would finish earlier, if any.
    [[nodiscard]] AskBack
    batch_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const;
    /// Returns a request for as many last positions of a range as the helper would finish earlier.
    /// It asks for none if `places` equals the range's length.
    [[nodiscard]] AskBack
    range_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const;
    /// Number of positions to move so that both workers finish together. 0 unless the helper would
    /// finish one position `gain` times sooner than the straggler, which needs `seconds_here`.
    [[nodiscard]] std::uint64_t places_to_move(const WorkerProxy& from,
                                               const DispatchJob& job,
                                               const WorkerProxy& helper,
                                               double seconds_here,
                                               double gain) const;
    [[nodiscard]] bool copy(WorkerProxy& from, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool
    copy_scenario(const WorkerProxy& from, TaskId task, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool
    copy_places(WorkerProxy& from, TaskId task, WorkerProxy& helper, Actions& actions);

    MatchingContext context_;
    WorkQueue& queue_;
    TaskTable& tasks_;
    BlockNeeds& blocks_;
    Stragglers stragglers_;
    double helped_ = -1; ///< Time of the last check for stragglers, s.
};

} // namespace cd
