// The daemon: connects, serves, and connects again, until it is told to end.
#pragma once

#include "worker/config.hpp"

#include <chrono>
#include <random>

namespace cd {

/// The pause before the next attempt to connect: doubles from one to the next up to a limit, and
/// varies so that workers do not come back all at once.
class Backoff {
  public:
    explicit Backoff(std::uint64_t seed) : random_(seed) {}

    /// A random time between half the present pause and all of it.
    [[nodiscard]] std::chrono::milliseconds next();
    void reset();

  private:
    std::mt19937_64 random_;
    unsigned attempts_ = 0;
};

/// Runs until the worker has drained or cannot work. Returns an exit code as listed in --help.
[[nodiscard]] int run_worker(const WorkerConfig& config);

/// `cdworker join`: gets a credential with the token of the configuration. Returns the exit code.
[[nodiscard]] int join_as_worker(const WorkerConfig& config);

} // namespace cd
