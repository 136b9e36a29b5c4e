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
        if (task.left() == 0 || task.is_copy || task.has_begun) {
            continue;
        }
        AskBack ask =
            task.is_range() ? range_to_ask(from, id, helper) : batch_to_ask(from, id, helper);
        const std::uint64_t count =
            task.is_range() ? task.places->count - ask.places : ask.scenarios.size();
        if (count != 0) {
            tasks_.ask_back(std::move(ask), count, helper.id(), actions);
            return true;
        }
    }
    return false;
}

AskBack
Endgame::batch_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const {
    AskBack ask{from.id(), task, {}, 0};
    const TaskInFlight& content = from.tasks.at(task);
    const DispatchJob& job = queue_.at(content.job);
    if (!job.policy->is_by_time()) {
        return ask;
    }
    double seconds_here = stragglers_.ends_in(from);
    double seconds_there = 0;
    for (const std::uint64_t index : std::views::reverse(content.scenarios)) {
        const DispatchScenario& scenario = job.at(index);
        if (scenario.copy || scenario.recalls == limits::scenario_recalls_max) {
            continue;
        }
        const double finish = job.policy->finish_on(helper, job, scenario).total() + seconds_there;
        if (finish + timing::end_gain_seconds_min > seconds_here) {
            break;
        }
        ask.scenarios.push_back(index);
        const double work = 1e-9 * static_cast<double>(scenario.weight.cost_ns);
        seconds_here -= work / context_.pace.power_of(from);
        seconds_there += work / context_.pace.power_of(helper);
    }
    std::ranges::sort(ask.scenarios);
    return ask;
}

AskBack
Endgame::range_to_ask(const WorkerProxy& from, TaskId task, const WorkerProxy& helper) const {
    const TaskInFlight& content = from.tasks.at(task);
    const std::uint64_t most = content.places_copied != 0 ? 0 : content.places_left;
    const std::uint64_t count = std::min(
        most, places_to_move(from, queue_.at(content.job), helper, stragglers_.ends_in(from), 1));
    return {from.id(), task, {}, content.places->count - count};
}

std::uint64_t Endgame::places_to_move(const WorkerProxy& from,
                                      const DispatchJob& job,
                                      const WorkerProxy& helper,
                                      double seconds_here,
                                      double gain) const {
    const double rate_here = context_.pace.places_per_second(from, job);
    const double rate_there = context_.pace.places_per_second(helper, job);
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

bool Endgame::copy(WorkerProxy& from, WorkerProxy& helper, Actions& actions) {
    for (const auto& [id, task] : std::views::reverse(from.tasks.all())) {
        if (task.left() == 0 || task.is_copy) {
            continue;
        }
        const bool is_copied = task.is_range() ? copy_places(from, id, helper, actions)
                                               : copy_scenario(from, id, helper, actions);
        if (is_copied) {
            return true;
        }
    }
    return false;
}

bool Endgame::copy_scenario(const WorkerProxy& from,
                            TaskId task,
                            WorkerProxy& helper,
                            Actions& actions) {
    DispatchJob& job = queue_.at(from.tasks.at(task).job);
    if (!job.policy->is_by_time()) {
        return false;
    }
    double seconds_here = stragglers_.ends_in(from);
    for (const std::uint64_t index : std::views::reverse(from.tasks.at(task).scenarios)) {
        const DispatchScenario& scenario = job.at(index);
        const std::uint64_t cost_ns = scenario.weight.cost_ns;
        if (!scenario.may_be_copied()) {
            seconds_here -= 1e-9 * static_cast<double>(cost_ns) / context_.pace.power_of(from);
            continue;
        }
        const double finish =
            job.policy->finish_on(helper, job, scenario).total() + timing::end_gain_seconds_min;
        if (limits::copy_gain_min * finish > seconds_here || cost_ns > job.copies.left_ns()) {
            return false;
        }
        const bool fetches = !blocks_.hold_roots(job, scenario.roots, helper).is_nothing();
        tasks_.send_copy(helper, job, index, fetches, actions);
        return true;
    }
    return false;
}

bool Endgame::copy_places(WorkerProxy& from, TaskId task, WorkerProxy& helper, Actions& actions) {
    const TaskInFlight& content = from.tasks.at(task);
    const DispatchJob& job = queue_.at(content.job);
    // Workers process ranges from the front, so mostly the last positions are left.
    if (content.places_left <= content.places_copied) {
        return false;
    }
    const double copied_seconds =
        static_cast<double>(content.places_copied) / context_.pace.places_per_second(from, job);
    const auto batch = static_cast<std::uint64_t>(timing::batch_seconds_start *
                                                  context_.pace.places_per_second(helper, job));
    const std::uint64_t count = std::min({content.places_left - content.places_copied,
                                          job.copies.left_ns() / content.each_ns(),
                                          std::max<std::uint64_t>(batch, helper.facts().threads),
                                          places_to_move(from,
                                                         job,
                                                         helper,
                                                         stragglers_.ends_in(from) - copied_seconds,
                                                         limits::copy_gain_min)});
    if (count == 0) {
        return false;
    }
    tasks_.copy_places(from, task, helper, count, actions);
    return true;
}

} // namespace cd
