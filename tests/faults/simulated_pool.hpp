// The thread pool of a simulated process: posted functions run at simulated times.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "tests/faults/world.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>

namespace cd::tests {

/// Drops all functions that have not run when it is destroyed: its process has ended.
class SimulatedPool final : public Pool {
  public:
    /// World and host outlive the pool.
    SimulatedPool(World& world, Host& host, unsigned threads)
        : world_(world), host_(host), threads_(threads), free_(threads) {}

    void post(std::function<void()> function) override;
    [[nodiscard]] unsigned size() const override { return threads_; }

  private:
    void start_next();
    void run(std::uint64_t number);
    /// Calls `run` at a time, unless the pool has been destroyed by then.
    void run_at(Time time, std::uint64_t number);

    World& world_;
    Host& host_;
    unsigned threads_;
    unsigned free_;
    std::deque<std::function<void()>> waiting_;
    std::map<std::uint64_t, std::function<void()>> running_; ///< Key: a running number.
    std::shared_ptr<bool> is_here_ = std::make_shared<bool>(true);
};

} // namespace cd::tests
