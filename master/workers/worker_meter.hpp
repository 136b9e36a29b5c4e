// Measures one worker: its life signs, its cache, its busy time and the blocks that reach it.
#pragma once

#include "master/blocks/transfer_meter.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/session_messages.hpp"

#include <chrono>
#include <cstdint>
#include <optional>

namespace cd {

/// Takes times and returns values; no clock.
class WorkerMeter {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `cache_bytes` is the limit of the worker's cache.
    explicit WorkerMeter(std::uint64_t cache_bytes = 0) : cache_bytes_(cache_bytes) {}

    void heartbeat_came(const Heartbeat& heartbeat) { heartbeat_ = heartbeat; }
    /// Takes the bytes received on the worker's connection. True if they differ from the last call.
    [[nodiscard]] bool bytes_came(std::uint64_t received);
    /// Records whether the worker has work from now on.
    void work_is(bool any, Time now);
    /// Times of the blocks that the worker fetches, in the seconds of the caller's clock.
    [[nodiscard]] TransferMeter& transfers() { return transfers_; }

    /// The longest-running scenario in the last heartbeat.
    [[nodiscard]] const std::optional<RunningScenario>& longest() const {
        return heartbeat_.longest;
    }
    /// Fills in the measured members. Reads `scenarios` for the rate.
    void add_to(WorkerStatus& status, Time now) const;

  private:
    std::uint64_t cache_bytes_;
    Heartbeat heartbeat_;                               ///< The last one.
    std::uint64_t bytes_seen_ = 0;                      ///< As of the last `bytes_came`.
    std::chrono::steady_clock::duration busy_before_{}; ///< Time with work before `busy_since_`.
    std::optional<Time> busy_since_;                    ///< Empty while the worker has no work.
    TransferMeter transfers_;
};

} // namespace cd
