// Runs the tasks of a session on the worker's threads: scenarios in, results out.
#pragma once

#include "worker/execution/scenario_clock.hpp"
#include "worker/session/block_inbox.hpp"
#include "worker/session/scenario_queue.hpp"
#include "worker/session/session_hub.hpp"
#include "worker/session/task_book.hpp"
#include "worker/session/tree_joiner.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cd {

class TaskRunner {
  public:
    /// `computed` counts the scenarios computed to the end.
    TaskRunner(SessionHub& hub,
               MasterLink& master,
               BlockInbox& blocks,
               std::shared_ptr<std::atomic<std::uint64_t>> computed);

    // ---- Messages from the master -------------------------------------------------------------
    /// Adds a job. Errors: those of `TaskBook::add_job`.
    [[nodiscard]] Status add_job(AddJob add);
    void remove_job(JobId job);
    /// Removes the jobs that use the tree.
    void remove_jobs_of(TreeId tree);
    /// Adds a task. After `stop`, returns all of the task's scenarios at once. Errors: those of
    /// `TaskBook`.
    [[nodiscard]] Status add(WorkUnit unit);
    /// Returns to the master the recalled scenarios that have not begun.
    void recall(const Recall& recall);
    void drop(const DropScenario& drop);

    // ---- The session --------------------------------------------------------------------------
    /// Asks the master to send no more tasks, and returns the scenarios that have not begun.
    void stop();
    [[nodiscard]] bool is_stopping() const { return stopping_; }
    /// Stops the running scenarios and returns them to the master, too.
    void hand_back();
    /// Starts scenarios on free threads; the scenarios of `ready` have all their subtrees. Then
    /// ends the finished tasks. Returns whether the last task has ended.
    [[nodiscard]] bool settle(std::span<const ScenarioQueue::Token> ready);
    /// Sends all unsent results when the session ends.
    void leave();
    [[nodiscard]] const TaskBook& book() const { return book_; }
    /// The scenario that has run for the longest time; empty if no scenario runs.
    [[nodiscard]] std::optional<RunningScenario> longest() const { return clocks_.longest(); }

  private:
    using Entry = ScenarioQueue::Entry;

    void wait_for_subtrees(const Task& task, std::size_t scenario);
    [[nodiscard]] bool start_next();
    void start(const Entry& entry);
    /// Starts a descent, of which `entry` is the only scenario if it is from the queue.
    void start_walk(const Task& task, Walk next, const Entry& entry = {});
    /// Returns the first task with scenarios for a descent and cached upper trees, or null.
    [[nodiscard]] Task* next_to_walk();
    void scenario_ran(ScenarioQueue::Token token, const std::optional<FinishedScenarios>& finished);
    /// `token` is 0 unless the descent was for one scenario of the queue.
    void walked(TaskId task, ScenarioQueue::Token token, Walked walked);
    /// Drops and returns the scenarios that match `concerned` and have not begun.
    std::vector<Entry> drop_unbegun(const std::function<bool(const Entry&)>& concerned);
    void drop_unstarted(const std::function<bool(const Task&)>& concerned);
    void abandon(const std::function<bool(const Task&)>& concerned);
    void add_results(Task& task, const FinishedScenarios& finished);
    /// Sends the results of all tasks after `wait`, or earlier if that is planned.
    void flush_after(std::chrono::milliseconds wait);
    void flush(Task& task);
    void flush_all();
    [[nodiscard]] bool end_finished_tasks();

    SessionHub& hub_;
    MasterLink& master_;
    BlockInbox& blocks_;
    std::shared_ptr<std::atomic<std::uint64_t>> computed_;
    TreeJoiner joiner_;
    TaskBook book_;
    ScenarioQueue queue_;
    std::size_t running_ = 0; ///< Functions submitted to the threads and not yet continued.
    RunningClocks clocks_;
    bool stopping_ = false; ///< Set by `stop`.
    bool flushing_soon_ = false;
    asio::steady_timer flush_timer_;
};

} // namespace cd
