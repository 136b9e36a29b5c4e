#include "master/jobs/thread_meter.hpp"

#include <ctime>

namespace cd {

namespace {

/// The least time of which a rate is learned, s: a shorter one says little.
constexpr double learned_seconds_min = 0.005;

} // namespace

double thread_cpu_seconds() {
    timespec time{};
    static_cast<void>(::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time));
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void ThreadMeter::count(std::uint64_t items) {
    items_ += items;
    const double now = cpu_seconds_();
    if (now - since_ >= learned_seconds_min) {
        each_.add(now - since_, static_cast<double>(items_));
        items_ = 0;
        since_ = now;
    }
}

} // namespace cd
