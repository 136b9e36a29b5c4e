#include "master/dispatch/workers/worker_buffers.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <utility>

namespace cd {

const ScenarioBuffer& WorkerBuffers::of(JobId job) const {
    static const ScenarioBuffer empty;
    if (count_ == 0) {
        return empty;
    }
    const auto found = buffers_.find(job);
    return found == buffers_.end() ? empty : found->second;
}

void WorkerBuffers::add(JobId job, std::uint64_t scenario, const ScenarioWeight& weight) {
    ScenarioBuffer& buffer = buffers_[job];
    buffer.scenarios.push_back(scenario);
    buffer.bytes += weight.bytes;
    buffer.cost_ns += weight.cost_ns;
    cost_ns_ += weight.cost_ns;
    ++count_;
}

WorkerBuffers::Place WorkerBuffers::existing(JobId job) {
    const auto found = buffers_.find(job);
    CD_CHECK(found != buffers_.end());
    return found;
}

void WorkerBuffers::lighten(Place buffer, std::size_t count, const ScenarioWeight& weight) {
    buffer->second.bytes -= weight.bytes;
    buffer->second.cost_ns -= weight.cost_ns;
    cost_ns_ -= weight.cost_ns;
    count_ -= count;
    if (buffer->second.scenarios.empty()) {
        buffers_.erase(buffer);
    }
}

void WorkerBuffers::remove(JobId job, std::uint64_t scenario, const ScenarioWeight& weight) {
    const Place found = existing(job);
    std::vector<std::uint64_t>& scenarios = found->second.scenarios;
    const auto place = std::find(scenarios.begin(), scenarios.end(), scenario);
    CD_CHECK(place != scenarios.end());
    scenarios.erase(place);
    lighten(found, 1, weight);
}

void WorkerBuffers::remove_first(JobId job, std::size_t count, const ScenarioWeight& weight) {
    const Place found = existing(job);
    std::vector<std::uint64_t>& scenarios = found->second.scenarios;
    CD_CHECK(count <= scenarios.size());
    scenarios.erase(scenarios.begin(), scenarios.begin() + static_cast<std::ptrdiff_t>(count));
    lighten(found, count, weight);
}

void WorkerBuffers::sort(JobId job,
                         const std::function<bool(std::uint64_t, std::uint64_t)>& before) {
    std::vector<std::uint64_t>& scenarios = existing(job)->second.scenarios;
    // Since the last call, scenarios left from the front, so the buffer is often still sorted.
    if (!std::ranges::is_sorted(scenarios, before)) {
        std::ranges::stable_sort(scenarios, before);
    }
}

ScenarioBuffer WorkerBuffers::take(JobId job) {
    auto node = buffers_.extract(job);
    if (node.empty()) {
        return {};
    }
    count_ -= node.mapped().scenarios.size();
    cost_ns_ -= node.mapped().cost_ns;
    return std::move(node.mapped());
}

} // namespace cd
