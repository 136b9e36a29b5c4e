#include "client/local/result_queue.hpp"

#include "common/core/limits/client.hpp"

#include <functional>
#include <numeric>
#include <utility>

namespace cd {

std::uint64_t bytes_of(const DoneScenario& done) {
    const ScenarioResult& result = done.result;
    return sizeof done + done.record.size() + done.found.size() * sizeof(ContactPair) +
           result.pairs.size() * sizeof(ContactPair) +
           (result.points.size() + result.point_origins.size()) * sizeof(Vec3) +
           result.point_offsets.size() * sizeof(std::uint32_t);
}

bool ResultQueue::is_full() const {
    return bytes_ >= limits::run_bytes_ahead_max;
}

void ResultQueue::add(std::vector<DoneScenario> results) {
    if (results.empty()) {
        return;
    }
    const std::uint64_t bytes = std::transform_reduce(
        results.begin(), results.end(), std::uint64_t{0}, std::plus<>(), bytes_of);
    const std::uint64_t first = results.front().result.index;
    bytes_ += bytes;
    waiting_.emplace(first, Block{std::move(results), bytes});
}

std::vector<DoneScenario> ResultQueue::take() {
    if (!is_next_here()) {
        return {};
    }
    Block block = std::move(waiting_.begin()->second);
    waiting_.erase(waiting_.begin());
    bytes_taken_ += block.bytes;
    next_ += block.results.size();
    return std::move(block.results);
}

void ResultQueue::release_taken() {
    bytes_ -= bytes_taken_;
    bytes_taken_ = 0;
}

} // namespace cd
