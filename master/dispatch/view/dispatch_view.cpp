#include "master/dispatch/view/dispatch_view.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "master/dispatch/dispatch_parts.hpp"
#include "master/dispatch/view/dispatch_invariants.hpp"
#include "master/dispatch/view/explain.hpp"

#include <algorithm>
#include <ranges>

namespace cd {

DispatchView::DispatchView() : parts_(std::make_unique<DispatchParts>()) {}
DispatchView::~DispatchView() = default;

std::uint64_t DispatchView::unsent() const {
    return parts_->queue.unsent();
}

std::uint64_t DispatchView::unsent_of(JobId job) const {
    return parts_->queue.at(job).input.unsent;
}

bool DispatchView::is_analysed_before(JobId one, JobId other) const {
    return parts_->queue.analysis_order().comes_before(one, other);
}

double DispatchView::share(JobId job) const {
    return parts_->queue.order().share(job, parts_->pace.now());
}

bool DispatchView::is_at_end() const {
    return parts_->endgame.has_begun();
}

std::uint64_t DispatchView::unsent_enough() const {
    std::uint64_t enough = 0;
    for (const auto& [id, job] : parts_->queue.jobs()) {
        enough = std::max(enough, job.policy->enough(job));
    }
    // Beyond what fills one job's buffers, some scenarios of other jobs must fit.
    return limits::unsent_scenarios_max + enough;
}

std::uint64_t DispatchView::positions_unsent(JobId job) const {
    return parts_->queue.at(job).unsent.count();
}

std::uint64_t DispatchView::positions_enough(JobId job) const {
    return parts_->ranges.enough(parts_->queue.at(job));
}

MissingCosts DispatchView::missing_costs(JobId job) const {
    return parts_->blocks.costs_of(parts_->queue.at(job));
}

bool DispatchView::moves_work(JobId job) const {
    return parts_->queue.at(job).policy->moves_work();
}

WorkersNow DispatchView::workers_now() const {
    return cd::workers_now(*parts_);
}

WorkerStatus DispatchView::worker_status(WorkerId worker) const {
    const WorkerProxy* proxy = parts_->pool.find(worker);
    return proxy == nullptr ? WorkerStatus{} : proxy->status();
}

std::vector<WorkerId> DispatchView::workers() const {
    const auto ids = std::views::keys(parts_->pool.all());
    return {ids.begin(), ids.end()};
}

std::vector<TaskId> DispatchView::tasks_of(WorkerId worker) const {
    const auto ids = std::views::keys(parts_->pool.at(worker).tasks.all());
    return {ids.begin(), ids.end()};
}

std::uint64_t DispatchView::owed(WorkerId worker, TaskId task) const {
    return parts_->tasks.owed({worker, task});
}

bool DispatchView::is_copy(WorkerId worker, TaskId task) const {
    const TaskInFlight* const found = parts_->tasks.find({worker, task});
    return found != nullptr && found->is_copy();
}

std::uint64_t DispatchView::unanswered(JobId job) const {
    const DispatchJob* const found = parts_->queue.find(job);
    return found == nullptr ? 0 : found->scenarios.size();
}

PositionSet DispatchView::unanalysed(JobId job) const {
    PositionSet positions;
    for (const PositionRange& range : parts_->queue.at(job).unsent.all()) {
        positions.add(range);
    }
    for (const WorkerProxy* proxy : parts_->pool.in_order()) {
        for (const auto& [id, task] : proxy->tasks.all()) {
            if (task.job == job && !task.is_analysed) {
                positions.add(task.positions);
            }
        }
    }
    return positions;
}

Explained DispatchView::explain(JobId job, const AnalysedScenario& scenario) const {
    const DispatchJob* found = parts_->queue.find(job);
    CD_CHECK(found != nullptr);
    return explain_choice(parts_->context, *found, scenario);
}

void DispatchView::check_invariants() const {
    check_invariants_of(*parts_);
}

} // namespace cd
