// Runs work on the threads and brings its results back to the thread that owns the state.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/job/run_scenario.hpp"
#include "proto/channel/asio.hpp"
#include "worker/execution/walk.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace cd {

/// Destroyed before the executor's context; submitted work runs until then.
class Executor {
  public:
    using Continuation = std::function<void()>;

    /// 0 threads: one for each core that this process may use. Continuations run on `home`.
    Executor(asio::any_io_executor home, unsigned threads);

    /// Runs `job` on a thread, and the continuation that it returns at home. Neither may throw.
    /// Continuations of jobs that end at about the same time come home together.
    void submit(std::function<Continuation()> job);

    [[nodiscard]] const asio::any_io_executor& home() const { return home_; }
    [[nodiscard]] unsigned threads() const { return pool_.size(); }

  private:
    void hand_over();

    asio::any_io_executor home_;
    std::mutex mutex_;
    std::vector<Continuation> ended_;
    ThreadPool pool_; ///< Last: its threads use the members above.
};

/// A scenario with everything that its run needs, so that the cache may change meanwhile.
struct ReadyScenario {
    Scenario scenario;
    std::shared_ptr<const Query> query;
    std::vector<RootPair> pairs;
    std::vector<RootIndex> roots_a; ///< Distinct, ascending.
    std::vector<RootIndex> roots_b;
    std::vector<std::shared_ptr<const Subtree>> subtrees_a; ///< Of each of `roots_a`.
    std::vector<std::shared_ptr<const Subtree>> subtrees_b;
};

/// Empty if the run was told to stop.
[[nodiscard]] std::optional<FinishedScenarios> execute(const ReadyScenario& ready,
                                                       const StopCheck& stop);

} // namespace cd
