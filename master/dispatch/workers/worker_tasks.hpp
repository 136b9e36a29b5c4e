// The tasks in flight at one worker, and how much of them is unanswered.
#pragma once

#include "common/core/id.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "master/base/position_set.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace cd {

/// A task, named by its worker and its id.
struct Assignment {
    WorkerId worker;
    TaskId task;
};

/// The tasks with which a task shares positions. They may have ended since.
struct SharedWork {
    Assignment original;            ///< The task that this one copies; task 0 if this is no copy.
    std::vector<Assignment> copies; ///< Speculative copies of parts of this task.
    PositionSet copied;             ///< Positions that got a copy, which may be lost since.
};

/// A task at the worker, from sending until the worker reports its end.
struct TaskInFlight {
    JobId job;
    PositionSet positions;     ///< Positions that are neither answered nor returned.
    bool is_analysed = true;   ///< False: the worker finds the colliding roots.
    bool claims = false;       ///< The worker gets nothing else until the task ends.
    std::uint64_t cost_ns = 0; ///< Predicted time of the unanswered part, ns.
    double sent = 0;           ///< Send time, s.
    bool fetches = false;      ///< The worker lacked some of the task's blocks.
    double busy_seconds = 0;   ///< Thread time measured so far, over all threads.
    bool has_begun = false;    ///< The unanswered part has begun: no more recalls.
    SharedWork shared = {};
    std::shared_ptr<const PoseWindow> window = {}; ///< Poses of a range that is not on a grid.

    [[nodiscard]] std::uint64_t left() const { return positions.count(); }
    [[nodiscard]] bool is_copy() const { return shared.original.task != TaskId{}; }
    /// The unanswered positions that never got a copy.
    [[nodiscard]] PositionSet uncopied() const {
        PositionSet rest = positions;
        rest.remove(shared.copied);
        return rest;
    }
    /// Mean predicted time of the unanswered positions, which must exist; at least 1 ns.
    [[nodiscard]] std::uint64_t each_ns() const {
        return std::max<std::uint64_t>(1, cost_ns / left());
    }
};

/// Keeps the counts of all tasks up to date. Unless stated otherwise, a task that is passed must
/// exist.
class WorkerTasks {
  public:
    [[nodiscard]] const std::map<TaskId, TaskInFlight>& all() const { return tasks_; }
    /// Null if there is no such task.
    [[nodiscard]] const TaskInFlight* find(TaskId task) const;
    [[nodiscard]] const TaskInFlight& at(TaskId task) const { return tasks_.at(task); }
    /// Number of the job's tasks.
    [[nodiscard]] std::size_t count_of(JobId job) const;
    /// Number of the job's tasks that have unanswered positions.
    [[nodiscard]] std::size_t unanswered_of(JobId job) const;
    /// Number of unanswered positions.
    [[nodiscard]] std::uint64_t left() const { return left_; }
    /// Number of the job's unanswered positions.
    [[nodiscard]] std::uint64_t left_of(JobId job) const;
    /// Predicted time of the unanswered positions.
    [[nodiscard]] std::uint64_t cost_ns() const { return cost_ns_; }
    /// True if a task that claims the worker is still running (the paper's label "claimed").
    [[nodiscard]] bool have_claimed() const { return claiming_ != 0; }
    /// Number of tasks sent to the worker so far.
    [[nodiscard]] std::uint64_t sent() const { return sent_; }
    /// Number of positions that the worker has answered so far.
    [[nodiscard]] std::uint64_t answered() const { return answered_; }
    /// Time of the worker's last answer or, if later, of its first task after it was idle, s.
    [[nodiscard]] double progressed() const { return progressed_; }

    /// The task must be new.
    void start(TaskId task, TaskInFlight content);
    /// Removes positions from a task that has them. `cost_ns`: their predicted time.
    void remove(TaskId task, const PositionSet& positions, std::uint64_t cost_ns);
    /// Counts positions that the worker has answered. `now` in s.
    void note_answers(std::uint64_t positions, double now);
    /// Adds thread time measured for the task.
    void note_busy(TaskId task, double seconds) { tasks_.at(task).busy_seconds += seconds; }
    /// Marks the unanswered part of the task as begun: it cannot be recalled.
    void set_begun(TaskId task) { tasks_.at(task).has_begun = true; }
    /// Records a speculative copy of these positions of the task.
    void add_copy(TaskId task, const Assignment& copy, const PositionSet& positions);
    /// Drops the job's positions; the tasks themselves last until they end.
    void forget_positions(JobId job);
    /// Removes the task and returns it, with its unanswered part.
    TaskInFlight end(TaskId task);

  private:
    std::map<TaskId, TaskInFlight> tasks_;
    std::uint64_t left_ = 0;
    std::uint64_t cost_ns_ = 0;
    std::size_t claiming_ = 0;
    std::uint64_t sent_ = 0;
    std::uint64_t answered_ = 0;
    double progressed_ = 0;
};

} // namespace cd
