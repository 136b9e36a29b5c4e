// The strategy `earliest-finish`. Each scenario goes at once to the buffer of the worker with the
// earliest estimated finish, even a busy one that holds its blocks. A worker that runs dry takes
// over scenarios it would finish earlier, transfers included. So no scenario waits longer than its
// transfer would take, and at the end of a job a slow worker gets nothing that others would finish
// earlier.
#pragma once

#include "common/core/limits/master.hpp"
#include "master/dispatch/policy/matching_policy.hpp"

#include <cstdint>
#include <vector>

namespace cd {

class EarliestFinish : public MatchingPolicy {
  public:
    using MatchingPolicy::MatchingPolicy;

    [[nodiscard]] WorkerProxy* would_choose(const DispatchJob& job,
                                            const DispatchScenario& scenario) const override;
    [[nodiscard]] bool may_take(const WorkerProxy& proxy,
                                const DispatchJob& /*job*/) const override {
        return proxy.takes_work() && &proxy != context().reserved();
    }
    [[nodiscard]] std::string_view why() const override {
        return "the scenario would be done there first";
    }

    /// A buffer may have all scenarios; a batch takes only a part of it.
    [[nodiscard]] WorkBounds bounds(const WorkerProxy& /*proxy*/,
                                    const DispatchJob& /*job*/) const override {
        return {~std::uint64_t{0}, limits::q_max, limits::batches_at_worker};
    }
    [[nodiscard]] bool is_full(const WorkerProxy& proxy, const DispatchJob& job) const override;
    /// If the job's last scenarios are long, a busy worker has no room: a scenario would wait there
    /// that an idle worker could take.
    [[nodiscard]] bool has_room_for_task(const WorkerProxy& proxy,
                                         const DispatchJob& job) const override;
    [[nodiscard]] bool would_run_dry(const WorkerProxy& proxy,
                                     const DispatchJob& /*job*/) const override {
        return proxy.would_run_dry_by_time();
    }
    /// Takes the head of the buffer, up to the batch size. The last long scenarios go longest
    /// first, so that the workers finish together.
    [[nodiscard]] std::vector<std::uint64_t> take_batch(WorkerProxy& proxy,
                                                        const DispatchJob& job) const override;
    [[nodiscard]] bool claims(const DispatchJob& /*job*/) const override { return false; }
    /// Number that fills two batches per worker, and leaves as many again to choose from.
    [[nodiscard]] std::uint64_t enough(const DispatchJob& job) const override;

    [[nodiscard]] bool moves_work() const override { return true; }
    [[nodiscard]] FinishTerms finish_on(const WorkerProxy& proxy,
                                        const DispatchJob& job,
                                        const DispatchScenario& scenario) const override;
    [[nodiscard]] bool hints(const DispatchJob& job) const override { return job.options.hints; }
};

/// True if the job gets no more scenarios for now, and scenarios are long (`BatchSize::are_long`).
[[nodiscard]] bool
ends_with_long_ones(const WorkQueue& queue, const WorkerProxy& proxy, const DispatchJob& job);

} // namespace cd
