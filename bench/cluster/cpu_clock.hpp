// Processor time: excludes waiting for a busy machine.
#pragma once

#include <algorithm>
#include <ctime>

namespace cd::bench {

[[nodiscard]] inline double seconds_by(clockid_t clock) {
    timespec time{};
    static_cast<void>(::clock_gettime(clock, &time));
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time of the calling thread, s.
[[nodiscard]] inline double cpu_seconds() {
    return seconds_by(CLOCK_THREAD_CPUTIME_ID);
}

/// Processor time of all threads, s.
[[nodiscard]] inline double process_cpu_seconds() {
    return seconds_by(CLOCK_PROCESS_CPUTIME_ID);
}

/// Returns the cost of one call of `cpu_seconds`, s: the least mean of several rounds. The
/// difference of two calls includes it.
[[nodiscard]] inline double cpu_clock_cost() {
    constexpr int calls = 1000;
    double cost = 1;
    for (int round = 0; round < 10; ++round) {
        const double begin = cpu_seconds();
        for (int i = 1; i < calls; ++i) {
            static_cast<void>(cpu_seconds());
        }
        cost = std::min(cost, (cpu_seconds() - begin) / calls);
    }
    return cost;
}

} // namespace cd::bench
