#include "master/dispatch/policy/rebalancer.hpp"

#include "common/core/limits/master.hpp"
#include "master/dispatch/policy/earliest_finish.hpp"

#include <algorithm>

namespace cd {

void Rebalancer::rebalance(Actions& actions) {
    if (std::ranges::none_of(queue_.jobs(),
                             [](const auto& job) { return job.second.policy->moves_work(); })) {
        return;
    }
    std::vector<Backlog> full; // Heap; latest finish on top.
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        add_backlog(full, *proxy);
    }
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        if (full.empty()) {
            return;
        }
        const bool runs_dry = proxy->buffers.count() == 0 && proxy->would_run_dry_by_time();
        if (runs_dry && proxy->takes_work() && proxy != context_.reserved() &&
            !proxy->is_claimed()) {
            WorkerProxy& fullest = *full.front().worker;
            std::pop_heap(full.begin(), full.end());
            full.pop_back();
            move(fullest, *proxy);
            add_backlog(full, fullest);
            filler_.flush_ripe(*proxy, actions);
            add_backlog(full, *proxy);
        }
    }
}

void Rebalancer::add_backlog(std::vector<Backlog>& full, WorkerProxy& proxy) const {
    const double seconds = static_cast<double>(proxy.backlog_ns()) / context_.pace.power_of(proxy);
    if (proxy.buffers.count() != 0 && seconds > 0) {
        full.push_back({seconds, &proxy});
        std::push_heap(full.begin(), full.end());
    }
}

void Rebalancer::move(WorkerProxy& from, WorkerProxy& to) {
    for (DispatchJob* job : queue_.in_order()) {
        std::size_t tries = limits::moves_tried_max;
        while (job->policy->moves_work() && tries-- > 0 &&
               to.backlog_ns() < 2 * to.batch.cost_ns() && move_one(from, to, *job)) {
        }
    }
}

bool Rebalancer::move_one(WorkerProxy& from, WorkerProxy& to, DispatchJob& job) {
    const ScenarioBuffer& buffer = from.buffers.of(job.id);
    if (buffer.scenarios.empty()) {
        return false;
    }
    if (ends_with_long_ones(queue_, from, job)) {
        const auto cost = [&](std::uint64_t position) { return job.at(position).weight.cost_ns; };
        const auto longest = std::ranges::max_element(buffer.scenarios, {}, cost);
        if (move_if_earlier(from, to, job, *longest)) {
            return true;
        }
    }
    // The last buffered scenario would finish only after all other work of `from`.
    return move_if_earlier(from, to, job, buffer.scenarios.back());
}

bool Rebalancer::move_if_earlier(WorkerProxy& from,
                                 WorkerProxy& to,
                                 DispatchJob& job,
                                 std::uint64_t position) {
    DispatchScenario& scenario = job.at(position);
    const double seconds_there =
        1e-9 * static_cast<double>(from.backlog_ns()) / context_.pace.power_of(from);
    if (job.policy->finish_on(to, job, scenario).total() >= seconds_there) {
        return false;
    }
    from.buffers.remove(job.id, position, scenario.weight);
    scenario.at = {to.id(), {}};
    blocks_.hold(job, scenario, to);
    to.buffers.add(job.id, position, scenario.weight);
    return true;
}

} // namespace cd
