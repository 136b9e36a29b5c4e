// The processor time of the calling thread: what waiting for a busy machine does not enter.
#pragma once

#include <ctime>

namespace cd::bench {

[[nodiscard]] inline double cpu_seconds() {
    timespec time{};
    static_cast<void>(::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time));
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace cd::bench
