// The end of a job: nothing waits, and some workers are idle while others still work. Unbegun work
// is recalled and goes to the worker that finishes it first. Begun or unreturned work gets a
// speculative copy elsewhere if that finishes clearly earlier; the share of copied work is bounded.
//
// Used for matching by time and for ranges; the paper's strategies follow the paper.
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

    /// Nothing waits, and some workers can help others that work.
    [[nodiscard]] bool has_begun() const;
    /// Asks back and copies what idle workers would finish earlier; at most one recall is open per
    /// worker. `period`: time between two such looks, s.
    void help(double period, Actions& actions);

  private:
    /// False if nothing would finish earlier that way.
    [[nodiscard]] bool helps(WorkerProxy& from, WorkerProxy& helper, Actions& actions);
    [[nodiscard]] bool
    ask_back(const WorkerProxy& from, const WorkerProxy& helper, Actions& actions);
    [[nodiscard]] AskBack
    batch_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const;
    [[nodiscard]] AskBack
    range_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const;
    /// Number of positions to move so that both finish together; 0 if that gains less than the
    /// factor `gain`.
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
    double helped_ = -1; ///< Time of the last look, s.
};

} // namespace cd
