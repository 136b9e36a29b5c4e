// What is always true between two events of the dispatcher.
#include "common/core/check.hpp"
#include "common/core/limits.hpp"
#include "master/dispatcher_state.hpp"

#include <algorithm>

namespace cd {

namespace {

std::uint64_t cost_of(const DispatchJob& job, std::span<const std::uint64_t> scenarios) {
    std::uint64_t cost_ns = 0;
    for (const std::uint64_t index : scenarios) {
        cost_ns += job.scenarios.at(index).weight.cost_ns;
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
    // Each is somewhere (check_job), and there are no more places taken than scenarios.
    CD_CHECK(known == placed);
    CD_CHECK(unsent == not_sent);
}

void Dispatcher::State::check_job(const DispatchJob& job) const {
    const auto holds = [](const auto& list, std::uint64_t index) {
        return std::count(list.begin(), list.end(), index) == 1;
    };
    std::uint64_t unsent_places = 0;
    for (const PlaceRange& range : job.places) {
        CD_CHECK(range.count != 0);
        unsent_places += range.count;
    }
    CD_CHECK(unsent_places == job.places_unsent);
    for (const auto& [index, scenario] : job.scenarios) {
        CD_CHECK(scenario.losses < limits::scenario_losses_max);
        switch (scenario.where) {
        case Whereabouts::Waiting:
            CD_CHECK(holds(job.waiting, index));
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
            break;
        }
        }
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
        // A buffer that is ripe has been flushed.
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
        CD_CHECK(task.places_left <= task.places.count);
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

void Dispatcher::State::check_progress() const {
    const WorkerProxy* excluded = reserved();
    for (const auto& [id, proxy] : pool.all()) {
        if (!proxy.takes_work()) {
            continue;
        }
        CD_CHECK(suspects.empty() || !proxy.is_idle());
        for (const auto& [job_id, job] : jobs) {
            // How many places go to it at once depends on what others do; but it has something.
            CD_CHECK(!takes_places(proxy, job) || !proxy.tasks().empty());
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
    }
    state_->check_progress();
}

} // namespace cd
