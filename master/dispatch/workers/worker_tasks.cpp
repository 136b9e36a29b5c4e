#include "master/dispatch/workers/worker_tasks.hpp"

#include "common/core/check.hpp"

#include <utility>

namespace cd {

const TaskInFlight* WorkerTasks::find(TaskId task) const {
    const auto found = tasks_.find(task);
    return found == tasks_.end() ? nullptr : &found->second;
}

std::size_t WorkerTasks::count_of(JobId job) const {
    return static_cast<std::size_t>(std::count_if(
        tasks_.begin(), tasks_.end(), [&](const auto& task) { return task.second.job == job; }));
}

std::size_t WorkerTasks::unanswered_of(JobId job) const {
    return static_cast<std::size_t>(std::count_if(tasks_.begin(), tasks_.end(), [&](auto& task) {
        return task.second.job == job && task.second.left() != 0;
    }));
}

std::uint64_t WorkerTasks::left_of(JobId job) const {
    std::uint64_t left = 0;
    for (const auto& [id, task] : tasks_) {
        left += task.job == job ? task.left() : 0;
    }
    return left;
}

void WorkerTasks::start(TaskId task, TaskInFlight content) {
    progressed_ = left_ == 0 ? content.sent : progressed_;
    left_ += content.left();
    cost_ns_ += content.cost_ns;
    claiming_ += content.claims ? 1 : 0;
    ++sent_;
    const bool is_new = tasks_.emplace(task, std::move(content)).second;
    CD_CHECK(is_new);
}

void WorkerTasks::remove(TaskId id, const PositionSet& positions, std::uint64_t cost_ns) {
    TaskInFlight& task = tasks_.at(id);
    const std::uint64_t before = task.left();
    task.positions.remove(positions);
    const bool task_had_positions = before - task.left() == positions.count();
    CD_CHECK(task_had_positions);
    left_ -= positions.count();
    task.cost_ns -= cost_ns;
    cost_ns_ -= cost_ns;
}

void WorkerTasks::note_answers(std::uint64_t positions, double now) {
    answered_ += positions;
    progressed_ = now;
}

void WorkerTasks::add_copy(TaskId task, const Assignment& copy, const PositionSet& positions) {
    SharedWork& shared = tasks_.at(task).shared;
    shared.copies.push_back(copy);
    shared.copied.add(positions);
}

void WorkerTasks::forget_positions(JobId job) {
    for (auto& [id, task] : tasks_) {
        if (task.job == job) {
            left_ -= task.left();
            cost_ns_ -= task.cost_ns;
            task.positions = {};
            task.cost_ns = 0;
        }
    }
}

TaskInFlight WorkerTasks::end(TaskId task) {
    auto node = tasks_.extract(task);
    CD_CHECK(!node.empty());
    left_ -= node.mapped().left();
    cost_ns_ -= node.mapped().cost_ns;
    claiming_ -= node.mapped().claims ? 1 : 0;
    return std::move(node.mapped());
}

} // namespace cd
