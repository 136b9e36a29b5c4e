// Periods, timeouts and lifetimes of HTTP answers and of the page.
#pragma once

#include <chrono>

namespace cd::timing {

// Requests.
/// A request with a wrong key is answered after this time.
inline constexpr std::chrono::milliseconds wrong_key_delay{100};

// History.
inline constexpr std::chrono::seconds history_period{1}; ///< Between two samples.

// A master's page over a connection.
/// A status of the cluster answers requests for this long.
inline constexpr std::chrono::milliseconds remote_status_max_age{500};

// Runs of scenarios.
/// The master stops running a scenario for the page after this time.
inline constexpr std::chrono::seconds page_run_max{1};
/// `cdctl view` stops running a scenario after this time.
inline constexpr std::chrono::minutes view_run_max{10};

// `cdctl view`.
/// `cdctl view` ends this long after the last request.
inline constexpr std::chrono::minutes view_idle_max{30};
/// Period in which `cdctl view` checks whether it has to end.
inline constexpr std::chrono::milliseconds view_check_period{100};

} // namespace cd::timing
