// Wall-clock time, for display and stored data. Scheduling decisions do not use it.
#pragma once

#include <chrono>
#include <cstdint>

namespace cd {

/// Returns the number of seconds since 1970-01-01, UTC.
[[nodiscard]] inline std::uint64_t unix_seconds() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::seconds>(since).count());
}

} // namespace cd
