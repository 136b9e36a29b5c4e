// Log lines about peers that have proven nothing, and may come as often as they like.
#pragma once

#include "common/core/host/log.hpp"
#include "common/core/limits/wire.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace cd {

/// So many lines about a host in `limits::refusal_log_period`; how many were left out then stands
/// in the next one. All hosts beyond those that are remembered count as one. One thread.
class Refusals {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// How many were left out since the last line; nothing: leave out this one, too.
    [[nodiscard]] std::optional<std::uint64_t> admit(const std::string& host, Time now);

    /// Logs "WHAT: peer=PEER reason=REASON", or leaves it out. A peer is HOST:PORT.
    void log(LogLevel level, const char* what, const std::string& peer, const std::string& reason);

  private:
    struct Host {
        Time since; ///< Of the period.
        std::size_t lines = 0;
        std::uint64_t left_out = 0;
    };
    std::map<std::string, Host> hosts_;
};

} // namespace cd
