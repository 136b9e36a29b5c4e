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

/// Fits a line to the times as a function of 1 / rate, by least squares, and returns the rate at
/// which it has the value `seconds`. The line suits because a job's time is a constant part plus
/// its bytes divided by the rate. Returns nothing if times do not fall with the rate, or if even an
/// infinite rate is too slow.
[[nodiscard]] std::optional<double> rate_on_line(std::span<const TimeAtRate> times, double seconds);

} // namespace cd::bench
