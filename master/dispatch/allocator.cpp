#include "master/dispatch/allocator.hpp"

#include "common/core/timing/master.hpp"
#include "master/dispatch/round_robin.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void Allocator::settle(Actions& actions) {
    give_suspects(actions);
    set_batches();
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        flush_ripe(*proxy, actions);
    }
    const auto is_served = [&](auto& job) { return allocate_one(job.second, actions); };
    while (next_in_turn(queue_.jobs(), queue_.served_last(), is_served) != nullptr) {
    }
    // If a job has run out of waiting scenarios, its partly filled buffers may be ripe now.
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        flush_ripe(*proxy, actions);
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
        for (WorkerProxy* proxy : context_.pool.in_order()) {
            flush_ripe(*proxy, actions);
        }
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
    // A batch is at most half of a worker's share of the buffered work. If nothing is buffered, the
    // share is unknown and does not shorten batches.
    const double share = power > 0 && unsent_ns > 0
                             ? 1e-9 * static_cast<double>(unsent_ns) / (2 * power)
                             : timing::batch_seconds_max;
    const double mean_ns = pace.mean_cost_ns();
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        const double seconds =
            std::max(std::min(proxy->batch.seconds(), share), timing::batch_seconds_min);
        proxy->batch.set(static_cast<std::uint64_t>(1e9 * seconds * pace.power_of(*proxy)),
                         mean_ns > 1e9 * timing::scenario_seconds_long * pace.speed_of(*proxy));
    }
}

bool Allocator::allocate_one(DispatchJob& job, Actions& actions) {
    if (job.waiting.empty()) {
        return false;
    }
    if (job.policy->workers_pull()) {
        return pull_one(job, actions);
    }
    const std::uint64_t position = job.waiting.front();
    DispatchScenario& scenario = job.at(position);
    WorkerProxy* proxy = job.policy->choose(job, scenario);
    if (proxy == nullptr) {
        return false;
    }
    job.waiting.pop_front();
    queue_.note_served(job.id);
    scenario.where = Whereabouts::Buffered;
    scenario.at = {proxy->id(), {}};
    MissingBlocks missing = blocks_.hold(job, scenario, *proxy);
    proxy->buffers.add(job.id, position, scenario.weight);
    // Loops because, in matching by time, a batch takes only a part of the buffer.
    while (job.policy->is_full(*proxy, job) && job.policy->has_room_for_task(*proxy, job)) {
        flush(*proxy, job, actions);
    }
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

void Allocator::flush_ripe(WorkerProxy& proxy, Actions& actions) {
    const auto ripe = [&](const auto& buffer) { return is_ripe(proxy, queue_.at(buffer.first)); };
    while (const auto* buffer = next_in_turn(proxy.buffers.all(), proxy.tasks.last_job(), ripe)) {
        flush(proxy, queue_.at(buffer->first), actions);
    }
}

bool Allocator::is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const {
    const MatchingPolicy& policy = *job.policy;
    if (proxy.buffers.of(job.id).scenarios.empty() || !policy.has_room_for_task(proxy, job)) {
        return false;
    }
    const bool nothing_comes = queue_.nothing_comes(job) || &proxy == context_.reserved();
    return policy.is_full(proxy, job) || (nothing_comes && policy.would_run_dry(proxy, job));
}

void Allocator::flush(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    tasks_.send(proxy, job, job.policy->take_batch(proxy, job), job.policy->claims(job), actions);
}

void Allocator::refill(WorkerProxy& proxy, Actions& actions) {
    flush_ripe(proxy, actions);
    for (auto& [id, job] : queue_.jobs()) {
        while (job.policy->can_pull(proxy, job)) {
            pull(proxy, job, actions);
        }
    }
}

bool Allocator::pull_one(DispatchJob& job, Actions& actions) {
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        if (job.policy->can_pull(*proxy, job)) {
            queue_.note_served(job.id);
            pull(*proxy, job, actions);
            return true;
        }
    }
    return false;
}

void Allocator::pull(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    std::vector<bool> is_taken(job.waiting.size(), false);
    std::vector<std::uint64_t> taken;
    for (const std::size_t index : job.policy->pulled(proxy, job)) {
        const std::uint64_t position = job.waiting[index];
        blocks_.hold(job, job.at(position), proxy);
        is_taken[index] = true;
        taken.push_back(position);
    }
    std::size_t index = 0;
    std::erase_if(job.waiting, [&](std::uint64_t) { return is_taken[index++]; });
    tasks_.send(proxy, job, std::move(taken), job.policy->claims(job), actions);
}

void Allocator::take_back_buffers(WorkerProxy& proxy) {
    while (!proxy.buffers.all().empty()) {
        DispatchJob& job = queue_.at(proxy.buffers.all().begin()->first);
        queue_.put_back(job, proxy.buffers.take(job.id).scenarios);
    }
}

} // namespace cd
