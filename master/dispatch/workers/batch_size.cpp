#include "master/dispatch/workers/batch_size.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cd {

double BatchSize::seconds_least() const {
    return std::isfinite(round_trip_) ? std::min(round_trip_, timing::batch_seconds_start) : 0;
}

void BatchSize::judge(const TaskInFlight& ended, bool has_successor, double threads, double now) {
    const double began = std::max(ended.sent, std::exchange(task_ended_, now));
    const double seconds = now - began;
    if (ended.fetches || !(ended.busy_seconds > 0) || !(seconds > 0)) {
        return;
    }
    const double work = ended.busy_seconds / threads;
    const double idle = seconds - work;
    const double delay = now - ended.sent - work; // Includes the wait for the task before.
    if (idle > delay / 2 && ended.sent > blocks_noted_) {
        round_trip_ = std::min(round_trip_, delay);
    }
    if (has_successor && idle > limits::batch_overhead_max * seconds) {
        seconds_ = std::min(1.5 * seconds_, timing::batch_seconds_max);
    }
}

} // namespace cd
