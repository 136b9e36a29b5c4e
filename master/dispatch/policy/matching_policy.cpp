#include "master/dispatch/policy/matching_policy.hpp"

#include "master/base/mutation.hpp"
#include "master/dispatch/policy/best_match.hpp"
#include "master/dispatch/policy/best_match_load.hpp"
#include "master/dispatch/policy/best_match_pull.hpp"
#include "master/dispatch/policy/earliest_finish.hpp"
#include "master/dispatch/policy/lowest.hpp"
#include "master/dispatch/policy/random.hpp"

namespace cd {

bool MatchingPolicy::may_take(const WorkerProxy& proxy, const DispatchJob& job) const {
    return proxy.takes_work() && !proxy.is_claimed() && &proxy != context_.reserved() &&
           !proxy.buffers.of(job.id).is_full(job.options);
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

std::unique_ptr<MatchingPolicy> make_policy(const ClusterOptions& options,
                                            const MatchingContext& context) {
    // A strategy is a file of this folder, and a line here.
    switch (options.strategy) {
    case Strategy::BestMatch:
        return std::make_unique<BestMatch>(context);
    case Strategy::BestMatchLoad:
        return std::make_unique<BestMatchLoad>(context);
    case Strategy::Random:
        return std::make_unique<RandomWorker>(context, options.seed);
    case Strategy::Lowest:
        return std::make_unique<Lowest>(context);
    case Strategy::BestMatchPull:
        return std::make_unique<BestMatchPull>(context);
    case Strategy::EarliestFinish:
        break;
    }
    return std::make_unique<EarliestFinish>(context);
}

} // namespace cd
