// Scenarios on their way through the threads of a pool, and their results back in order.
#pragma once

#include "client/local/done_scenario.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/job/result/result.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/scenario.hpp"
#include "common/job/statistics.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace cd {

/// Scenarios go in, in order; pool threads run them; results come out in the same order.
///
/// Threads hand over what they have done, and take more, some scenarios at a time: as many as take
/// a fraction of a millisecond, so that scenarios of microseconds do not cost a wakeup each and
/// those of seconds do not wait for each other. What runs ahead of the results taken is bounded in
/// number and in bytes.
class OrderedRun {
  public:
    /// `ended` is what the runner's check for an end looks at; `first` is the index of the first
    /// scenario that will be added.
    OrderedRun(const ScenarioRunner& runner,
               std::atomic<bool>& ended,
               ThreadPool& pool,
               std::uint64_t first = 0);
    OrderedRun(const OrderedRun&) = delete;
    OrderedRun& operator=(const OrderedRun&) = delete;
    /// Returns when no thread of the pool is in here any more; what waits is dropped.
    ~OrderedRun();

    /// How many scenarios to add now: none while the threads have enough before them, or too many
    /// results wait.
    [[nodiscard]] std::uint64_t wanted();

    void add(std::vector<Scenario> scenarios);

    /// The next results in order, as soon as there are any; none if the period is over before, or
    /// with `may_add` when this wants more. Those taken count as waiting until the next call.
    [[nodiscard]] std::vector<DoneScenario> take(std::chrono::milliseconds period, bool may_add);

    /// Of all scenarios taken so far, and perhaps some more.
    [[nodiscard]] JobStatistics statistics();

  private:
    /// What one thread has taken, and what it has done and not handed over.
    struct Batch {
        std::vector<Scenario> waiting;
        std::size_t ran = 0; ///< Of these.
        std::vector<DoneScenario> done;
        JobStatistics statistics;
        std::uint64_t bytes = 0; ///< Of the results.
        std::size_t size = 1;    ///< How many to take next.
    };

    [[nodiscard]] std::uint64_t wanted_now() const;
    [[nodiscard]] bool is_next_done() const;
    void work();
    [[nodiscard]] bool refill(Batch& batch);
    void run_some(ScenarioSession& session, Batch& batch);
    void hand_over(Batch& batch);

    const ScenarioRunner& runner_;
    std::atomic<bool>& ended_;
    unsigned thread_count_;

    std::mutex mutex_;
    std::condition_variable work_came_;
    std::condition_variable state_changed_;
    std::deque<Scenario> waiting_; ///< In order.
    /// Found, and not yet taken, by index from `taken_` on.
    std::deque<std::optional<DoneScenario>> done_;
    std::uint64_t added_ = 0;
    std::uint64_t taken_ = 0; ///< Also the index that is taken next.
    std::uint64_t bytes_ahead_ = 0;
    std::uint64_t bytes_in_hand_ = 0; ///< Of these, taken by the last call.
    JobStatistics statistics_;
    unsigned threads_left_; ///< In here.
    bool stopping_ = false;
};

} // namespace cd
