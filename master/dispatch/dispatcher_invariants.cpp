// Invariants of the dispatcher, which hold between two events.
#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "master/dispatch/dispatcher_state.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace cd {

namespace {

std::uint64_t cost_of(const DispatchJob& job, std::span<const std::uint64_t> scenarios) {
    std::uint64_t cost_ns = 0;
    for (const std::uint64_t index : scenarios) {
        cost_ns += job.at(index).weight.cost_ns;
    }
    return cost_ns;
}

} // namespace

void Dispatcher::State::check_counts() const {
    std::uint64_t known = 0;
    std::uint64_t placed = suspects.size();
    std::uint64_t not_sent = suspects.size();
    for (const auto& [id, job] : jobs) {
        known += job.scenarios.size();
        known += static_cast<std::uint64_t>(std::ranges::count_if(
            job.scenarios, [](const auto& scenario) { return scenario.second.copy.has_value(); }));
        placed += job.waiting.size();
        not_sent += job.waiting.size();
    }
    for (const auto& [id, proxy] : pool.all()) {
        placed += proxy.buffered();
        for (const auto& [task_id, task] : proxy.tasks()) {
            placed += task.scenarios.size();
        }
        not_sent += proxy.buffered();
    }
    // Each scenario and copy is somewhere (check_job), and the counts match, so nothing is
    // duplicated.
    CD_CHECK(known == placed);
    CD_CHECK(unsent == not_sent);
}

void Dispatcher::State::check_job(const DispatchJob& job) const {
    const auto holds = [](const auto& list, std::uint64_t index) {
        return std::count(list.begin(), list.end(), index) == 1;
    };
    std::vector<std::uint64_t> waiting(job.waiting.begin(), job.waiting.end());
    std::ranges::sort(waiting); // Linear search would cost quadratic time.
    CD_CHECK(std::ranges::adjacent_find(waiting) == waiting.end());
    std::uint64_t unsent_places = 0;
    for (const PlaceRange& range : job.places) {
        CD_CHECK(range.count != 0);
        unsent_places += range.count;
    }
    CD_CHECK(unsent_places == job.places_unsent);
    for (const auto& [index, scenario] : job.scenarios) {
        CD_CHECK(scenario.losses.count() < limits::scenario_losses_max);
        CD_CHECK(!scenario.copy || scenario.where == Whereabouts::Sent);
        switch (scenario.where) {
        case Whereabouts::Waiting:
            CD_CHECK(std::ranges::binary_search(waiting, index));
            break;
        case Whereabouts::Suspect:
            CD_CHECK(std::any_of(suspects.begin(), suspects.end(), [&](const Suspect& suspect) {
                return suspect.job == job.id && suspect.scenario == index;
            }));
            break;
        case Whereabouts::Buffered: {
            const WorkerProxy* proxy = pool.find(scenario.worker);
            CD_CHECK(proxy != nullptr);
            CD_CHECK(holds(proxy->buffer(job.id).scenarios, index));
            break;
        }
        case Whereabouts::Sent: {
            const WorkerProxy* proxy = pool.find(scenario.worker);
            CD_CHECK(proxy != nullptr);
            CD_CHECK(holds(proxy->tasks().at(scenario.task).scenarios, index));
            check_copy(job, index, scenario);
            break;
        }
        }
    }
}

void Dispatcher::State::check_copy(const DispatchJob& job,
                                   std::uint64_t index,
                                   const DispatchScenario& scenario) const {
    if (!scenario.copy) {
        return;
    }
    CD_CHECK(scenario.was_copied);
    CD_CHECK(scenario.copy->worker != scenario.worker);
    const WorkerProxy* proxy = pool.find(scenario.copy->worker);
    CD_CHECK(proxy != nullptr);
    const ProxyTask& task = proxy->tasks().at(scenario.copy->task);
    CD_CHECK(task.is_copy);
    CD_CHECK(task.job == job.id);
    CD_CHECK(task.scenarios == std::vector<std::uint64_t>{index});
}

void Dispatcher::State::check_recalls() const {
    for (const auto& [worker, recall] : recalls) {
        const WorkerProxy* proxy = pool.find(worker);
        CD_CHECK(proxy != nullptr);
        CD_CHECK(proxy->tasks().contains(recall.task));
        CD_CHECK(!proxy->is_silent());
        CD_CHECK(recall.asked != 0);
    }
}

void Dispatcher::State::check_worker(const WorkerProxy& proxy) const {
    std::uint64_t cost_ns = 0;
    std::uint64_t buffered = 0;
    for (const auto& [id, buffer] : proxy.buffers()) {
        CD_CHECK(jobs.contains(id));
        CD_CHECK(!buffer.scenarios.empty());
        const DispatchJob& job = jobs.at(id);
        CD_CHECK(job.is_by_time() || buffer.scenarios.size() <= job.options.q);
        CD_CHECK(!job.is_pulled());
        CD_CHECK(buffer.cost_ns == cost_of(job, buffer.scenarios));
        cost_ns += buffer.cost_ns;
        // Ripe buffers must have been flushed.
        CD_CHECK(!is_ripe(proxy, jobs.at(id)));
        buffered += buffer.scenarios.size();
    }
    CD_CHECK(buffered == proxy.buffered());
    CD_CHECK(proxy.takes_work() || buffered == 0);

    std::uint64_t working = 0;
    std::uint64_t working_ns = 0;
    std::size_t claiming = 0;
    for (const auto& [id, task] : proxy.tasks()) {
        CD_CHECK(id.value <= task_last);
        working += task.left();
        claiming += task.claims ? 1 : 0;
        CD_CHECK(!task.is_range() || task.places_left <= task.places->count);
        CD_CHECK(!task.is_range() || task.places_copied <= task.places->count);
        CD_CHECK(
            task.is_range()
                ? task.scenarios.empty()
                : task.cost_ns ==
                      (task.scenarios.empty() ? 0 : cost_of(jobs.at(task.job), task.scenarios)));
        working_ns += task.cost_ns;
    }
    CD_CHECK(working_ns == proxy.working_ns());
    CD_CHECK(cost_ns + working_ns == proxy.backlog_ns());
    CD_CHECK(working == proxy.working());
    CD_CHECK(claiming <= 1);
    CD_CHECK((claiming == 1) == proxy.is_claimed());
}

/// Bounds the work at a worker: for each job the allowed number of unanswered tasks or, where a
/// worker has less work than threads, as many as it has threads.
void Dispatcher::State::check_flight(const WorkerProxy& proxy) const {
    std::map<JobId, std::size_t> unanswered;
    for (const auto& [id, task] : proxy.tasks()) {
        if (task.left() == 0) {
            continue; // The end message is under way.
        }
        const DispatchJob& job = jobs.at(task.job);
        const std::uint64_t batch_max = job.is_by_time() ? limits::q_max : job.options.q;
        CD_CHECK(task.left() <= (task.is_range() ? limits::range_scenarios_max : batch_max));
        ++unanswered[task.job];
    }
    for (const auto& [id, tasks] : unanswered) {
        const DispatchJob& job = jobs.at(id);
        const std::size_t tasks_max =
            job.is_by_time() ? limits::batches_at_worker : proxy.tasks_max(job.options);
        CD_CHECK(tasks <= std::max<std::size_t>(tasks_max, proxy.facts().threads));
    }
}

void Dispatcher::State::check_progress() const {
    forget_place_totals();
    const WorkerProxy* excluded = reserved();
    for (const auto& [id, proxy] : pool.all()) {
        if (!proxy.takes_work()) {
            continue;
        }
        CD_CHECK(suspects.empty() || !proxy.is_idle());
        for (const auto& [job_id, job] : jobs) {
            // Range sizes depend on other workers' load, but some worker must be working.
            CD_CHECK(!takes_places(proxy, job) ||
                     std::ranges::any_of(
                         pool.all(), [](const auto& one) { return !one.second.tasks().empty(); }));
            if (job.is_pulled()) {
                CD_CHECK(!can_pull(proxy, job));
                continue;
            }
            const bool can_take =
                &proxy != excluded &&
                (job.is_by_time() ||
                 (!proxy.is_claimed() && !proxy.buffer(job_id).is_full(job.options)));
            CD_CHECK(job.waiting.empty() || !can_take);
        }
    }
}

void Dispatcher::check_invariants() const {
    state_->check_counts();
    state_->pool.check();
    for (const auto& [id, job] : state_->jobs) {
        state_->check_job(job);
    }
    for (const auto& [id, proxy] : state_->pool.all()) {
        state_->check_worker(proxy);
        state_->check_flight(proxy);
    }
    state_->check_recalls();
    state_->check_progress();
}

} // namespace cd
