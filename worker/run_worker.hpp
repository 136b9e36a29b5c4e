// The worker daemon: connects to the master, serves it, and reconnects until it must end.
#pragma once

#include "worker/config.hpp"

#include <chrono>
#include <random>

namespace cd {

/// Pauses between connection attempts. The pauses double up to a limit, with random jitter so that
/// workers do not reconnect all at once.
class Backoff {
  public:
    explicit Backoff(std::uint64_t seed) : random_(seed) {}

    /// Returns the next pause: a random time between half the current limit and the whole limit.
    [[nodiscard]] std::chrono::milliseconds next();
    /// Resets the limit, so that the next pause is the shortest.
    void reset();

  private:
    std::mt19937_64 random_;
    unsigned attempts_ = 0;
};

/// Runs the daemon until the worker has drained or cannot work. Returns a code that --help lists.
[[nodiscard]] int run_worker(const WorkerConfig& config);

/// Runs `cdworker join`: gets a credential with the configured token. Returns the exit code.
[[nodiscard]] int join_as_worker(const WorkerConfig& config);

} // namespace cd
