#include "client/local_run.hpp"

#include "common/core/check.hpp"
#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <utility>

namespace cd {

namespace {

using Clock = std::chrono::steady_clock;

/// How far work may run ahead of the result that is delivered next.
constexpr std::uint64_t scenarios_ahead_max = 4096;
constexpr std::uint64_t bytes_ahead_max = 256u << 20;
constexpr std::uint64_t block_scenarios = 64;
constexpr std::chrono::milliseconds progress_period{100};

std::uint64_t bytes_of(const ScenarioResult& result) {
    return sizeof result + result.pairs.size() * sizeof(ContactPair) +
           (result.points.size() + result.point_origins.size()) * sizeof(Vec3) +
           result.point_offsets.size() * sizeof(std::uint32_t);
}

/// Scenarios go in, in order; pool threads run them; results come out in the same order.
class OrderedRun {
  public:
    /// `ended` is what the runner's check for an end looks at.
    OrderedRun(const ScenarioRunner& runner, std::atomic<bool>& ended, ThreadPool& pool)
        : runner_(runner), ended_(ended), threads_(pool.size()) {
        for (unsigned i = 0; i < threads_; ++i) {
            pool.post([this] { work(); });
        }
    }
    OrderedRun(const OrderedRun&) = delete;
    OrderedRun& operator=(const OrderedRun&) = delete;

    /// Returns when no thread of the pool is in here any more; what waits is dropped.
    ~OrderedRun() {
        ended_ = true;
        std::unique_lock lock(mutex_);
        stopping_ = true;
        work_came_.notify_all();
        state_changed_.wait(lock, [this] { return threads_ == 0; });
    }

    /// True when the threads would soon run dry and there is room for more results.
    [[nodiscard]] bool wants_more() {
        const std::lock_guard lock(mutex_);
        return has_room();
    }

    void add(std::vector<Scenario> scenarios) {
        const std::lock_guard lock(mutex_);
        added_ += scenarios.size();
        for (Scenario& scenario : scenarios) {
            waiting_.push_back(std::move(scenario));
        }
        work_came_.notify_all();
    }

    /// The next result in order, if it comes before the period is over; or, with `may_add`, before
    /// this wants more.
    [[nodiscard]] std::optional<ScenarioResult> take(std::chrono::milliseconds period,
                                                     bool may_add) {
        std::unique_lock lock(mutex_);
        state_changed_.wait_for(lock, period, [this, may_add] {
            return done_.contains(taken_) || (may_add && has_room());
        });
        auto node = done_.extract(taken_);
        if (node.empty()) {
            return std::nullopt;
        }
        ++taken_;
        bytes_ahead_ -= bytes_of(node.mapped());
        return std::move(node.mapped());
    }

    /// Of all scenarios run so far.
    [[nodiscard]] JobStatistics statistics() {
        const std::lock_guard lock(mutex_);
        return statistics_;
    }

  private:
    [[nodiscard]] bool has_room() const {
        return waiting_.size() < block_scenarios * threads_ && bytes_ahead_ < bytes_ahead_max &&
               added_ - taken_ + block_scenarios <= scenarios_ahead_max;
    }

    void work() {
        std::unique_lock lock(mutex_);
        while (true) {
            work_came_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
            if (stopping_) {
                break;
            }
            const Scenario scenario = std::move(waiting_.front());
            waiting_.pop_front();
            lock.unlock();
            ScenarioRun run = runner_.run(scenario);
            lock.lock();
            if (run.is_stopped) {
                continue; // Nobody waits for it.
            }
            statistics_ += {run.statistics, run.inside};
            bytes_ahead_ += bytes_of(run.result);
            const bool wakes = scenario.index == taken_ || has_room();
            done_.emplace(scenario.index, std::move(run.result));
            if (wakes) {
                state_changed_.notify_all();
            }
        }
        --threads_;
        state_changed_.notify_all();
    }

    const ScenarioRunner& runner_;
    std::atomic<bool>& ended_;

    std::mutex mutex_;
    std::condition_variable work_came_;
    std::condition_variable state_changed_;
    std::deque<Scenario> waiting_;
    std::map<std::uint64_t, ScenarioResult> done_; ///< Found, and not yet taken.
    std::uint64_t added_ = 0;
    std::uint64_t taken_ = 0; ///< Also the index that is taken next.
    std::uint64_t bytes_ahead_ = 0;
    JobStatistics statistics_;
    unsigned threads_; ///< That have not left.
    bool stopping_ = false;
};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Hands the next scenarios to the run while it wants them.
Status feed(OrderedRun& run, PoseSource& poses, std::uint64_t& fed) {
    while (fed < poses.count() && run.wants_more()) {
        auto scenarios = poses.read(fed, std::min(block_scenarios, poses.count() - fed));
        if (!scenarios) {
            return scenarios.error();
        }
        fed += scenarios.value().size();
        run.add(std::move(scenarios.value()));
    }
    return Done{};
}

} // namespace

Result<RunOutcome> run_locally(const ObbTree& a,
                               const ObbTree& b,
                               PoseSource& poses,
                               const Query& query,
                               ThreadPool& pool,
                               const RunObserver& observer,
                               PairStage first_stage) {
    const auto start = Clock::now();
    auto progress_due = start;
    ResultMerger merger(poses.count());
    std::atomic<bool> ended = false;
    const ScenarioRunner runner(
        a, b, query, first_stage, [&ended] { return ended.load(std::memory_order_relaxed); });
    OrderedRun run(runner, ended, pool);
    std::uint64_t fed = 0;
    while (!merger.summary().is_complete()) {
        if (observer.stopped()) {
            return Error{ErrorCode::Interrupted, "interrupted; no results were kept"};
        }
        if (Status more = feed(run, poses, fed); !more) {
            return more.error();
        }
        if (Clock::now() >= progress_due) {
            observer.progress(merger.summary(), seconds_since(start));
            progress_due = Clock::now() + progress_period;
        }
        const auto result = run.take(progress_period, fed < poses.count());
        if (!result) {
            continue;
        }
        if (Status added = observer.result(*result); !added) {
            return added.error();
        }
        const auto outcome = merger.add(*result);
        CD_CHECK(outcome == ResultMerger::Outcome::Added);
    }
    return RunOutcome{merger.summary(), merger.digest(), seconds_since(start), run.statistics()};
}

} // namespace cd
