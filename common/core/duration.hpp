// Parses durations such as "30m".
#pragma once

#include "common/core/result.hpp"

#include <chrono>
#include <string_view>

namespace cd {

/// Parses "45s", "30m", "24h" or "7d". Errors: BadInput if malformed or above 100 years.
[[nodiscard]] Result<std::chrono::seconds> parse_duration(std::string_view text);

} // namespace cd
