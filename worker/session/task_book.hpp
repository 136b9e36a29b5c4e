// The jobs and tasks that a master has assigned in one session.
#pragma once

#include "worker/execution/task.hpp"
#include "worker/execution/worker_job.hpp"

#include <cstdint>
#include <map>
#include <memory>

namespace cd {

class TaskBook {
  public:
    /// Adds a job. Errors: BadFrame for a job that exists already; those of `make_worker_job`.
    [[nodiscard]] Result<std::shared_ptr<const WorkerJob>> add_job(AddJob add,
                                                                   const SubtreeCache& cache);
    void remove_job(JobId job) { jobs_.erase(job); }
    void remove_jobs_of(TreeId tree);
    /// Returns the job; null for an unknown job.
    [[nodiscard]] std::shared_ptr<const WorkerJob> job(JobId job) const;

    /// Adds a task. Errors: BadFrame for an unknown job or an existing task; those of `Task::make`.
    [[nodiscard]] Result<Task*> add(WorkUnit unit, const SubtreeCache& cache);
    [[nodiscard]] std::map<TaskId, Task>& tasks() { return tasks_; }
    /// Returns the task; null for an unknown task.
    [[nodiscard]] Task* find(TaskId task);
    /// Returns the task, which must exist.
    [[nodiscard]] Task& at(TaskId task) { return tasks_.at(task); }

    [[nodiscard]] bool has_tasks() const { return !tasks_.empty(); }
    /// Number of unanswered scenarios of all tasks.
    [[nodiscard]] std::uint64_t unanswered() const;
    /// Adds the jobs, and the tasks with their returned scenarios, to an inventory.
    void add_to(Inventory& inventory) const;

  private:
    std::map<JobId, std::shared_ptr<const WorkerJob>> jobs_;
    std::map<TaskId, Task> tasks_;
};

} // namespace cd
