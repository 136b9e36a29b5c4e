#include "master/workers/worker_watch.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void WorkerWatch::joined(WorkerId worker, Time now) {
    const bool is_new = workers_.try_emplace(worker, Entry{now, {}, false, {}}).second;
    CD_CHECK(is_new);
}

bool WorkerWatch::heard(WorkerId worker, Time now) {
    const auto found = workers_.find(worker);
    if (found == workers_.end() || found->second.state == WorkerState::Lost) {
        return false;
    }
    const bool was_silent = found->second.state == WorkerState::Silent;
    found->second = Entry{now, {}, false, WorkerState::Alive};
    return was_silent;
}

bool WorkerWatch::detached(WorkerId worker, Time now) {
    const auto found = workers_.find(worker);
    if (found == workers_.end() || found->second.state == WorkerState::Lost) {
        return false;
    }
    found->second.detached = now;
    found->second.is_unheard = false;
    return std::exchange(found->second.state, WorkerState::Silent) == WorkerState::Alive;
}

void WorkerWatch::unheard(WorkerId worker) {
    if (const auto found = workers_.find(worker); found != workers_.end()) {
        found->second.is_unheard = true;
    }
}

void WorkerWatch::lost(WorkerId worker) {
    if (const auto found = workers_.find(worker); found != workers_.end()) {
        found->second.state = WorkerState::Lost;
    }
}

void WorkerWatch::left(WorkerId worker) {
    workers_.erase(worker);
}

bool WorkerWatch::is_due_to_be_lost(const Entry& entry, Time now) const {
    return entry.detached ? now - *entry.detached >= times_.return_within
                          : now - entry.heard >= times_.lost_after;
}

std::vector<WorkerWatch::Change> WorkerWatch::time_is(Time now) {
    std::vector<Change> changes;
    for (auto place = workers_.begin(); place != workers_.end();) {
        const WorkerId worker = place->first;
        Entry& entry = place->second;
        if (!entry.is_unheard && entry.state != WorkerState::Lost) {
            if (is_due_to_be_lost(entry, now)) {
                entry.state = WorkerState::Lost;
                changes.push_back({worker, WorkerState::Lost});
            } else if (entry.state == WorkerState::Alive &&
                       now - entry.heard >= times_.silent_after()) {
                entry.state = WorkerState::Silent;
                changes.push_back({worker, WorkerState::Silent});
            }
        }
        if (entry.state == WorkerState::Lost && now - entry.heard >= times_.forgotten_after) {
            changes.push_back({worker, std::nullopt});
            place = workers_.erase(place);
        } else {
            ++place;
        }
    }
    forget_some(changes);
    return changes;
}

void WorkerWatch::forget_some(std::vector<Change>& changes) {
    const auto is_lost = [](const auto& entry) { return entry.second.state == WorkerState::Lost; };
    auto lost = static_cast<std::size_t>(std::count_if(workers_.begin(), workers_.end(), is_lost));
    // Ids ascend, so the workers that joined first are forgotten first.
    for (auto place = workers_.begin(); lost > limits::lost_workers_kept_max;) {
        if (is_lost(*place)) {
            changes.push_back({place->first, std::nullopt});
            place = workers_.erase(place);
            --lost;
        } else {
            ++place;
        }
    }
}

std::optional<WorkerState> WorkerWatch::state(WorkerId worker) const {
    const auto found = workers_.find(worker);
    return found == workers_.end() ? std::nullopt : std::optional(found->second.state);
}

std::chrono::duration<double> WorkerWatch::silence(WorkerId worker, Time now) const {
    const auto found = workers_.find(worker);
    return found == workers_.end() ? Time::duration{} : now - found->second.heard;
}

} // namespace cd
