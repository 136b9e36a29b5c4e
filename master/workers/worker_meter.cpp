#include "master/workers/worker_meter.hpp"

#include <utility>

namespace cd {

bool WorkerMeter::bytes_came(std::uint64_t received) {
    return std::exchange(bytes_seen_, received) != received;
}

void WorkerMeter::work_is(bool any, Time now) {
    if (any && !busy_since_) {
        busy_since_ = now;
    } else if (!any && busy_since_) {
        busy_before_ += now - *busy_since_;
        busy_since_.reset();
    }
}

void WorkerMeter::add_to(WorkerStatus& status, Time now) const {
    status.longest = heartbeat_.longest;
    status.cache_bytes = cache_bytes_;
    status.cached_bytes = heartbeat_.cached_bytes;
    status.cache = heartbeat_.traffic;
    const auto busy = busy_before_ + (busy_since_ ? now - *busy_since_ : Time::duration{});
    const double seconds = std::chrono::duration<double>(busy).count();
    status.scenarios_per_second = seconds > 0 ? static_cast<double>(status.scenarios) / seconds : 0;
}

} // namespace cd
