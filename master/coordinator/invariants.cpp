#include "master/coordinator/invariants.hpp"

#include "common/core/check.hpp"

#include <vector>

namespace cd {

namespace {

/// Checks that the dispatcher and the lease book agree about the tasks, and that each task belongs
/// to a known worker, so that it ends with the worker at the latest.
void check_leases(const MasterState& state, const LeaseBook& book) {
    std::size_t tasks = 0;
    const DispatchView& dispatch = state.dispatch.view();
    for (const WorkerId worker : dispatch.workers()) {
        CD_CHECK(state.workers.all().contains(worker));
        CD_CHECK(!state.workers.all().at(worker).is_quarantined);
        for (const TaskId task : dispatch.tasks_of(worker)) {
            CD_CHECK(book.has(worker, task));
            ++tasks;
        }
    }
    CD_CHECK(tasks == book.size());
}

/// Sets the marks, by scenario index, of the scenarios at these positions.
void mark(const MasterJob& job, const PositionSet& positions, std::vector<bool>& marks) {
    for (const PositionRange& run : positions.runs()) {
        const auto scenarios = job.run->poses->read(run.first, run.count);
        CD_CHECK(scenarios.has_value());
        for (const Scenario& scenario : scenarios.value()) {
            marks[scenario.index] = true;
        }
    }
}

void check_job(const MasterState& state, const MasterJob& job) {
    const JobWork* work = job.work();
    if (work == nullptr) {
        return;
    }
    CD_CHECK(state.dispatch.view().unanswered(job.id) == work->open.size());
    std::uint64_t bytes = 0;
    std::vector<bool> is_known(job.submit.scenarios);
    for (const auto& [position, analysis] : work->open.all()) {
        CD_CHECK(position == analysis->position);
        CD_CHECK(!job.merged.has(analysis->scenario.index));
        is_known[analysis->scenario.index] = true;
        bytes += analysis->bytes;
    }
    CD_CHECK(bytes == work->open.bytes());
    std::vector<bool> in_ranges(job.submit.scenarios);
    mark(job, state.dispatch.view().unanalysed(job.id), in_ranges);
    for (std::uint64_t index = 0; index < job.submit.scenarios; ++index) {
        const bool answered_is_in_no_range = !in_ranges[index] || !job.merged.has(index);
        CD_CHECK(answered_is_in_no_range);
    }
    if (work->analyses_under_way() != 0 || work->positions_loading != 0) {
        return;
    }
    for (const PositionQueue::Piece& piece : work->todo.pieces()) {
        mark(job, piece.positions, is_known);
    }
    // No scenario is lost: each has a merged result, is at the dispatcher, or is not handed out.
    for (std::uint64_t index = 0; index < job.submit.scenarios; ++index) {
        CD_CHECK(job.merged.has(index) || in_ranges[index] || is_known[index]);
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
        check_job(state, state.jobs.at(id));
    }
}

} // namespace cd
