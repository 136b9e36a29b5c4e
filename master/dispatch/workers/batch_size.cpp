#include "master/dispatch/workers/batch_size.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void BatchSize::judge(const TaskInFlight& ended, bool has_successor, double threads, double now) {
    const double began = std::max(ended.sent, std::exchange(task_ended_, now));
    const double seconds = now - began;
    if (!has_successor || ended.fetches || !(ended.busy_seconds > 0) || !(seconds > 0)) {
        return;
    }
    const double overhead = 1 - ended.busy_seconds / (seconds * threads);
    if (overhead > limits::batch_overhead_max) {
        seconds_ = std::min(1.5 * seconds_, timing::batch_seconds_max);
    }
}

} // namespace cd
