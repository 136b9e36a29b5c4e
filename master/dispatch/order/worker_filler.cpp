#include "master/dispatch/order/worker_filler.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace cd {

// ---- Whose turn it is ---------------------------------------------------------------------------

bool WorkerFiller::is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const {
    const MatchingPolicy& policy = *job.policy;
    if (proxy.buffers.of(job.id).scenarios.empty() || !policy.has_room_for_task(proxy, job)) {
        return false;
    }
    const bool nothing_comes = queue_.nothing_comes(job) || &proxy == context_.reserved();
    return policy.is_full(proxy, job) || (nothing_comes && policy.would_run_dry(proxy, job));
}

bool WorkerFiller::has_buffer_for(const WorkerProxy& proxy, const DispatchJob& job) const {
    return !proxy.buffers.of(job.id).scenarios.empty() && !proxy.is_claimed() &&
           (job.policy->is_full(proxy, job) || queue_.nothing_comes(job) ||
            &proxy == context_.reserved());
}

bool WorkerFiller::wants_to_flush(const WorkerProxy& proxy, const DispatchJob& job) const {
    const std::size_t tasks_max =
        std::max<std::size_t>(job.policy->bounds(proxy, job).tasks, proxy.facts().threads);
    return proxy.tasks.unanswered_of(job.id) < tasks_max && has_buffer_for(proxy, job);
}

bool WorkerFiller::wants_to_pull(const WorkerProxy& proxy, const DispatchJob& job) const {
    const bool takes_the_rest = job.policy->workers_pull() && !job.waiting.empty() &&
                                queue_.input_rests(job) && job.policy->may_take(proxy, job);
    return takes_the_rest || job.policy->can_pull(proxy, job);
}

bool WorkerFiller::may_send(const WorkerProxy& proxy, const DispatchJob& job) const {
    const double batch_ns = 1e9 * proxy.batch.seconds() * context_.pace.power_of(proxy);
    if (proxy.tasks.left() < proxy.facts().threads ||
        static_cast<double>(proxy.tasks.cost_ns()) < batch_ns) {
        return true;
    }
    return proxy.tasks.left_of(job.id) == proxy.tasks.left() &&
           (is_ripe(proxy, job) || job.policy->can_pull(proxy, job) ||
            ranges_.would_take(proxy, job));
}

DispatchJob* WorkerFiller::next(const WorkerProxy& proxy) const {
    const DispatchJob* first = nullptr; // Has work for the worker.
    DispatchJob* ready = nullptr;       // May send it now.
    const auto is_before = [this](const DispatchJob& job, const DispatchJob* other) {
        return other == nullptr || queue_.order().comes_before(job.id, other->id);
    };
    for (auto& [id, job] : queue_.jobs()) {
        const bool pulls = wants_to_pull(proxy, job);
        if (is_before(job, first) &&
            (pulls || has_buffer_for(proxy, job) || ranges_.has_range_for(proxy, job))) {
            first = &job;
        }
        if (is_before(job, ready) &&
            (pulls || wants_to_flush(proxy, job) || ranges_.may_take(proxy, job))) {
            ready = &job;
        }
    }
    const bool runs_dry = proxy.tasks.left() < proxy.facts().threads;
    return ready != nullptr && (ready == first || runs_dry) && may_send(proxy, *ready) ? ready
                                                                                       : nullptr;
}

void WorkerFiller::fill_in_turn(WorkerProxy& proxy, Actions& actions) {
    while (DispatchJob* job = next(proxy)) {
        if (wants_to_flush(proxy, *job)) {
            flush(proxy, *job, actions);
        } else if (wants_to_pull(proxy, *job)) {
            pull(proxy, *job, actions);
        } else {
            ranges_.send(proxy, *job, actions);
        }
    }
}

// ---- Sending ------------------------------------------------------------------------------------

void WorkerFiller::fill(WorkerProxy& proxy, Actions& actions) {
    if (has_several_jobs()) {
        return fill_in_turn(proxy, actions);
    }
    for (auto& [id, job] : queue_.jobs()) {
        flush_ripe(proxy, actions);
        while (job.policy->can_pull(proxy, job)) {
            pull(proxy, job, actions);
        }
        while (ranges_.would_take(proxy, job)) {
            ranges_.send(proxy, job, actions);
        }
    }
}

void WorkerFiller::give_ranges(Actions& actions) {
    if (std::ranges::all_of(queue_.jobs(),
                            [](const auto& job) { return job.second.unsent.is_empty(); })) {
        return;
    }
    ranges_.forget_totals();
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        fill(*proxy, actions);
    }
}

void WorkerFiller::flush_ripe(WorkerProxy& proxy, Actions& actions) {
    if (proxy.buffers.count() == 0) {
        return;
    }
    if (has_several_jobs()) {
        return fill_in_turn(proxy, actions);
    }
    DispatchJob& job = queue_.jobs().begin()->second;
    while (is_ripe(proxy, job)) {
        flush(proxy, job, actions);
    }
}

void WorkerFiller::flush_full(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    const auto may_flush = [&] {
        return job.policy->is_full(proxy, job) && job.policy->has_room_for_task(proxy, job);
    };
    if (has_several_jobs() && may_flush()) {
        return fill_in_turn(proxy, actions);
    }
    // Loops because, in matching by time, a batch takes only a part of the buffer.
    while (may_flush()) {
        flush(proxy, job, actions);
    }
}

void WorkerFiller::flush(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    tasks_.send(proxy, job, job.policy->take_batch(proxy, job), job.policy->claims(job), actions);
}

bool WorkerFiller::pull_one(DispatchJob& job, Actions& actions) {
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        if (job.policy->can_pull(*proxy, job) && (!has_several_jobs() || next(*proxy) == &job)) {
            pull(*proxy, job, actions);
            return true;
        }
    }
    return false;
}

void WorkerFiller::pull(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
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

} // namespace cd
