// Parses durations such as "30m".
#pragma once

#include "common/core/result.hpp"

#include <chrono>
#include <string>
#include <string_view>

namespace cd {

/// Parses a whole number and a unit: "45s", "30m", "24h" or "7d". Errors: BadInput if the text is
/// malformed or the duration above 100 years.
[[nodiscard]] Result<std::chrono::seconds> parse_duration(std::string_view text);

} // namespace cd
