// Runs functions on a thread pool and delivers their results to the thread that owns the state.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/motion/motion_bound.hpp"
#include "proto/channel/asio.hpp"
#include "worker/execution/walk.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace cd {

/// A thread pool and `home`, the executor of the thread that owns the state. Must be destroyed
/// before the context of `home`; the destructor waits for submitted functions.
class Executor {
  public:
    using Continuation = std::function<void()>;

    /// Continuations run on `home`.
    Executor(asio::any_io_executor home, std::unique_ptr<Pool> pool)
        : home_(std::move(home)), pool_(std::move(pool)) {}
    /// 0 threads: one per core that this process may use.
    Executor(asio::any_io_executor home, unsigned threads)
        : Executor(std::move(home), std::make_unique<ThreadPool>(threads)) {}

    /// Runs `job` on a pool thread, then the continuation that it returns on `home`. Neither may
    /// throw. Continuations of functions that end close together are posted to `home` as one.
    void submit(std::function<Continuation()> job);

    [[nodiscard]] const asio::any_io_executor& home() const { return home_; }
    [[nodiscard]] unsigned threads() const { return pool_->size(); }

  private:
    void hand_over();

    asio::any_io_executor home_;
    std::mutex mutex_;
    std::vector<Continuation> ended_;
    std::unique_ptr<Pool> pool_; ///< Last: its threads use the members above.
};

/// A scenario with all the data that it needs to run, independent of later cache changes.
struct ReadyScenario {
    Scenario scenario;
    std::shared_ptr<const Query> query;
    BodyRadii radii;                           ///< In a job of motions.
    std::shared_ptr<const BodyPartRuns> parts; ///< Null: contacts are not summed by part.
    std::vector<RootPair> pairs;
    std::size_t named = 0;          ///< Number of pairs that may have the answer, at least `pairs`.
    std::vector<RootIndex> roots_a; ///< Distinct, ascending.
    std::vector<RootIndex> roots_b;
    std::vector<std::shared_ptr<const Subtree>> subtrees_a; ///< Parallel to `roots_a`.
    std::vector<std::shared_ptr<const Subtree>> subtrees_b;
};

/// Runs one scenario and returns its result. Empty if `stop` ended the run early.
[[nodiscard]] std::optional<FinishedScenarios> execute(const ReadyScenario& ready,
                                                       const StopCheck& stop);

} // namespace cd
