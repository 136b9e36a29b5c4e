// Processor time: excludes waiting for a busy machine.
#pragma once

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

} // namespace cd::bench
