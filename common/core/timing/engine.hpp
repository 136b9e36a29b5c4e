// Periods, timeouts and lifetimes of the contact engine.
#pragma once

#include <chrono>

namespace cd::timing {

// Queries.
/// A call that waits checks this often whether it has been stopped.
inline constexpr std::chrono::milliseconds stop_check_period{100};

} // namespace cd::timing
