#include "master/dispatch/endgame/speculative_copies.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <ranges>

namespace cd {

bool SpeculativeCopies::copy(const WorkerProxy& from, WorkerProxy& helper, Actions& actions) {
    for (const auto& [id, task] : std::views::reverse(from.tasks.all())) {
        const PositionSet candidates = stragglers_.copyable(task);
        if (candidates.is_empty()) {
            continue;
        }
        const PositionSet copied = task.is_analysed
                                       ? scenario_to_copy(from, task, candidates, helper)
                                       : positions_to_copy(from, task, candidates, helper);
        if (!copied.is_empty()) {
            const DispatchJob& job = context_.queue.at(task.job);
            // A copy of an analysed task has one scenario.
            const std::uint64_t first = copied.runs().front().first;
            const bool fetches =
                task.is_analysed && !blocks_.hold_roots(job.at(first).roots, helper).is_nothing();
            tasks_.send_copy({from.id(), id}, helper, copied, fetches, actions);
            return true;
        }
    }
    return false;
}

PositionSet SpeculativeCopies::scenario_to_copy(const WorkerProxy& from,
                                                const TaskInFlight& task,
                                                const PositionSet& candidates,
                                                const WorkerProxy& helper) const {
    const DispatchJob& job = context_.queue.at(task.job);
    double seconds_here = stragglers_.ends_in(from);
    for (const std::uint64_t position : std::views::reverse(task.positions.list())) {
        const DispatchScenario& scenario = job.at(position);
        const std::uint64_t cost_ns = scenario.weight.cost_ns;
        if (!candidates.contains(position)) {
            seconds_here -= 1e-9 * static_cast<double>(cost_ns) / context_.pace.power_of(from);
            continue;
        }
        const double finish =
            job.policy->finish_on(helper, job, scenario).total() + timing::end_gain_seconds_min;
        const bool pays = limits::copy_gain_min * finish <= seconds_here;
        return pays && cost_ns <= job.copies.left_ns() ? PositionSet(PositionRange{position, 1})
                                                       : PositionSet();
    }
    return {};
}

PositionSet SpeculativeCopies::positions_to_copy(const WorkerProxy& from,
                                                 const TaskInFlight& task,
                                                 const PositionSet& candidates,
                                                 const WorkerProxy& helper) const {
    const DispatchJob& job = context_.queue.at(task.job);
    const double copied_seconds = static_cast<double>(task.left() - candidates.count()) /
                                  context_.pace.positions_per_second(from, job);
    const auto batch = static_cast<std::uint64_t>(timing::batch_seconds_start *
                                                  context_.pace.positions_per_second(helper, job));
    // A range is sent as one run of positions, so only the last unanswered run is copied.
    return PositionSet(candidates.runs().back())
        .last(std::min({job.copies.left_ns() / context_.pace.mean_cost_of(1),
                        std::max<std::uint64_t>(batch, helper.facts().threads),
                        stragglers_.positions_to_move(from,
                                                      job,
                                                      helper,
                                                      stragglers_.ends_in(from) - copied_seconds,
                                                      limits::copy_gain_min)}));
}

} // namespace cd
