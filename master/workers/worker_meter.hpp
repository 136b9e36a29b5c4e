// Measurements of one worker: received bytes, cache, busy time, and transfers of blocks.
#pragma once

#include "master/blocks/transfer_meter.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/session_messages.hpp"

#include <chrono>
#include <cstdint>
#include <optional>

namespace cd {

/// Has no clock: the caller passes the time.
class WorkerMeter {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `cache_bytes` is the limit of the worker's cache.
    explicit WorkerMeter(std::uint64_t cache_bytes = 0) : cache_bytes_(cache_bytes) {}

    void heartbeat_came(const Heartbeat& heartbeat) { heartbeat_ = heartbeat; }
    /// Takes the number of bytes received on the worker's connection. True if it has changed.
    [[nodiscard]] bool bytes_came(std::uint64_t received);
    /// Records whether the worker has any work from `now` on.
    void work_is(bool any, Time now);
    /// Measures the blocks that the worker fetches.
    [[nodiscard]] TransferMeter& transfers() { return transfers_; }

    /// The scenario that has run longest according to the last heartbeat; empty if none runs.
    [[nodiscard]] const std::optional<RunningScenario>& longest() const {
        return heartbeat_.longest;
    }
    /// Fills in the measured members of the status. Its `scenarios` must be set, for the rate.
    void add_to(WorkerStatus& status, Time now) const;

  private:
    std::uint64_t cache_bytes_;
    Heartbeat heartbeat_;                               ///< The last heartbeat received.
    std::uint64_t bytes_seen_ = 0;                      ///< Argument of the last `bytes_came`.
    std::chrono::steady_clock::duration busy_before_{}; ///< Time with work before `busy_since_`.
    std::optional<Time> busy_since_;                    ///< Empty while the worker has no work.
    TransferMeter transfers_;
};

} // namespace cd
