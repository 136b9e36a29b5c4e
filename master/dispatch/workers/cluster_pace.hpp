// Speed at which workers compute and receive blocks. An unmeasured worker counts as average.
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "master/dispatch/blocks/block_plan.hpp"
#include "master/dispatch/dispatch_inputs.hpp"
#include "master/dispatch/job/dispatch_job.hpp"
#include "master/dispatch/policy/finish_estimate.hpp"
#include "master/dispatch/workers/worker_proxy.hpp"

#include <algorithm>
#include <cstdint>

namespace cd {

/// The current time, and the measured speeds over all workers. `WorkerProxy::pace` has the speeds
/// of one worker.
class ClusterPace {
  public:
    /// Seconds since any fixed point; must not decrease.
    void time_is(double seconds);
    [[nodiscard]] double now() const { return now_; }

    /// Adds work that took the worker's threads `seconds`. `predicted_ns`: its predicted time.
    void add_work(WorkerProxy& proxy, std::uint64_t predicted_ns, double seconds);
    void add_transfer(WorkerProxy& proxy, std::uint64_t bytes, double seconds);
    void add_scenario(std::uint64_t cost_ns);

    /// Mean predicted time of the recently added scenarios, ns.
    [[nodiscard]] double mean_cost_ns() const;
    /// Predicted time of so many positions without analysis, each as long as the mean, ns; not 0
    /// for one. In this unit a job's copies have a share of its work, whichever worker has them.
    [[nodiscard]] std::uint64_t mean_cost_of(std::uint64_t positions) const;
    /// Predicted seconds of work that one thread of the worker does per second.
    [[nodiscard]] double speed_of(const WorkerProxy& proxy) const;
    /// Predicted seconds of work that all threads of the worker do per second.
    [[nodiscard]] double power_of(const WorkerProxy& proxy) const;
    /// Bytes of blocks that reach the worker per second.
    [[nodiscard]] double link_of(const WorkerProxy& proxy) const;
    [[nodiscard]] WorkerPowers powers_of(const WorkerProxy& proxy, const BlockPlan& plan) const;
    /// Scenarios of the job's ranges that all threads of the worker finish per second.
    [[nodiscard]] double positions_per_second(const WorkerProxy& proxy,
                                              const DispatchJob& job) const;
    /// Predicted time of one position of the job's ranges, for the worker.
    [[nodiscard]] std::uint64_t position_ns(const WorkerProxy& proxy, const DispatchJob& job) const;
    /// Time in which one thread of the worker would finish the unanswered part of the job's task.
    [[nodiscard]] double thread_seconds_of(const TaskInFlight& task,
                                           const WorkerProxy& proxy,
                                           const DispatchJob& job) const;
    /// Estimated seconds until the worker has received and decoded the missing blocks.
    [[nodiscard]] double seconds_of(const BlockPlan::Missing& missing,
                                    const WorkerProxy& proxy) const;

  private:
    double now_ = 0;
    WorkerPace general_;
    LearnedRate mean_cost_ns_;
};

// Inline, because matching by time calls these for every worker and every scenario.

inline double ClusterPace::speed_of(const WorkerProxy& proxy) const {
    return proxy.facts().weight * proxy.pace.work.value_or(general_.work.value_or(1));
}

inline double ClusterPace::power_of(const WorkerProxy& proxy) const {
    return speed_of(proxy) * proxy.facts().threads;
}

inline double ClusterPace::link_of(const WorkerProxy& proxy) const {
    return proxy.pace.bytes.value_or(general_.bytes.value_or(limits::link_bytes_per_second_start));
}

inline WorkerPowers ClusterPace::powers_of(const WorkerProxy& proxy, const BlockPlan& plan) const {
    WorkerPowers powers;
    powers.speed = speed_of(proxy);
    powers.bytes_per_second = link_of(proxy);
    powers.threads = proxy.facts().threads;
    powers.backlog_ns = static_cast<double>(proxy.backlog_ns());
    powers.transfers_seconds = std::max(0.0, proxy.transfers_end() - now_);
    if (proxy.facts().cache_bytes != 0) {
        const std::uint64_t used =
            plan.held_triangles(proxy.slot()) * limits::wide_bytes_per_triangle;
        powers.room_bytes = proxy.facts().cache_bytes - std::min(used, proxy.facts().cache_bytes);
    }
    return powers;
}

} // namespace cd
