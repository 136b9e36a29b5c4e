#include "bench/cluster/model/sketches.hpp"

#include <chrono>

namespace cd::bench {

void SketchLoop::time_is(double seconds) {
    now_ = Time(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds)));
    while (!timers_.empty() && timers_.begin()->first <= now_) {
        ready_.push_back(std::move(timers_.extract(timers_.begin()).mapped()));
    }
}

std::optional<double> SketchLoop::next_timer() const {
    if (timers_.empty()) {
        return std::nullopt;
    }
    // A nanosecond later, because a number of seconds is rounded.
    const Duration due = timers_.begin()->first.time_since_epoch() + std::chrono::nanoseconds(1);
    return std::chrono::duration<double>(due).count();
}

bool SketchLoop::run_ready() {
    const bool is_any = !ready_.empty();
    while (!ready_.empty()) {
        const Function function = std::move(ready_.front());
        ready_.pop_front();
        function();
    }
    return is_any;
}

std::deque<SketchLoop::Function> SketchLoop::record(const Function& function) {
    std::deque<Function> posted;
    recorded_ = &posted;
    function();
    recorded_ = nullptr;
    return posted;
}

} // namespace cd::bench
