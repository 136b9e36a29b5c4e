// Periods, timeouts and lifetimes of HTTP answers and of the page.
#pragma once

#include <chrono>

namespace cd::timing {

// Requests.
/// A request with a wrong key is answered after this time.
inline constexpr std::chrono::milliseconds wrong_key_delay{100};

// `cdctl view`.
/// `cdctl view` ends this long after the last request.
inline constexpr std::chrono::minutes view_idle_max{30};
/// Period in which `cdctl view` checks whether it has to end.
inline constexpr std::chrono::milliseconds view_check_period{100};

} // namespace cd::timing
