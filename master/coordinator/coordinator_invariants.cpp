// Invariants of the coordinator, which hold between two events.
#include "common/core/check.hpp"
#include "master/coordinator/coordinator.hpp"

namespace cd {

void Coordinator::check_invariants() const {
    CD_CHECK(!acting_);
    CD_CHECK(actions_.empty());
    dispatcher_.check_invariants();
    writer_.check_invariants();
    blocks_.check_invariants();
    workers_.check_invariants();
    check_leases();
    std::uint64_t open_bytes = 0;
    for (const JobId id : jobs_.running()) {
        check_job(jobs_.at(id));
        for (const auto& [index, analysis] : jobs_.at(id).open) {
            open_bytes += analysis->bytes;
        }
    }
    CD_CHECK(open_bytes == open_bytes_);
}

std::set<BlockKey> Coordinator::blocks_held_by(WorkerId worker) const {
    const auto known = workers_.all().find(worker);
    const bool is_known = known != workers_.all().end() && known->second.is_settled &&
                          !known->second.is_quarantined && known->second.channel->is_open();
    return is_known ? blocks_.held_by(worker) : std::set<BlockKey>{};
}

/// Every task belongs to a known, watched worker, so it ends eventually. Dispatcher and sessions
/// agree on it.
void Coordinator::check_leases() const {
    std::size_t tasks = 0;
    for (const WorkerId worker : dispatcher_.workers()) {
        CD_CHECK(workers_.all().contains(worker));
        CD_CHECK(!workers_.all().at(worker).is_quarantined);
        for (const TaskId task : dispatcher_.tasks_of(worker)) {
            CD_CHECK(tasks_.contains(task));
            CD_CHECK(tasks_.at(task).worker == worker);
            ++tasks;
        }
    }
    CD_CHECK(tasks == tasks_.size());
    CD_CHECK(workers_.all().empty() || closed_ || watch_timer_ != nullptr);
}

void Coordinator::check_job(const MasterJob& job) const {
    if (job.material == nullptr) {
        return;
    }
    CD_CHECK(dispatcher_.unanswered(job.id) == job.open.size());
    for (const auto& [index, analysis] : job.open) {
        CD_CHECK(!job.merged.has(index));
    }
    if (job.analyses_under_way() != 0 || job.places_loading != 0) {
        return;
    }
    // No scenario is lost: each is merged, at the dispatcher, or still to be handed out.
    const std::vector<bool> in_ranges = scenarios_in_ranges(job);
    for (std::uint64_t index = 0; index < job.submit.scenarios; ++index) {
        CD_CHECK(job.merged.has(index) || in_ranges[index] || job.open.contains(index));
    }
}

std::vector<bool> Coordinator::scenarios_in_ranges(const MasterJob& job) const {
    std::vector<bool> found(job.submit.scenarios);
    const auto add = [&](const PlaceRange& places) {
        if (places.count == 0) {
            return; // All of it was returned.
        }
        const Result<std::vector<Scenario>> scenarios = job.order->read(places.first, places.count);
        CD_CHECK(scenarios.has_value());
        for (const Scenario& scenario : scenarios.value()) {
            found[scenario.index] = true;
        }
    };
    for (const PlaceQueue::Piece& piece : job.todo.pieces()) {
        add(piece.places);
    }
    for (const PlaceRange& places : dispatcher_.places_of(job.id)) {
        add(places);
    }
    for (const auto& [id, task] : tasks_) {
        if (task.content->job == job.id && task.places) {
            add(*task.places);
        }
    }
    return found;
}

} // namespace cd
