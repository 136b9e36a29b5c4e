#include "master/dispatch/endgame/endgame.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <ranges>
#include <span>
#include <utility>

namespace cd {

bool Endgame::has_begun() const {
    const std::span<WorkerProxy* const> all = context_.pool.in_order();
    return context_.queue.is_exhausted() &&
           std::ranges::any_of(
               all, [this](const WorkerProxy* one) { return stragglers_.can_help(*one); }) &&
           std::ranges::any_of(all, [](const WorkerProxy* one) { return one->tasks.left() != 0; });
}

void Endgame::help(double period, Actions& actions) {
    const double now = context_.pace.now();
    if (!context_.queue.is_exhausted() || now < helped_ + period) {
        return;
    }
    helped_ = now;
    std::vector<WorkerProxy*> free = stragglers_.helpers();
    for (WorkerProxy* from : free.empty() ? std::vector<WorkerProxy*>{} : stragglers_.late()) {
        from->note_looked_at(now);
        // Tries the fastest helpers first. If the fastest helper would gain nothing, a slower one
        // may, for example because it holds the blocks.
        for (std::size_t i = 0; i < std::min(free.size(), limits::helpers_tried_max);) {
            WorkerProxy& helper = *free[i];
            if (&helper == from || !helps(*from, helper, actions)) {
                ++i;
            } else if (!stragglers_.can_help(helper)) {
                free.erase(free.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
    }
}

bool Endgame::helps(WorkerProxy& from, WorkerProxy& helper, Actions& actions) {
    if (stragglers_.may_be_asked(from) && ask_back(from, helper, actions)) {
        return true;
    }
    return !stragglers_.may_answer_recall(from) && copies_.copy(from, helper, actions);
}

bool Endgame::ask_back(const WorkerProxy& from, const WorkerProxy& helper, Actions& actions) {
    // Newest task first: the worker begins it last.
    for (const auto& [id, task] : std::views::reverse(from.tasks.all())) {
        if (!stragglers_.can_be_recalled(task)) {
            continue;
        }
        PositionSet wanted = task.is_analysed ? scenarios_to_ask(from, task, helper)
                                              : positions_to_ask(from, task, helper);
        if (!wanted.is_empty()) {
            tasks_.ask_back({from.id(), id, std::move(wanted)}, helper.id(), actions);
            return true;
        }
    }
    return false;
}

PositionSet Endgame::scenarios_to_ask(const WorkerProxy& from,
                                      const TaskInFlight& task,
                                      const WorkerProxy& helper) const {
    const DispatchJob& job = context_.queue.at(task.job);
    std::vector<std::uint64_t> wanted;
    double seconds_here = stragglers_.ends_in(from);
    double seconds_there = 0;
    for (const std::uint64_t position : std::views::reverse(task.uncopied().list())) {
        const DispatchScenario& scenario = job.at(position);
        if (scenario.recalls == limits::scenario_recalls_max) {
            continue;
        }
        const double finish = job.policy->finish_on(helper, job, scenario).total() + seconds_there;
        if (finish + timing::end_gain_seconds_min > seconds_here) {
            break;
        }
        wanted.push_back(position);
        const double work = 1e-9 * static_cast<double>(scenario.weight.cost_ns);
        seconds_here -= work / context_.pace.power_of(from);
        seconds_there += work / context_.pace.power_of(helper);
    }
    return PositionSet::of(std::move(wanted));
}

PositionSet Endgame::positions_to_ask(const WorkerProxy& from,
                                      const TaskInFlight& task,
                                      const WorkerProxy& helper) const {
    if (!task.shared.copied.is_empty()) {
        return {}; // Of a range only the end can be recalled, and the end got a copy.
    }
    return task.positions.last(stragglers_.positions_to_move(
        from, context_.queue.at(task.job), helper, stragglers_.ends_in(from), 1));
}

} // namespace cd
