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

/// Upper bounds on the work of one job at one worker.
struct WorkBounds {
    std::uint64_t buffered = 0; ///< Scenarios in its buffer.
    std::uint64_t batch = 0;    ///< Scenarios in a task.
    std::size_t tasks = 0;      ///< Tasks; more only while it has fewer scenarios than threads.
};

/// A job's policy. By default a buffer becomes a task as in the paper (6.4.3): with q scenarios or
/// more than V kB once the worker has room, or if no more come and the worker would run dry.
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
    /// True if the worker may take a scenario of the job now.
    [[nodiscard]] virtual bool may_take(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Tells the user why the chosen worker is chosen.
    [[nodiscard]] virtual std::string_view why() const = 0;
    /// Tells the user why no worker is chosen.
    [[nodiscard]] virtual std::string_view why_none() const {
        return "no worker may take a scenario now";
    }

    // ---- Scenarios for a free worker ------------------------------------------------------------
    /// True if free workers take from the waiting scenarios (`can_pull`) and `choose` gives null.
    [[nodiscard]] virtual bool workers_pull() const { return false; }
    /// True if the worker may pull a task of the job now.
    [[nodiscard]] virtual bool can_pull(const WorkerProxy& /*proxy*/,
                                        const DispatchJob& /*job*/) const {
        return false;
    }
    /// The waiting scenarios that the worker pulls: ascending indices into `DispatchJob::waiting`.
    [[nodiscard]] virtual std::vector<std::size_t> pulled(const WorkerProxy& /*proxy*/,
                                                          const DispatchJob& /*job*/) const {
        return {};
    }

    // ---- Buffers and tasks ----------------------------------------------------------------------
    /// Bounds of the job's work at the worker.
    [[nodiscard]] virtual WorkBounds bounds(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// True if the worker's buffer has enough scenarios of the job for a task.
    [[nodiscard]] virtual bool is_full(const WorkerProxy& proxy, const DispatchJob& job) const;
    [[nodiscard]] virtual bool has_room_for_task(const WorkerProxy& proxy,
                                                 const DispatchJob& job) const;
    [[nodiscard]] virtual bool would_run_dry(const WorkerProxy& proxy,
                                             const DispatchJob& job) const;
    /// Removes and returns the next task's positions from the job's buffer, which is not empty.
    [[nodiscard]] virtual std::vector<std::uint64_t> take_batch(WorkerProxy& proxy,
                                                                const DispatchJob& job) const;
    /// True if a worker gets nothing else while it has a task of the job.
    [[nodiscard]] virtual bool claims(const DispatchJob& job) const { return job.options.claim; }
    /// Number of unsent scenarios that gives all workers enough choice.
    [[nodiscard]] virtual std::uint64_t enough(const DispatchJob& job) const;

    // ---- Time -----------------------------------------------------------------------------------
    /// True: work that another worker would finish earlier, by `finish_on`, moves there. Buffered
    /// scenarios move at any time; sent ones are recalled and copied at the end of the job.
    [[nodiscard]] virtual bool moves_work() const { return false; }
    /// Estimated seconds until the worker finishes the scenario; zeros unless `moves_work`.
    [[nodiscard]] virtual FinishTerms finish_on(const WorkerProxy& /*proxy*/,
                                                const DispatchJob& /*job*/,
                                                const DispatchScenario& /*scenario*/) const {
        return {};
    }
    /// True if missing blocks are announced before the task is sent. The paper has no such hints.
    [[nodiscard]] virtual bool hints(const DispatchJob& /*job*/) const { return false; }

  protected:
    [[nodiscard]] const MatchingContext& context() const { return context_; }

  private:
    MatchingContext context_;
};

} // namespace cd
