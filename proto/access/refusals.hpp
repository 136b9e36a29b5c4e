// Rate-limited log lines about unauthenticated peers.
#pragma once

#include "common/core/host/log.hpp"
#include "common/core/timing/wire.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace cd {

/// Limits the log lines about a host in each `timing::refusal_log_period`. The next line counts the
/// suppressed ones. Hosts beyond `limits::refusal_hosts_max` share a limit. Not thread-safe.
class Refusals {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Decides whether to log a line about a host. Returns the number of lines suppressed since the
    /// last one that was logged, or nothing if this one is suppressed, too.
    [[nodiscard]] std::optional<std::uint64_t> admit(const std::string& host, Time now);

    /// Logs "WHAT: peer=PEER reason=REASON" unless it is suppressed. PEER is HOST:PORT.
    void log(LogLevel level, const char* what, const std::string& peer, const std::string& reason);

  private:
    struct Host {
        Time since; ///< Start of the period.
        std::size_t lines = 0;
        std::uint64_t left_out = 0; ///< Lines suppressed since the last logged line.
    };
    std::map<std::string, Host> hosts_;
};

} // namespace cd
