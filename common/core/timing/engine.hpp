// Periods, timeouts and lifetimes of the contact engine.
#pragma once

#include <chrono>

namespace cd::timing {

// Queries.
/// Period in which a waiting call polls its StopCheck.
inline constexpr std::chrono::milliseconds stop_check_period{100};

} // namespace cd::timing
