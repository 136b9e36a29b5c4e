#include "master/coordinator/invariants.hpp"

#include "common/core/check.hpp"

#include <vector>

namespace cd {

namespace {

/// Checks that dispatcher and lease book have the same tasks, and that each belongs to a known
/// worker, so that the task ends with the worker at the latest.
void check_leases(const MasterState& state, const LeaseBook& book) {
    std::size_t tasks = 0;
    const DispatchView& dispatch = state.dispatch.view();
    for (const WorkerId worker : dispatch.workers()) {
        CD_CHECK(state.workers.all().contains(worker));
        CD_CHECK(!state.workers.all().at(worker).is_quarantined);
        for (const TaskId task : dispatch.tasks_of(worker)) {
            CD_CHECK(book.all().contains(task));
            CD_CHECK(book.all().at(task).worker == worker);
            ++tasks;
        }
    }
    CD_CHECK(tasks == book.all().size());
}

/// Marks, by index, the scenarios that wait to be handed out or are in ranges.
std::vector<bool>
scenarios_in_ranges(const MasterState& state, const LeaseBook& book, const MasterJob& job) {
    std::vector<bool> found(job.submit.scenarios);
    const auto add = [&](const PlaceRange& places) {
        if (places.count == 0) {
            return; // The worker has returned the whole range.
        }
        const auto scenarios = job.work()->order->read(places.first, places.count);
        CD_CHECK(scenarios.has_value());
        for (const Scenario& scenario : scenarios.value()) {
            found[scenario.index] = true;
        }
    };
    for (const PlaceQueue::Piece& piece : job.work()->todo.pieces()) {
        add(piece.places);
    }
    for (const PlaceRange& places : state.dispatch.view().places_of(job.id)) {
        add(places);
    }
    for (const PlaceRange& places : book.places_of(job.id)) {
        add(places);
    }
    return found;
}

void check_job(const MasterState& state, const LeaseBook& book, const MasterJob& job) {
    const JobWork* work = job.work();
    if (work == nullptr) {
        return;
    }
    CD_CHECK(state.dispatch.view().unanswered(job.id) == work->open.size());
    std::uint64_t bytes = 0;
    for (const auto& [index, analysis] : work->open.all()) {
        CD_CHECK(!job.merged.has(index));
        bytes += analysis->bytes;
    }
    CD_CHECK(bytes == work->open.bytes());
    if (work->analyses_under_way() != 0 || work->places_loading != 0) {
        return;
    }
    // No scenario is lost: each is merged, at the dispatcher, or still to be handed out.
    const std::vector<bool> in_ranges = scenarios_in_ranges(state, book, job);
    for (std::uint64_t index = 0; index < job.submit.scenarios; ++index) {
        CD_CHECK(job.merged.has(index) || in_ranges[index] || work->open.has(index));
    }
}

} // namespace

void check_invariants(const MasterState& state, const MasterServices& services) {
    CD_CHECK(state.dispatch.is_idle());
    state.dispatch.view().check_invariants();
    state.writer.check_invariants();
    state.blocks.check_invariants();
    state.workers.check_invariants();
    check_leases(state, services.tasks.book());
    for (const JobId id : state.jobs.running()) {
        check_job(state, services.tasks.book(), state.jobs.at(id));
    }
}

} // namespace cd
