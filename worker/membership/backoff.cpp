#include "worker/membership/backoff.hpp"

#include "common/core/timing/worker.hpp"

#include <algorithm>

namespace cd {

std::chrono::milliseconds Backoff::next() {
    const std::uint64_t min = timing::reconnect_pause_first.count();
    const std::uint64_t max = timing::reconnect_pause_max.count();
    const std::uint64_t pause = std::min(max, min << std::min(attempts_, 16u));
    ++attempts_;
    return std::chrono::milliseconds(pause / 2 + random_() % (pause / 2 + 1));
}

void Backoff::reset() {
    attempts_ = 0;
}

} // namespace cd
