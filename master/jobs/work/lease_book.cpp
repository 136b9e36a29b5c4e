#include "master/jobs/work/lease_book.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void LeaseBook::add(TaskId id, Lease task) {
    const bool is_new = tasks_.emplace(id, std::move(task)).second;
    CD_CHECK(is_new);
}

Lease* LeaseBook::find(TaskId task) {
    const auto found = tasks_.find(task);
    return found == tasks_.end() ? nullptr : &found->second;
}

Lease* LeaseBook::find(TaskId task, WorkerId worker) {
    Lease* found = find(task);
    return found != nullptr && found->worker == worker ? found : nullptr;
}

std::optional<Lease> LeaseBook::take(TaskId task) {
    auto taken = tasks_.extract(task);
    return taken.empty() ? std::nullopt : std::optional(std::move(taken.mapped()));
}

void LeaseBook::forget_batches(WorkerId worker) {
    std::erase_if(tasks_, [&](const auto& task) {
        return task.second.worker == worker && !task.second.content->range;
    });
}

std::vector<TaskId> LeaseBook::of(WorkerId worker) const {
    return missing(worker, {});
}

std::vector<TaskId> LeaseBook::missing(WorkerId worker, std::span<const Recalled> present) const {
    std::vector<TaskId> missing;
    for (const auto& [id, task] : tasks_) {
        if (task.worker == worker &&
            std::ranges::find(present, id, &Recalled::task) == present.end()) {
            missing.push_back(id);
        }
    }
    return missing;
}

std::vector<PlaceRange> LeaseBook::places_of(JobId job) const {
    std::vector<PlaceRange> places;
    for (const auto& [id, task] : tasks_) {
        if (task.content->job == job && task.places) {
            places.push_back(*task.places);
        }
    }
    return places;
}

} // namespace cd
