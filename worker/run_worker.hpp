// The worker daemon: connects to the master, serves it, and reconnects until it must end.
#pragma once

#include "worker/config.hpp"

#include <chrono>
#include <random>

namespace cd {

/// Pauses between connection attempts. They double up to a limit, with random jitter so that
/// workers do not reconnect all at once.
class Backoff {
  public:
    explicit Backoff(std::uint64_t seed) : random_(seed) {}

    /// Returns the next pause: a random time between half the current limit and the whole limit.
    [[nodiscard]] std::chrono::milliseconds next();
    /// Makes the next pause the shortest again.
    void reset();

  private:
    std::mt19937_64 random_;
    unsigned attempts_ = 0;
};

/// Runs until the worker has drained or cannot work. Returns an exit code listed in --help.
[[nodiscard]] int run_worker(const WorkerConfig& config);

/// `cdworker join`: gets a credential with the configured token. Returns the exit code.
[[nodiscard]] int join_as_worker(const WorkerConfig& config);

} // namespace cd
