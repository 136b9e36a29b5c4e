#include "master/dispatch/endgame/endgame.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <ranges>
#include <utility>

namespace cd {

bool Endgame::has_begun() const {
    return queue_.is_exhausted() && !stragglers_.helpers().empty() &&
           std::ranges::any_of(context_.pool.in_order(),
                               [](const WorkerProxy* proxy) { return proxy->tasks.left() != 0; });
}

void Endgame::help(double period, Actions& actions) {
    const double now = context_.pace.now();
    if (!queue_.is_exhausted() || now < helped_ + period) {
        return;
    }
    helped_ = now;
    std::vector<WorkerProxy*> free = stragglers_.helpers();
    for (WorkerProxy* from : free.empty() ? std::vector<WorkerProxy*>{} : stragglers_.late()) {
        from->note_looked_at(now);
        // Tries the fastest helpers first. If the fastest would gain nothing, one of the next may,
        // for example because it holds the blocks.
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
    return !stragglers_.may_answer_recall(from) && copy(from, helper, actions);
}

// ---- Recalls ------------------------------------------------------------------------------------

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
    const DispatchJob& job = queue_.at(task.job);
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
        return {}; // The worker can return the last positions alone, and these have a copy.
    }
    return task.positions.last(
        positions_to_move(from, queue_.at(task.job), helper, stragglers_.ends_in(from), 1));
}

std::uint64_t Endgame::positions_to_move(const WorkerProxy& from,
                                         const DispatchJob& job,
                                         const WorkerProxy& helper,
                                         double seconds_here,
                                         double gain) const {
    const double rate_here = context_.pace.positions_per_second(from, job);
    const double rate_there = context_.pace.positions_per_second(helper, job);
    const double begins = stragglers_.ends_in(helper) + timing::end_gain_seconds_min;
    const double one = helper.facts().threads / rate_there + job.missing.any_or(0);
    if (gain * (begins + one) > seconds_here) {
        return 0;
    }
    // Solves for the count with which both workers finish together.
    const double count = (seconds_here - begins) / (1 / rate_here + 1 / rate_there);
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(count));
}

// ---- Speculative copies -------------------------------------------------------------------------

bool Endgame::copy(const WorkerProxy& from, WorkerProxy& helper, Actions& actions) {
    for (const auto& [id, task] : std::views::reverse(from.tasks.all())) {
        const PositionSet candidates = stragglers_.copyable(task);
        if (candidates.is_empty()) {
            continue;
        }
        const PositionSet copied = task.is_analysed
                                       ? scenario_to_copy(from, task, candidates, helper)
                                       : positions_to_copy(from, task, candidates, helper);
        if (!copied.is_empty()) {
            const DispatchJob& job = queue_.at(task.job);
            // A copy of an analysed task has one scenario.
            const std::uint64_t first = copied.runs().front().first;
            const bool fetches = task.is_analysed &&
                                 !blocks_.hold_roots(job, job.at(first).roots, helper).is_nothing();
            tasks_.send_copy({from.id(), id}, helper, copied, fetches, actions);
            return true;
        }
    }
    return false;
}

PositionSet Endgame::scenario_to_copy(const WorkerProxy& from,
                                      const TaskInFlight& task,
                                      const PositionSet& candidates,
                                      const WorkerProxy& helper) const {
    const DispatchJob& job = queue_.at(task.job);
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

PositionSet Endgame::positions_to_copy(const WorkerProxy& from,
                                       const TaskInFlight& task,
                                       const PositionSet& candidates,
                                       const WorkerProxy& helper) const {
    const DispatchJob& job = queue_.at(task.job);
    const double copied_seconds = static_cast<double>(task.left() - candidates.count()) /
                                  context_.pace.positions_per_second(from, job);
    const auto batch = static_cast<std::uint64_t>(timing::batch_seconds_start *
                                                  context_.pace.positions_per_second(helper, job));
    // A task without analysis is one run of positions.
    return PositionSet(candidates.runs().back())
        .last(std::min({job.copies.left_ns() / task.each_ns(),
                        std::max<std::uint64_t>(batch, helper.facts().threads),
                        positions_to_move(from,
                                          job,
                                          helper,
                                          stragglers_.ends_in(from) - copied_seconds,
                                          limits::copy_gain_min)}));
}

} // namespace cd
