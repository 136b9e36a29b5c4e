// The tasks in flight at one worker, and how much of them is unanswered.
#pragma once

#include "common/core/id.hpp"
#include "common/job/poses/ordered_poses.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace cd {

/// A task at the worker, from sending until the worker reports its end.
struct TaskInFlight {
    JobId job;
    std::vector<std::uint64_t> scenarios;  ///< Unanswered, in the order sent.
    bool claims = false;                   ///< The worker gets nothing else until the task ends.
    std::uint64_t cost_ns = 0;             ///< Predicted time of the unanswered part, ns.
    double sent = 0;                       ///< Send time, s.
    bool fetches = false;                  ///< The worker lacked some of the task's blocks.
    double busy_seconds = 0;               ///< Measured so far, summed over the worker's threads.
    std::optional<PlaceRange> places = {}; ///< Ranges only; `scenarios` is empty then.
    std::uint64_t places_left = 0;         ///< Unanswered positions of `places`.
    bool is_copy = false;                  ///< Speculative copy of another task.
    bool has_begun = false;                ///< The unanswered part has begun: no more recalls.
    std::uint64_t places_copied = 0;       ///< Number of last positions that have a copy.

    [[nodiscard]] bool is_range() const { return places.has_value(); }
    [[nodiscard]] std::uint64_t left() const { return scenarios.size() + places_left; }
    /// Predicted time of one unanswered position of a range, at least 1. There must be some.
    [[nodiscard]] std::uint64_t each_ns() const {
        return std::max<std::uint64_t>(1, cost_ns / places_left);
    }
};

/// Keeps the counts of all tasks up to date. Unless stated otherwise, a task that is passed must
/// exist.
class WorkerTasks {
  public:
    [[nodiscard]] const std::map<TaskId, TaskInFlight>& all() const { return tasks_; }
    [[nodiscard]] bool contains(TaskId task) const { return tasks_.contains(task); }
    [[nodiscard]] const TaskInFlight& at(TaskId task) const { return tasks_.at(task); }
    /// Number of the job's tasks.
    [[nodiscard]] std::size_t count_of(JobId job) const;
    /// Number of unanswered scenarios and positions.
    [[nodiscard]] std::uint64_t left() const { return left_; }
    /// Predicted time of the unanswered scenarios and positions.
    [[nodiscard]] std::uint64_t cost_ns() const { return cost_ns_; }
    /// True if a task that claims the worker is still running (the paper's label "claimed").
    [[nodiscard]] bool have_claimed() const { return claiming_ != 0; }
    /// The job of the task sent last; the other jobs have their turn first.
    [[nodiscard]] JobId last_job() const { return last_job_; }
    /// Number of tasks sent to the worker so far.
    [[nodiscard]] std::uint64_t sent() const { return sent_; }
    /// Number of scenarios that the worker has answered so far.
    [[nodiscard]] std::uint64_t answered() const { return answered_; }
    /// Time of the last answer or, if later, at which the idle worker got work, s.
    [[nodiscard]] double progressed() const { return progressed_; }
    void note_progress(double now) { progressed_ = now; }

    /// The task must be new.
    void start(TaskId task, TaskInFlight content);
    /// Removes a scenario from a task that has it. `here`: this worker answered it.
    void answer(TaskId task, std::uint64_t scenario, std::uint64_t cost_ns, bool here);
    /// Records `count` answers of a range, at most as many as its unanswered positions.
    void answer_places(TaskId task, std::uint64_t count);
    /// Shortens a range to its first `kept` positions, or to the answered number if that is more.
    /// Returns the positions cut off.
    PlaceRange cut_places(TaskId task, std::uint64_t kept);
    /// Marks the unanswered part of the task as begun: it cannot be recalled.
    void set_begun(TaskId task) { tasks_.at(task).has_begun = true; }
    /// Records that `places` more of a range's last positions have a speculative copy.
    void add_copied(TaskId task, std::uint64_t places) { tasks_.at(task).places_copied += places; }
    /// Adds thread time measured for the task. Ignored if the task does not exist.
    void note_busy(TaskId task, double seconds);
    /// Drops the job's scenarios; the tasks themselves last until they end.
    void forget_scenarios(JobId job);
    /// Removes the task and returns it, with its unanswered part.
    TaskInFlight end(TaskId task);

  private:
    [[nodiscard]] TaskInFlight& existing(TaskId task);
    void remove_places(TaskInFlight& task, std::uint64_t count);

    std::map<TaskId, TaskInFlight> tasks_;
    std::uint64_t left_ = 0;
    std::uint64_t cost_ns_ = 0;
    std::size_t claiming_ = 0;
    JobId last_job_;
    std::uint64_t sent_ = 0;
    std::uint64_t answered_ = 0;
    double progressed_ = 0;
};

} // namespace cd
