#include "master/dispatch/policy/matching_policy.hpp"

#include "master/base/mutation.hpp"

namespace cd {

bool MatchingPolicy::may_take(const WorkerProxy& proxy, const DispatchJob& job) const {
    return proxy.takes_work() && !proxy.is_claimed() && &proxy != context_.reserved() &&
           !proxy.buffers.of(job.id).is_full(job.options);
}

WorkBounds MatchingPolicy::bounds(const WorkerProxy& proxy, const DispatchJob& job) const {
    return {job.options.q, job.options.q, proxy.tasks_max(job.options)};
}

bool MatchingPolicy::is_full(const WorkerProxy& proxy, const DispatchJob& job) const {
    return proxy.buffers.of(job.id).is_full(job.options);
}

bool MatchingPolicy::has_room_for_task(const WorkerProxy& proxy, const DispatchJob& job) const {
    return proxy.has_room_for_task(job.id, job.options) ||
           (mutated(Mutation::BatchesWithoutBound) && !proxy.is_claimed());
}

bool MatchingPolicy::would_run_dry(const WorkerProxy& proxy, const DispatchJob& job) const {
    return proxy.would_run_dry(job.options);
}

std::vector<std::uint64_t> MatchingPolicy::take_batch(WorkerProxy& proxy,
                                                      const DispatchJob& job) const {
    return proxy.buffers.take(job.id).scenarios;
}

std::uint64_t MatchingPolicy::enough(const DispatchJob& job) const {
    return job.options.q * context_.pool.in_order().size();
}

} // namespace cd
