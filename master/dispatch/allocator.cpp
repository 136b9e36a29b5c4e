#include "master/dispatch/allocator.hpp"

#include "common/core/timing/master.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void Allocator::settle(Actions& actions) {
    give_suspects(actions);
    set_batches();
    flush_all(actions);
    for (DispatchJob* job : queue_.in_order()) {
        while (allocate_one(*job, actions)) {
        }
    }
    // If a job has run out of waiting scenarios, its partly filled buffers may be ripe now.
    flush_all(actions);
}

void Allocator::flush_all(Actions& actions) {
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        filler_.flush_ripe(*proxy, actions);
    }
}

void Allocator::take_up(DispatchJob& job, bool is_suspect, bool resumes, Actions& actions) {
    if (is_suspect) {
        give_suspects(actions);
    }
    // If scenarios waited before the added one, no worker could take them, and none can now. With a
    // pull policy, however, the added scenario may complete a task.
    if (job.waiting.size() == 1 || job.policy->workers_pull()) {
        allocate_one(job, actions);
    }
    if (resumes || is_suspect) {
        // A pause may have held back buffers of long scenarios (`ends_with_long_ones`). A suspect
        // reserves a worker, whose buffers are sent so that it becomes idle.
        flush_all(actions);
    }
}

void Allocator::set_batches() {
    const ClusterPace& pace = context_.pace;
    std::uint64_t unsent_ns = 0;
    double power = 0;
    for (const WorkerProxy* proxy : context_.pool.in_order()) {
        unsent_ns += proxy->buffers.cost_ns();
        power += proxy->takes_work() ? pace.power_of(*proxy) : 0;
    }
    // A batch is at most half of a worker's share of the buffered work, unless a round trip to the
    // worker takes longer. If nothing is buffered, the share is unknown and does not shorten
    // batches.
    const double share = power > 0 && unsent_ns > 0
                             ? 1e-9 * static_cast<double>(unsent_ns) / (2 * power)
                             : timing::batch_seconds_max;
    const double mean_ns = pace.mean_cost_ns();
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        const double least = std::max(proxy->batch.seconds_least(), timing::batch_seconds_min);
        const double seconds = std::max(std::min(proxy->batch.seconds(), share), least);
        proxy->batch.set(static_cast<std::uint64_t>(1e9 * seconds * pace.power_of(*proxy)),
                         mean_ns > 1e9 * timing::scenario_seconds_long * pace.speed_of(*proxy));
    }
}

bool Allocator::allocate_one(DispatchJob& job, Actions& actions) {
    if (job.waiting.empty()) {
        return false;
    }
    if (job.policy->workers_pull()) {
        return filler_.pull_one(job, actions);
    }
    const std::uint64_t position = job.waiting.front();
    DispatchScenario& scenario = job.at(position);
    WorkerProxy* proxy = job.policy->choose(job, scenario);
    if (proxy == nullptr) {
        return false;
    }
    job.waiting.pop_front();
    scenario.where = Whereabouts::Buffered;
    scenario.at = {proxy->id(), {}};
    MissingBlocks missing = blocks_.hold(job, scenario, *proxy);
    proxy->buffers.add(job.id, position, scenario.weight);
    filler_.flush_full(*proxy, job, actions);
    if (scenario.where == Whereabouts::Buffered && job.policy->hints(job)) {
        missing.hint(*proxy, job, actions);
    }
    return true;
}

void Allocator::give_suspects(Actions& actions) {
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        if (queue_.suspects().empty()) {
            return;
        }
        if (!proxy->takes_work() || !proxy->is_idle()) {
            continue;
        }
        const Suspect suspect = queue_.take_suspect();
        DispatchJob& job = queue_.at(suspect.job);
        blocks_.hold(job, job.at(suspect.position), *proxy);
        tasks_.send(*proxy, job, {suspect.position}, true, actions);
    }
}

void Allocator::take_back_buffers(WorkerProxy& proxy) {
    while (!proxy.buffers.all().empty()) {
        DispatchJob& job = queue_.at(proxy.buffers.all().begin()->first);
        queue_.put_back(job, proxy.buffers.take(job.id).scenarios);
    }
}

} // namespace cd
