#include "client/local/result_queue.hpp"

#include "common/core/limits/client.hpp"

#include <utility>

namespace cd {

bool ResultQueue::is_full() const {
    return bytes_ >= limits::run_bytes_ahead_max;
}

void ResultQueue::add(DoneBlock results) {
    if (results.empty()) {
        return;
    }
    bytes_ += results.bytes();
    const std::uint64_t first = results.first();
    waiting_.emplace(first, std::move(results));
}

DoneBlock ResultQueue::take() {
    if (!is_next_here()) {
        return {};
    }
    DoneBlock block = std::move(waiting_.begin()->second);
    waiting_.erase(waiting_.begin());
    bytes_taken_ += block.bytes();
    next_ += block.size();
    return block;
}

void ResultQueue::release_taken() {
    bytes_ -= bytes_taken_;
    bytes_taken_ = 0;
}

} // namespace cd
