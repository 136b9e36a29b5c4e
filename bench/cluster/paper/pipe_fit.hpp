// Fits the rate of the slow pipe to a time that the paper gives.
#pragma once

#include <optional>
#include <span>

namespace cd::bench {

/// Time that a job takes with a pipe of some rate.
struct TimeAtRate {
    double bytes_per_second = 0;
    double seconds = 0;
};

/// Returns the rate at which the least-squares line of seconds over 1 / rate has so many seconds: a
/// job takes a part that does not depend on the pipe, and its bytes by the rate. Returns nothing if
/// the line does not fall with the rate, or is always above so many seconds.
[[nodiscard]] std::optional<double> rate_on_line(std::span<const TimeAtRate> times, double seconds);

} // namespace cd::bench
