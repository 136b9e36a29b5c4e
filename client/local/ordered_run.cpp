#include "client/local/ordered_run.hpp"

#include "common/core/limits/client.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

using namespace std::chrono_literals;

/// While this many scenarios wait for each thread, no more are wanted.
constexpr std::uint64_t waiting_enough = 2 * limits::run_batch_scenarios_max;
constexpr std::uint64_t block_scenarios = 512; ///< Scenarios to add at a time.
/// How long a thread should run one batch.
constexpr std::chrono::steady_clock::duration batch_time = 1ms;
constexpr std::size_t looks_a_batch = 64; ///< How often a thread looks at the clock in a batch.

} // namespace

OrderedRun::OrderedRun(const ScenarioRunner& runner,
                       std::atomic<bool>& ended,
                       ThreadPool& pool,
                       std::uint64_t first)
    : runner_(runner),
      ended_(ended),
      thread_count_(pool.size()),
      waiting_(limits::run_batch_scenarios_max),
      done_(first),
      added_(first),
      threads_left_(pool.size()) {
    for (unsigned i = 0; i < thread_count_; ++i) {
        pool.post([this] { work(); });
    }
}

OrderedRun::~OrderedRun() {
    ended_ = true;
    std::unique_lock lock(mutex_);
    stopping_ = true;
    work_came_.notify_all();
    state_changed_.wait(lock, [this] { return threads_left_ == 0; });
}

std::uint64_t OrderedRun::wanted() {
    const std::lock_guard lock(mutex_);
    return wanted_now();
}

std::uint64_t OrderedRun::wanted_now() const {
    const bool has_room = !done_.is_full() && added_ - done_.next() + block_scenarios <=
                                                  limits::run_scenarios_ahead_max;
    return has_room && waiting_.size() < waiting_enough * thread_count_ ? block_scenarios : 0;
}

void OrderedRun::add(std::vector<Scenario> scenarios) {
    const std::lock_guard lock(mutex_);
    added_ += scenarios.size();
    waiting_.add(std::move(scenarios));
    work_came_.notify_all();
}

DoneBlock OrderedRun::take(std::chrono::milliseconds period, bool may_add) {
    std::unique_lock lock(mutex_);
    const bool was_full = done_.is_full();
    done_.release_taken();
    if (was_full) {
        work_came_.notify_all();
    }
    state_changed_.wait_for(lock, period, [this, may_add] {
        return done_.is_next_here() || (may_add && wanted_now() > 0);
    });
    DoneBlock taken = done_.take();
    if (done_.is_full()) {
        work_came_.notify_all(); // A thread may now run the scenario that is due next.
    }
    return taken;
}

JobStatistics OrderedRun::statistics() {
    const std::lock_guard lock(mutex_);
    return statistics_;
}

void OrderedRun::work() {
    ScenarioSession session(runner_);
    Batch batch;
    while (refill(batch)) {
        run_some(session, batch);
        hand_over(batch);
    }
    const std::lock_guard lock(mutex_);
    --threads_left_;
    state_changed_.notify_all();
}

/// Waits for work and takes the next batch. Returns false when the run is stopping.
bool OrderedRun::refill(Batch& batch) {
    std::unique_lock lock(mutex_);
    work_came_.wait(lock, [this] {
        // While waiting results reach their bound, only the scenario due next is run, since without
        // it no result can be taken.
        return stopping_ ||
               (!waiting_.empty() && (!done_.is_full() || waiting_.first() == done_.next()));
    });
    if (stopping_) {
        return false;
    }
    const std::size_t share = waiting_.size() / (2 * std::size_t{thread_count_}) + 1;
    batch.waiting = waiting_.take(std::min(batch.size, share));
    return true;
}

/// Runs one scenario. Returns false if the run has ended, so that nobody waits for its result.
bool OrderedRun::run_next(ScenarioSession& session, const Scenario& scenario, Batch& batch) {
    ScenarioRun run = session.run(scenario);
    if (run.is_stopped) {
        return false;
    }
    batch.statistics += {run.statistics, run.inside};
    if (runner_.query().maps) {
        batch.done.add(run.result, std::move(run.found));
    } else {
        batch.done.add(run.result);
    }
    return true;
}

void OrderedRun::run_some(ScenarioSession& session, Batch& batch) {
    // A look at the clock takes a few percent of a short scenario.
    const std::size_t scenarios_a_look = batch.size / looks_a_batch + 1;
    const auto start = std::chrono::steady_clock::now();
    std::chrono::steady_clock::duration spent{};
    std::size_t ran = 0;
    batch.done = {};
    while (ran < batch.waiting.size() && spent < 4 * batch_time &&
           batch.done.bytes() < limits::run_batch_bytes_max &&
           run_next(session, batch.waiting[ran], batch)) {
        ++ran;
        if (ran % scenarios_a_look == 0) {
            spent = std::chrono::steady_clock::now() - start;
        }
    }
    spent = std::chrono::steady_clock::now() - start;
    batch.waiting.erase(batch.waiting.begin(),
                        batch.waiting.begin() + static_cast<std::ptrdiff_t>(ran));
    const auto fits = batch_time * std::max<std::size_t>(ran, 1) / std::max(spent, 1ns);
    batch.size =
        std::clamp<std::size_t>(static_cast<std::size_t>(fits), 1, limits::run_batch_scenarios_max);
}

void OrderedRun::hand_over(Batch& batch) {
    const std::lock_guard lock(mutex_);
    if (!batch.waiting.empty()) {
        waiting_.give_back(std::move(batch.waiting));
        work_came_.notify_all();
    }
    done_.add(std::move(batch.done));
    statistics_ += batch.statistics;
    batch.statistics = {};
    if (done_.is_next_here() || wanted_now() > 0) {
        state_changed_.notify_one();
    }
}

} // namespace cd
