#include "client/local/ordered_run.hpp"

#include "common/core/limits/client.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cd {

namespace {

using namespace std::chrono_literals;

/// While this many scenarios wait for each thread, no more are wanted.
constexpr std::uint64_t waiting_enough = 256;
constexpr std::uint64_t block_scenarios = 512; ///< Scenarios to add at a time.
/// How long a thread should run one batch.
constexpr std::chrono::steady_clock::duration batch_time = 250us;

std::uint64_t bytes_of(const DoneScenario& done) {
    const ScenarioResult& result = done.result;
    return sizeof done + done.record.size() + done.found.size() * sizeof(ContactPair) +
           result.pairs.size() * sizeof(ContactPair) +
           (result.points.size() + result.point_origins.size()) * sizeof(Vec3) +
           result.point_offsets.size() * sizeof(std::uint32_t);
}

} // namespace

bool ResultQueue::is_full() const {
    return bytes_ >= limits::run_bytes_ahead_max;
}

void ResultQueue::add(std::vector<DoneScenario>& results, std::uint64_t bytes) {
    for (DoneScenario& done : results) {
        const std::uint64_t slot = done.result.index - next_;
        if (slot >= waiting_.size()) {
            waiting_.resize(slot + 1);
        }
        waiting_[slot] = std::move(done);
    }
    bytes_ += bytes;
}

std::vector<DoneScenario> ResultQueue::take() {
    std::vector<DoneScenario> taken;
    while (is_next_here() && taken.size() < limits::run_taken_at_once_max) {
        bytes_taken_ += bytes_of(*waiting_.front());
        taken.push_back(std::move(*waiting_.front()));
        waiting_.pop_front();
        ++next_;
    }
    return taken;
}

void ResultQueue::release_taken() {
    bytes_ -= bytes_taken_;
    bytes_taken_ = 0;
}

OrderedRun::OrderedRun(const ScenarioRunner& runner,
                       std::atomic<bool>& ended,
                       ThreadPool& pool,
                       std::uint64_t first)
    : runner_(runner),
      ended_(ended),
      thread_count_(pool.size()),
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
    std::move(scenarios.begin(), scenarios.end(), std::back_inserter(waiting_));
    work_came_.notify_all();
}

std::vector<DoneScenario> OrderedRun::take(std::chrono::milliseconds period, bool may_add) {
    std::unique_lock lock(mutex_);
    const bool was_full = done_.is_full();
    done_.release_taken();
    if (was_full) {
        work_came_.notify_all();
    }
    state_changed_.wait_for(lock, period, [this, may_add] {
        return done_.is_next_here() || (may_add && wanted_now() > 0);
    });
    std::vector<DoneScenario> taken = done_.take();
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
               (!waiting_.empty() && (!done_.is_full() || waiting_.front().index == done_.next()));
    });
    if (stopping_) {
        return false;
    }
    const std::size_t share = waiting_.size() / (2 * std::size_t{thread_count_}) + 1;
    const auto end = waiting_.begin() +
                     static_cast<std::ptrdiff_t>(std::min({batch.size, share, waiting_.size()}));
    batch.waiting.assign(std::move_iterator(waiting_.begin()), std::move_iterator(end));
    waiting_.erase(waiting_.begin(), end);
    return true;
}

void OrderedRun::run_some(ScenarioSession& session, Batch& batch) {
    const auto start = std::chrono::steady_clock::now();
    std::chrono::steady_clock::duration spent{};
    batch.ran = 0;
    while (batch.ran < batch.waiting.size() && spent < 4 * batch_time &&
           batch.bytes < limits::run_batch_bytes_max) {
        ScenarioRun run = session.run(batch.waiting[batch.ran++]);
        spent = std::chrono::steady_clock::now() - start;
        if (run.is_stopped) {
            continue; // Nobody waits for a result of a run that has ended.
        }
        batch.statistics += {run.statistics, run.inside};
        DoneScenario done =
            done_scenario(std::move(run.result),
                          runner_.query().maps ? std::move(run.found) : std::vector<ContactPair>());
        batch.bytes += bytes_of(done);
        batch.done.push_back(std::move(done));
    }
    const auto fits = batch_time * batch.ran / std::max(spent, 1ns);
    batch.size =
        std::clamp<std::size_t>(static_cast<std::size_t>(fits), 1, limits::run_batch_scenarios_max);
}

void OrderedRun::hand_over(Batch& batch) {
    const auto not_run = batch.waiting.begin() + static_cast<std::ptrdiff_t>(batch.ran);
    const std::lock_guard lock(mutex_);
    if (not_run != batch.waiting.end()) {
        // Threads take scenarios in order, so the ones not run are consecutive in `waiting_`.
        const auto position = std::ranges::lower_bound(
            waiting_, not_run->index, std::ranges::less(), &Scenario::index);
        waiting_.insert(position, not_run, batch.waiting.end());
        work_came_.notify_all();
    }
    done_.add(batch.done, batch.bytes);
    statistics_ += batch.statistics;
    batch.done.clear();
    batch.statistics = {};
    batch.bytes = 0;
    if (done_.is_next_here() || wanted_now() > 0) {
        state_changed_.notify_one();
    }
}

} // namespace cd
