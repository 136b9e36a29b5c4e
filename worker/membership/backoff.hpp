// The pauses between attempts to connect to the master.
#pragma once

#include <chrono>
#include <cstdint>
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

} // namespace cd
