#include "bench/cluster/paper/pipe_fit.hpp"

namespace cd::bench {

std::optional<double> rate_on_line(std::span<const TimeAtRate> times, double seconds) {
    const auto count = static_cast<double>(times.size());
    double mean_inverse = 0;
    double mean_seconds = 0;
    for (const TimeAtRate& time : times) {
        mean_inverse += 1 / time.bytes_per_second / count;
        mean_seconds += time.seconds / count;
    }
    double square = 0;
    double product = 0;
    for (const TimeAtRate& time : times) {
        const double inverse = 1 / time.bytes_per_second - mean_inverse;
        square += inverse * inverse;
        product += inverse * (time.seconds - mean_seconds);
    }
    if (!(product > 0)) { // Also without times.
        return std::nullopt;
    }
    const double bytes = product / square;
    const double inverse = mean_inverse + (seconds - mean_seconds) / bytes;
    return inverse > 0 ? std::optional(1 / inverse) : std::nullopt;
}

} // namespace cd::bench
