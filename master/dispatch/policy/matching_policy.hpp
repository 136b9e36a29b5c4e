// Decisions of a matching strategy: the worker of a scenario, and the moment when scenarios become
// a task.
#pragma once

#include "master/dispatch/blocks/block_plan.hpp"
#include "master/dispatch/policy/finish_estimate.hpp"
#include "master/dispatch/work_queue.hpp"
#include "master/dispatch/workers/cluster_pace.hpp"
#include "master/dispatch/workers/worker_pool.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace cd {

/// Parts of the dispatcher that policies read.
struct MatchingContext {
    WorkerPool& pool;
    const BlockPlan& plan;
    const WorkQueue& queue;
    const ClusterPace& pace;

    /// The worker being emptied for suspect scenarios; null if there are none.
    [[nodiscard]] const WorkerProxy* reserved() const {
        return queue.suspects().empty() ? nullptr : pool.first_that_takes_work();
    }
};

/// A job's policy. By default buffers make tasks as the paper has it (6.4.3): q scenarios or more
/// than V kB, as soon as the worker has room or would run dry.
class MatchingPolicy {
  public:
    MatchingPolicy(const MatchingContext& context, const ClusterOptions& /*options*/)
        : context_(context) {}
    virtual ~MatchingPolicy() = default;
    MatchingPolicy(const MatchingPolicy&) = delete;
    MatchingPolicy& operator=(const MatchingPolicy&) = delete;

    // ---- A worker for each scenario -------------------------------------------------------------
    /// The worker for the scenario. Null if none may take it now.
    [[nodiscard]] virtual WorkerProxy* choose(const DispatchJob& job,
                                              const DispatchScenario& scenario) {
        return would_choose(job, scenario);
    }
    /// Returns the worker that `choose` would return. Changes nothing.
    [[nodiscard]] virtual WorkerProxy* would_choose(const DispatchJob& job,
                                                    const DispatchScenario& scenario) const = 0;
    /// The worker may take a scenario of the job now.
    [[nodiscard]] virtual bool may_take(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Tells the user why the chosen worker is chosen.
    [[nodiscard]] virtual std::string_view why() const = 0;

    // ---- Scenarios for a free worker ------------------------------------------------------------
    /// True: a free worker takes from the waiting scenarios, and nothing is buffered.
    [[nodiscard]] virtual bool is_pulled() const { return false; }
    /// The worker may pull a task now.
    [[nodiscard]] virtual bool can_pull(const WorkerProxy& /*proxy*/,
                                        const DispatchJob& /*job*/) const {
        return false;
    }
    /// The waiting scenarios that it pulls, as indices into `DispatchJob::waiting`, ascending.
    [[nodiscard]] virtual std::vector<std::size_t> pulled(const WorkerProxy& /*proxy*/,
                                                          const DispatchJob& /*job*/) const {
        return {};
    }

    // ---- Buffers and tasks ----------------------------------------------------------------------
    /// The worker's buffer makes a task.
    [[nodiscard]] virtual bool is_full(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] virtual bool has_room_for_task(const WorkerProxy& proxy,
                                                 const DispatchJob& job) const;
    [[nodiscard]] virtual bool would_run_dry(const WorkerProxy& proxy,
                                             const DispatchJob& job) const;
    /// Takes the next task from a buffer that is not empty.
    [[nodiscard]] virtual std::vector<std::uint64_t> take_batch(WorkerProxy& proxy,
                                                                const DispatchJob& job) const;
    /// While a task runs, its worker gets nothing else.
    [[nodiscard]] virtual bool claims(const DispatchJob& job) const { return job.options.claim; }
    /// Number of unsent scenarios that gives all workers enough choice.
    [[nodiscard]] virtual std::uint64_t enough(const DispatchJob& job) const;

    // ---- Time -----------------------------------------------------------------------------------
    /// The policy estimates when a scenario is done (`finish_on`): its scenarios move between
    /// buffers, and are recalled and copied at the end of the job.
    [[nodiscard]] virtual bool is_by_time() const { return false; }
    /// When the worker would finish the scenario, from now; zeros unless `is_by_time`.
    [[nodiscard]] virtual FinishTerms finish_on(const WorkerProxy& /*proxy*/,
                                                const DispatchJob& /*job*/,
                                                const DispatchScenario& /*scenario*/) const {
        return {};
    }
    /// Announces missing blocks before it sends a task. The paper's strategies do not.
    [[nodiscard]] virtual bool hints(const DispatchJob& /*job*/) const { return false; }

  protected:
    [[nodiscard]] const MatchingContext& context() const { return context_; }

  private:
    MatchingContext context_;
};

} // namespace cd
