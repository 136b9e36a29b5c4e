// Work on the threads, and its way back to the thread that owns the state.
#pragma once

#include "common/core/thread_pool.hpp"
#include "common/job/run_scenario.hpp"
#include "proto/asio.hpp"
#include "worker/walk.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace cd {

/// Destroyed before the executor's context; until then what was submitted runs.
class Executor {
  public:
    using Continuation = std::function<void()>;

    /// 0 threads: one for each core that this process may use. Continuations run on `home`.
    Executor(asio::any_io_executor home, unsigned threads);

    /// Runs `job` on a thread, and what it returns at home. Neither may throw. What ends at about
    /// the same time comes home together.
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

/// A scenario with all that it takes to run it, whatever becomes of the cache meanwhile.
struct ReadyScenario {
    Scenario scenario;
    std::shared_ptr<const Query> query;
    std::vector<RootPair> pairs;
    std::vector<RootIndex> roots_a; ///< The distinct ones, ascending,
    std::vector<RootIndex> roots_b;
    std::vector<std::shared_ptr<const Subtree>> subtrees_a; ///< and the subtree of each.
    std::vector<std::shared_ptr<const Subtree>> subtrees_b;
};

/// Nothing when it was told to stop: there is no answer.
[[nodiscard]] std::optional<FinishedScenarios> execute(const ReadyScenario& ready,
                                                       const StopCheck& stop);

} // namespace cd
