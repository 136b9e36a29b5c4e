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
    bool claims = false;                   ///< Until it ends, the worker gets nothing else.
    std::uint64_t cost_ns = 0;             ///< Predicted time of the unanswered part.
    double sent = 0;                       ///< Send time, s.
    bool fetches = false;                  ///< The worker lacked blocks of it when it was sent.
    double busy_seconds = 0;               ///< Measured so far, over the worker's threads.
    std::optional<PlaceRange> places = {}; ///< Ranges only; `scenarios` is empty then.
    std::uint64_t places_left = 0;         ///< Unanswered positions of `places`.
    bool is_copy = false;                  ///< Speculative copy of another task.
    bool has_begun = false;                ///< The rest has begun and cannot be recalled.
    std::uint64_t places_copied = 0;       ///< Number of last positions that have a copy.

    [[nodiscard]] bool is_range() const { return places.has_value(); }
    [[nodiscard]] std::uint64_t left() const { return scenarios.size() + places_left; }
    /// Predicted time of one of the unanswered positions of a range; there must be some.
    [[nodiscard]] std::uint64_t each_ns() const {
        return std::max<std::uint64_t>(1, cost_ns / places_left);
    }
};

/// Counts follow every change of a task. Unless said otherwise a named task must exist.
class WorkerTasks {
  public:
    [[nodiscard]] const std::map<TaskId, TaskInFlight>& all() const { return tasks_; }
    [[nodiscard]] bool contains(TaskId task) const { return tasks_.contains(task); }
    [[nodiscard]] const TaskInFlight& at(TaskId task) const { return tasks_.at(task); }
    /// Tasks of the job.
    [[nodiscard]] std::size_t count_of(JobId job) const;
    /// Unanswered scenarios.
    [[nodiscard]] std::uint64_t left() const { return left_; }
    /// Predicted time of what is unanswered.
    [[nodiscard]] std::uint64_t cost_ns() const { return cost_ns_; }
    /// The paper's label: a task that claims the worker is still running.
    [[nodiscard]] bool have_claimed() const { return claiming_ != 0; }
    /// The job of the task sent last; the other jobs have their turn before it.
    [[nodiscard]] JobId last_job() const { return last_job_; }
    /// Tasks ever sent, and scenarios ever answered by this worker.
    [[nodiscard]] std::uint64_t sent() const { return sent_; }
    [[nodiscard]] std::uint64_t answered() const { return answered_; }
    /// Time of the last answer, or of getting work when idle, s.
    [[nodiscard]] double progressed() const { return progressed_; }
    void note_progress(double now) { progressed_ = now; }

    /// The task must be new.
    void start(TaskId task, TaskInFlight content);
    /// The scenario must be in the task. `here`: this worker answered it.
    void answer(TaskId task, std::uint64_t scenario, std::uint64_t cost_ns, bool here);
    /// Records answers of a range task; `count` is at most what is left.
    void answer_places(TaskId task, std::uint64_t count);
    /// Cuts a range task to its first `kept` positions. Returns the rest, which is unanswered.
    PlaceRange cut_places(TaskId task, std::uint64_t kept);
    /// Marks the rest of the task as begun: it cannot be recalled.
    void set_begun(TaskId task) { tasks_.at(task).has_begun = true; }
    /// Records that `places` more of the last positions of a range task have a copy.
    void add_copied(TaskId task, std::uint64_t places) { tasks_.at(task).places_copied += places; }
    /// Ignored if the task does not exist.
    void note_busy(TaskId task, double seconds);
    /// Drops the job's scenarios; the tasks themselves last until they end.
    void forget_scenarios(JobId job);
    /// Returns the unanswered rest.
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
