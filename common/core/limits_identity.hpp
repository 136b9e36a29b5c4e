// The bounds of what strangers and those of each role may have of a program.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

/// What is begun after a deadline ends this long after it, at the most.
inline constexpr std::chrono::milliseconds overdue_check_period{50};

} // namespace cd::limits
