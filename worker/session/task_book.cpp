#include "worker/session/task_book.hpp"

#include <string>
#include <utility>

namespace cd {

Result<std::shared_ptr<const WorkerJob>> TaskBook::add_job(AddJob add, const SubtreeCache& cache) {
    const JobId id = add.job;
    Result<std::shared_ptr<const WorkerJob>> job = make_worker_job(std::move(add), cache);
    if (job && !jobs_.emplace(id, job.value()).second) {
        return Error{ErrorCode::BadFrame, "job " + std::to_string(id.value) + " was added already"};
    }
    return job;
}

void TaskBook::remove_jobs_of(TreeId tree) {
    std::erase_if(jobs_, [tree](const auto& job) { return job.second->uses(tree); });
}

std::shared_ptr<const WorkerJob> TaskBook::job(JobId job) const {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? nullptr : found->second;
}

Result<Task*> TaskBook::add(WorkUnit unit, const SubtreeCache& cache) {
    const TaskId id = unit.task;
    auto its_job = job(unit.job);
    if (its_job == nullptr) {
        return Error{ErrorCode::BadFrame,
                     "task " + std::to_string(id.value) + " names a job that is not here"};
    }
    Result<Task> made = Task::make(std::move(unit), std::move(its_job), cache);
    if (!made) {
        return made.error();
    }
    const auto [place, is_new] = tasks_.emplace(id, std::move(made.value()));
    if (!is_new) {
        return Error{ErrorCode::BadFrame, "task " + std::to_string(id.value) + " came twice"};
    }
    return &place->second;
}

Task* TaskBook::find(TaskId task) {
    const auto found = tasks_.find(task);
    return found == tasks_.end() ? nullptr : &found->second;
}

std::uint64_t TaskBook::unanswered() const {
    std::uint64_t unanswered = 0;
    for (const auto& [id, task] : tasks_) {
        unanswered += task.unanswered();
    }
    return unanswered;
}

void TaskBook::add_to(Inventory& inventory) const {
    for (const auto& [id, job] : jobs_) {
        inventory.jobs.push_back(id);
    }
    for (const auto& [id, task] : tasks_) {
        inventory.tasks.push_back(task.given_back());
    }
}

} // namespace cd
