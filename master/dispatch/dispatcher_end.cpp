// The end of a job: nothing waits, and some workers are idle while others still work. Unbegun work
// is recalled and goes to the worker that finishes it first. Begun or unreturned work gets a
// speculative copy elsewhere if that finishes clearly earlier; the share of copied work is bounded.
// The finish estimate follows from a worker's measured speed and its time without answers (LATE:
// Zaharia et al., Improving MapReduce Performance in Heterogeneous Environments, 2008).
//
// Used for matching by time and for ranges; the paper's strategies follow the paper.
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/dispatcher_state.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

namespace cd {

bool Dispatcher::State::nothing_waits() const {
    return unsent == 0 && input_is_paused && std::ranges::all_of(jobs, [](const auto& job) {
               return job.second.places.empty() && job.second.places_after == 0;
           });
}

bool Dispatcher::is_at_end() const {
    return state_->nothing_waits() && !state_->helpers().empty() &&
           std::ranges::any_of(state_->pool.in_order(),
                               [](const WorkerProxy* proxy) { return proxy->working() != 0; });
}

// ---- Helpers and stragglers ---------------------------------------------------------------------

bool Dispatcher::State::can_help(const WorkerProxy& proxy) const {
    const bool is_expecting = std::ranges::any_of(recalls, [&](const auto& recall) {
        return recall.second.helper == proxy.id() &&
               now - recall.second.since < limits::recall_answer_seconds;
    });
    return proxy.takes_work() && !proxy.is_claimed() && !is_expecting &&
           proxy.working() < proxy.facts().threads;
}

std::vector<WorkerProxy*> Dispatcher::State::helpers() const {
    std::vector<WorkerProxy*> found;
    for (WorkerProxy* proxy : pool.in_order()) {
        if (can_help(*proxy)) {
            found.push_back(proxy);
        }
    }
    std::ranges::stable_sort(
        found, std::greater<>(), [this](const WorkerProxy* proxy) { return power_of(*proxy); });
    return found;
}

double Dispatcher::State::ends_in(const WorkerProxy& proxy) const {
    if (proxy.working() == 0) {
        return 0;
    }
    double seconds = 0; // For one thread.
    for (const auto& [id, task] : proxy.tasks()) {
        if (!task.is_range()) {
            seconds += 1e-9 * static_cast<double>(task.cost_ns) / speed_of(proxy);
        } else if (const auto job = jobs.find(task.job); job != jobs.end()) {
            seconds += static_cast<double>(task.places_left) * proxy.facts().threads /
                       places_per_second(proxy, job->second);
        }
    }
    seconds /= static_cast<double>(std::min<std::uint64_t>(proxy.working(), proxy.facts().threads));
    // An overdue worker is assumed to need as long again as it is overdue.
    return std::abs(std::max(proxy.progressed(), proxy.transfers_end()) + seconds - now);
}

void Dispatcher::State::help_at_end(Actions& actions) {
    if (!options.helps_at_end || !nothing_waits() || !is_due(helped)) {
        return;
    }
    helped = now;
    std::vector<WorkerProxy*> free = helpers();
    for (WorkerProxy* from : free.empty() ? std::vector<WorkerProxy*>{} : late_workers()) {
        from->note_looked_at(now);
        // Tries the fastest helpers first; another of the first few may hold the blocks.
        for (std::size_t i = 0; i < std::min(free.size(), limits::helpers_tried_max);) {
            WorkerProxy& helper = *free[i];
            if (&helper == from || !helps(*from, helper, actions)) {
                ++i;
            } else if (!can_help(helper)) {
                free.erase(free.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
    }
}

std::vector<WorkerProxy*> Dispatcher::State::late_workers() {
    std::vector<std::pair<double, WorkerProxy*>> late;
    for (WorkerProxy* proxy : pool.in_order()) {
        const double seconds = may_be_helped(*proxy) ? ends_in(*proxy) : 0;
        if (seconds > limits::end_gain_seconds_min) {
            late.emplace_back(seconds, proxy);
        }
    }
    const std::size_t most =
        std::max(limits::late_looked_at_min, pool.in_order().size() / limits::late_looked_at_part);
    if (late.size() > most) {
        std::ranges::stable_sort(
            late, {}, [](const auto& entry) { return entry.second->looked_at(); });
        late.resize(most);
    }
    std::ranges::stable_sort(late, std::greater<>(), &std::pair<double, WorkerProxy*>::first);
    std::vector<WorkerProxy*> workers;
    for (const auto& [seconds, proxy] : late) {
        workers.push_back(proxy);
    }
    return workers;
}

bool Dispatcher::State::may_answer_recall(const WorkerProxy& proxy) const {
    const auto asked = recalls.find(proxy.id());
    return asked != recalls.end() && proxy.takes_work() &&
           now - asked->second.since < limits::recall_answer_seconds;
}

bool Dispatcher::State::may_be_helped(const WorkerProxy& from) const {
    const bool may_be_asked = !recalls.contains(from.id()) && from.takes_work();
    return !may_answer_recall(from) && std::ranges::any_of(from.tasks(), [&](const auto& entry) {
        const ProxyTask& task = entry.second;
        return task.left() != 0 && !task.is_copy &&
               ((may_be_asked && !task.has_begun) || can_be_copied(task));
    });
}

bool Dispatcher::State::can_be_copied(const ProxyTask& task) const {
    if (task.is_range()) {
        return task.places_left > task.places_copied;
    }
    const DispatchJob& job = jobs.at(task.job);
    const auto may_be = [&](std::uint64_t index) {
        const auto found = job.scenarios.find(index);
        return found != job.scenarios.end() && found->second.may_be_copied();
    };
    return job.is_by_time() && std::ranges::any_of(task.scenarios, may_be);
}

bool Dispatcher::State::helps(WorkerProxy& from, WorkerProxy& helper, Actions& actions) {
    if (!recalls.contains(from.id()) && from.takes_work() && ask_back(from, helper, actions)) {
        return true;
    }
    return !may_answer_recall(from) && copy(from, helper, actions);
}

// ---- Recalls --------------------------------------------------------------------------------

bool Dispatcher::State::ask_back(WorkerProxy& from, const WorkerProxy& helper, Actions& actions) {
    // The newest task begins last.
    for (const auto& [id, task] : std::views::reverse(from.tasks())) {
        if (task.left() == 0 || task.is_copy || task.has_begun) {
            continue;
        }
        AskBack ask =
            task.is_range() ? range_to_ask(from, id, helper) : batch_to_ask(from, id, helper);
        const std::uint64_t count =
            task.is_range() ? task.places->count - ask.places : ask.scenarios.size();
        if (count != 0) {
            recalls[from.id()] = {id, count, helper.id(), now};
            actions.push_back(std::move(ask));
            return true;
        }
    }
    return false;
}

AskBack Dispatcher::State::batch_to_ask(const WorkerProxy& from,
                                        TaskId task,
                                        const WorkerProxy& helper) const {
    AskBack ask{from.id(), task, {}, 0};
    const ProxyTask& content = from.tasks().at(task);
    const DispatchJob& job = jobs.at(content.job);
    if (!job.is_by_time()) {
        return ask;
    }
    double seconds_here = ends_in(from);
    double seconds_there = 0;
    for (const std::uint64_t index : std::views::reverse(content.scenarios)) {
        const DispatchScenario& scenario = job.at(index);
        if (scenario.copy || scenario.recalls == limits::scenario_recalls_max) {
            continue;
        }
        const double finish = finish_on(helper, job, scenario).total() + seconds_there;
        if (finish + limits::end_gain_seconds_min > seconds_here) {
            break;
        }
        ask.scenarios.push_back(index);
        const double work = 1e-9 * static_cast<double>(scenario.weight.cost_ns);
        seconds_here -= work / power_of(from);
        seconds_there += work / power_of(helper);
    }
    std::ranges::sort(ask.scenarios);
    return ask;
}

AskBack Dispatcher::State::range_to_ask(const WorkerProxy& from,
                                        TaskId task,
                                        const WorkerProxy& helper) const {
    const ProxyTask& content = from.tasks().at(task);
    const std::uint64_t most = content.places_copied != 0 ? 0 : content.places_left;
    const std::uint64_t count =
        std::min(most, places_to_move(from, jobs.at(content.job), helper, ends_in(from), 1));
    return {from.id(), task, {}, content.places->count - count};
}

std::uint64_t Dispatcher::State::places_to_move(const WorkerProxy& from,
                                                const DispatchJob& job,
                                                const WorkerProxy& helper,
                                                double seconds_here,
                                                double gain) const {
    const double rate_here = places_per_second(from, job);
    const double rate_there = places_per_second(helper, job);
    const double begins = ends_in(helper) + limits::end_gain_seconds_min;
    const double one = helper.facts().threads / rate_there + job.missing_any.value_or(0);
    if (gain * (begins + one) > seconds_here) {
        return 0;
    }
    // Chosen so that both finish together.
    const double count = (seconds_here - begins) / (1 / rate_here + 1 / rate_there);
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(count));
}

void Dispatcher::State::take_recalled(WorkerProxy& proxy,
                                      const Recalled& recalled,
                                      Actions& actions) {
    const ProxyTask& task = proxy.tasks().at(recalled.task);
    DispatchJob* job = find_job(task.job);
    GivenBack given{recalled.task, task.job, 0, {}};
    if (job != nullptr && task.is_range()) {
        const std::uint64_t before = task.cost_ns;
        given.places = proxy.cut_places(recalled.task, recalled.places);
        job->work_ns -= std::min(job->work_ns, before - task.cost_ns); // Will be sent again.
    } else if (job != nullptr) {
        given.scenarios = take_recalled_scenarios(proxy, *job, recalled);
    }
    const std::uint64_t count = given.scenarios + given.places.count;
    const auto asked = recalls.find(proxy.id());
    if (asked != recalls.end() && asked->second.task == recalled.task) {
        if (count < asked->second.asked) {
            proxy.set_begun(recalled.task);
        }
        recalls.erase(asked);
    }
    if (count != 0) {
        actions.push_back(given);
    }
}

std::uint64_t Dispatcher::State::take_recalled_scenarios(WorkerProxy& proxy,
                                                         DispatchJob& job,
                                                         const Recalled& recalled) {
    std::uint64_t count = 0;
    std::vector<std::uint64_t> again;
    for (const std::uint64_t index : recalled.scenarios) {
        const auto found = job.scenarios.find(index);
        if (found == job.scenarios.end() || !found->second.is_in(recalled.task)) {
            continue; // Returned before, or answered by another worker.
        }
        DispatchScenario& scenario = found->second;
        ++count;
        if (!mutated(Mutation::RecalledLeftAtWorker)) {
            proxy.answer(recalled.task, index, scenario.weight.cost_ns, false);
        }
        if (!leave_task(scenario, recalled.task)) {
            ++scenario.recalls;
            again.push_back(index);
        }
    }
    unsent += again.size();
    wait_first(job, again);
    return count;
}

bool Dispatcher::State::leave_task(DispatchScenario& scenario, TaskId task) {
    if (!scenario.copy) {
        return false;
    }
    if (scenario.copy->task != task) {
        scenario.worker = scenario.copy->worker;
        scenario.task = scenario.copy->task;
    }
    scenario.copy.reset();
    return true;
}

// ---- Speculative copies -------------------------------------------------------------------------

std::uint64_t Dispatcher::State::copies_left_ns(const DispatchJob& job) {
    const auto most =
        static_cast<std::uint64_t>(limits::copies_share_max * static_cast<double>(job.work_ns));
    return most - std::min(most, job.copied_ns);
}

bool Dispatcher::State::copy(WorkerProxy& from, WorkerProxy& helper, Actions& actions) {
    for (const auto& [id, task] : std::views::reverse(from.tasks())) {
        if (task.left() == 0 || task.is_copy) {
            continue;
        }
        DispatchJob& job = jobs.at(task.job);
        const bool has_copied = task.is_range()
                                    ? copy_places(from, id, helper, actions)
                                    : job.is_by_time() && copy_scenario(from, id, helper, actions);
        if (has_copied) {
            return true;
        }
    }
    return false;
}

bool Dispatcher::State::copy_scenario(WorkerProxy& from,
                                      TaskId task,
                                      WorkerProxy& helper,
                                      Actions& actions) {
    DispatchJob& job = jobs.at(from.tasks().at(task).job);
    double seconds_here = ends_in(from);
    for (const std::uint64_t index : std::views::reverse(from.tasks().at(task).scenarios)) {
        DispatchScenario& scenario = job.at(index);
        const std::uint64_t cost_ns = scenario.weight.cost_ns;
        if (!scenario.may_be_copied()) {
            seconds_here -= 1e-9 * static_cast<double>(cost_ns) / power_of(from);
            continue;
        }
        const double finish =
            finish_on(helper, job, scenario).total() + limits::end_gain_seconds_min;
        if (limits::copy_gain_min * finish > seconds_here || cost_ns > copies_left_ns(job)) {
            return false;
        }
        const bool fetches = !hold_all(job, scenario.roots, helper).is_nothing();
        const TaskId id{++task_last};
        ProxyTask content{job.id, {index}, false, cost_ns, now, fetches, 0};
        content.is_copy = true;
        scenario.copy = {helper.id(), id};
        scenario.was_copied = true;
        job.copied_ns += cost_ns;
        helper.start_task(id, std::move(content));
        actions.push_back(SendBatch{helper.id(), id, job.id, {index}, true});
        return true;
    }
    return false;
}

bool Dispatcher::State::copy_places(WorkerProxy& from,
                                    TaskId task,
                                    WorkerProxy& helper,
                                    Actions& actions) {
    const ProxyTask& content = from.tasks().at(task);
    DispatchJob& job = jobs.at(content.job);
    // Workers process ranges from the front, so mostly the last positions are left.
    if (content.places_left <= content.places_copied) {
        return false;
    }
    const double copied_seconds =
        static_cast<double>(content.places_copied) / places_per_second(from, job);
    const std::uint64_t each_ns = std::max<std::uint64_t>(1, content.cost_ns / content.places_left);
    const auto batch =
        static_cast<std::uint64_t>(limits::batch_seconds_start * places_per_second(helper, job));
    const std::uint64_t count = std::min(
        {content.places_left - content.places_copied,
         copies_left_ns(job) / each_ns,
         std::max<std::uint64_t>(batch, helper.facts().threads),
         places_to_move(from, job, helper, ends_in(from) - copied_seconds, limits::copy_gain_min)});
    if (count == 0) {
        return false;
    }
    const PlaceRange places{content.places->end() - content.places_copied - count, count};
    const TaskId id{++task_last};
    ProxyTask twice{job.id, {}, false, count * each_ns, now, false, 0, places, count};
    twice.is_copy = true;
    from.add_copied(task, count);
    job.copied_ns += count * each_ns;
    helper.start_task(id, std::move(twice));
    actions.push_back(SendRange{helper.id(), id, job.id, places, task});
    return true;
}

} // namespace cd
