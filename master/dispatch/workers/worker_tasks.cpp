#include "master/dispatch/workers/worker_tasks.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <utility>

namespace cd {

std::size_t WorkerTasks::count_of(JobId job) const {
    return static_cast<std::size_t>(std::count_if(
        tasks_.begin(), tasks_.end(), [&](const auto& task) { return task.second.job == job; }));
}

TaskInFlight& WorkerTasks::existing(TaskId task) {
    const auto found = tasks_.find(task);
    CD_CHECK(found != tasks_.end());
    return found->second;
}

void WorkerTasks::start(TaskId task, TaskInFlight content) {
    progressed_ = left_ == 0 ? content.sent : progressed_;
    left_ += content.left();
    cost_ns_ += content.cost_ns;
    claiming_ += content.claims ? 1 : 0;
    ++sent_;
    last_job_ = content.job;
    const bool is_new = tasks_.emplace(task, std::move(content)).second;
    CD_CHECK(is_new);
}

void WorkerTasks::answer(TaskId id, std::uint64_t scenario, std::uint64_t cost_ns, bool here) {
    TaskInFlight& task = existing(id);
    const auto place = std::find(task.scenarios.begin(), task.scenarios.end(), scenario);
    CD_CHECK(place != task.scenarios.end());
    task.scenarios.erase(place);
    --left_;
    task.cost_ns -= cost_ns;
    cost_ns_ -= cost_ns;
    answered_ += here ? 1 : 0;
}

void WorkerTasks::forget_scenarios(JobId job) {
    for (auto& [id, task] : tasks_) {
        if (task.job == job) {
            left_ -= task.left();
            cost_ns_ -= task.cost_ns;
            task.scenarios.clear();
            task.places_left = 0;
            task.cost_ns = 0;
        }
    }
}

void WorkerTasks::answer_places(TaskId id, std::uint64_t count) {
    TaskInFlight& task = existing(id);
    CD_CHECK(count <= task.places_left);
    remove_places(task, count);
    answered_ += count;
}

PlaceRange WorkerTasks::cut_places(TaskId id, std::uint64_t kept) {
    TaskInFlight& task = existing(id);
    CD_CHECK(task.is_range());
    // Cuts at most the unanswered positions, whatever the worker reports.
    const std::uint64_t least = task.places->count - task.places_left;
    const std::uint64_t count = std::clamp(kept, least, task.places->count);
    const PlaceRange cut{task.places->first + count, task.places->count - count};
    task.places->count = count;
    task.places_copied -= std::min(task.places_copied, cut.count);
    remove_places(task, cut.count);
    return cut;
}

void WorkerTasks::remove_places(TaskInFlight& task, std::uint64_t count) {
    if (count == 0) {
        return;
    }
    const auto share = static_cast<double>(count) / static_cast<double>(task.places_left);
    const auto cost_ns =
        count == task.places_left
            ? task.cost_ns
            : static_cast<std::uint64_t>(share * static_cast<double>(task.cost_ns));
    task.places_left -= count;
    task.cost_ns -= cost_ns;
    left_ -= count;
    cost_ns_ -= cost_ns;
}

void WorkerTasks::note_busy(TaskId task, double seconds) {
    const auto found = tasks_.find(task);
    if (found != tasks_.end()) {
        found->second.busy_seconds += seconds;
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
