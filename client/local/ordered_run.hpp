// Runs scenarios on the threads of a pool and returns the results in order.
#pragma once

#include "client/local/done_block.hpp"
#include "client/local/result_queue.hpp"
#include "client/local/waiting_scenarios.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/scenario.hpp"
#include "common/job/statistics.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <vector>

namespace cd {

/// Runs scenarios, which are added in order, on pool threads; results are taken in that order.
///
/// Threads exchange scenarios and results in batches of about a millisecond, so that short
/// scenarios do not cost a wakeup each, and long ones do not wait for each other. Results that are
/// not yet taken are bounded in number and bytes.
class OrderedRun {
  public:
    /// `ended` is the flag that the runner's stop check reads; the destructor sets it. `first` is
    /// the index of the first scenario that will be added.
    OrderedRun(const ScenarioRunner& runner,
               std::atomic<bool>& ended,
               ThreadPool& pool,
               std::uint64_t first = 0);
    OrderedRun(const OrderedRun&) = delete;
    OrderedRun& operator=(const OrderedRun&) = delete;
    /// Drops scenarios that were not run, and returns when all pool threads have left `work`.
    ~OrderedRun();

    /// Returns how many scenarios to add now: 0 while the threads have enough, or while too many
    /// results wait to be taken.
    [[nodiscard]] std::uint64_t wanted();

    void add(std::vector<Scenario> scenarios);

    /// Waits for the next results in order. Returns none after the period, or, if `may_add`, when
    /// scenarios are wanted. The results returned count as waiting until the next call of `take`.
    [[nodiscard]] DoneBlock take(std::chrono::milliseconds period, bool may_add);

    /// Returns the statistics of all scenarios taken so far, and possibly of some more.
    [[nodiscard]] JobStatistics statistics();

  private:
    /// Scenarios that a thread has taken, and results that it has not handed over yet.
    struct Batch {
        std::vector<Scenario> waiting; ///< After `run_some`, the ones that were not run.
        DoneBlock done;
        JobStatistics statistics;
        std::size_t size = 1; ///< Number of scenarios to take next.
    };

    [[nodiscard]] std::uint64_t wanted_now() const;
    void work();
    [[nodiscard]] bool refill(Batch& batch);
    [[nodiscard]] bool run_next(ScenarioSession& session, const Scenario& scenario, Batch& batch);
    void run_some(ScenarioSession& session, Batch& batch);
    void hand_over(Batch& batch);

    const ScenarioRunner& runner_;
    std::atomic<bool>& ended_;
    unsigned thread_count_;

    std::mutex mutex_;
    std::condition_variable work_came_;
    std::condition_variable state_changed_;
    WaitingScenarios waiting_;
    ResultQueue done_;
    std::uint64_t added_ = 0; ///< Index of the next scenario to be added.
    JobStatistics statistics_;
    unsigned threads_left_; ///< Pool threads still in `work`.
    bool stopping_ = false;
};

} // namespace cd
