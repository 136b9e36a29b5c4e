#include "master/dispatch/worker_proxy.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <utility>

namespace cd {

std::size_t WorkerProxy::tasks_max(const ClusterOptions& options) const {
    const std::size_t q = std::max(options.q, 1u);
    const std::size_t working = (std::size_t{facts_.threads} + q - 1) / q;
    return 1 + std::max<std::size_t>(working, 1);
}

bool WorkerProxy::would_run_dry(const ClusterOptions& options) const {
    return working_ < std::max<std::uint64_t>(options.q, 2 * std::uint64_t{facts_.threads});
}

const ScenarioBuffer& WorkerProxy::buffer(JobId job) const {
    static const ScenarioBuffer empty;
    if (buffered_ == 0) {
        return empty;
    }
    const auto found = buffers_.find(job);
    return found == buffers_.end() ? empty : found->second;
}

void WorkerProxy::add_to_buffer(JobId job, std::uint64_t scenario, const ScenarioWeight& weight) {
    ScenarioBuffer& buffer = buffers_[job];
    buffer.scenarios.push_back(scenario);
    buffer.bytes += weight.bytes;
    buffer.cost_ns += weight.cost_ns;
    buffered_ns_ += weight.cost_ns;
    ++buffered_;
}

void WorkerProxy::remove_from_buffer(JobId job,
                                     std::uint64_t scenario,
                                     const ScenarioWeight& weight) {
    const auto found = buffers_.find(job);
    CD_CHECK(found != buffers_.end());
    ScenarioBuffer& buffer = found->second;
    const auto place = std::find(buffer.scenarios.begin(), buffer.scenarios.end(), scenario);
    CD_CHECK(place != buffer.scenarios.end());
    buffer.scenarios.erase(place);
    buffer.bytes -= weight.bytes;
    buffer.cost_ns -= weight.cost_ns;
    buffered_ns_ -= weight.cost_ns;
    --buffered_;
    if (buffer.scenarios.empty()) {
        buffers_.erase(found);
    }
}

void WorkerProxy::remove_first(JobId job, std::size_t count, const ScenarioWeight& weight) {
    const auto found = buffers_.find(job);
    CD_CHECK(found != buffers_.end());
    ScenarioBuffer& buffer = found->second;
    CD_CHECK(count <= buffer.scenarios.size());
    const auto begin = buffer.scenarios.begin();
    buffer.scenarios.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
    buffer.bytes -= weight.bytes;
    buffer.cost_ns -= weight.cost_ns;
    buffered_ns_ -= weight.cost_ns;
    buffered_ -= count;
    if (buffer.scenarios.empty()) {
        buffers_.erase(found);
    }
}

void WorkerProxy::order_buffer(JobId job,
                               const std::function<bool(std::uint64_t, std::uint64_t)>& before) {
    const auto found = buffers_.find(job);
    // Scenarios leave from the front, so the buffer is mostly sorted.
    if (found != buffers_.end() && !std::ranges::is_sorted(found->second.scenarios, before)) {
        std::ranges::stable_sort(found->second.scenarios, before);
    }
}

ScenarioBuffer WorkerProxy::take_buffer(JobId job) {
    auto node = buffers_.extract(job);
    if (node.empty()) {
        return {};
    }
    buffered_ -= node.mapped().scenarios.size();
    buffered_ns_ -= node.mapped().cost_ns;
    return std::move(node.mapped());
}

std::size_t WorkerProxy::tasks_of(JobId job) const {
    return static_cast<std::size_t>(std::count_if(
        tasks_.begin(), tasks_.end(), [&](const auto& task) { return task.second.job == job; }));
}

void WorkerProxy::start_task(TaskId task, ProxyTask content) {
    progressed_ = working_ == 0 ? content.sent : progressed_;
    working_ += content.left();
    working_ns_ += content.cost_ns;
    claiming_tasks_ += content.claims ? 1 : 0;
    ++tasks_sent_;
    flushed_last_ = content.job;
    const bool is_new = tasks_.emplace(task, std::move(content)).second;
    CD_CHECK(is_new);
}

void WorkerProxy::answer(TaskId task, std::uint64_t scenario, std::uint64_t cost_ns, bool here) {
    const auto found = tasks_.find(task);
    CD_CHECK(found != tasks_.end());
    std::vector<std::uint64_t>& open = found->second.scenarios;
    const auto place = std::find(open.begin(), open.end(), scenario);
    CD_CHECK(place != open.end());
    open.erase(place);
    --working_;
    found->second.cost_ns -= cost_ns;
    working_ns_ -= cost_ns;
    scenarios_answered_ += here ? 1 : 0;
}

void WorkerProxy::forget_scenarios(TaskId task) {
    const auto found = tasks_.find(task);
    CD_CHECK(found != tasks_.end());
    working_ -= found->second.left();
    working_ns_ -= found->second.cost_ns;
    found->second.scenarios.clear();
    found->second.places_left = 0;
    found->second.cost_ns = 0;
}

void WorkerProxy::answer_places(TaskId id, std::uint64_t count) {
    const auto found = tasks_.find(id);
    CD_CHECK(found != tasks_.end());
    ProxyTask& task = found->second;
    CD_CHECK(count <= task.places_left);
    remove_places(task, count);
    scenarios_answered_ += count;
}

PlaceRange WorkerProxy::cut_places(TaskId id, std::uint64_t kept) {
    ProxyTask& task = tasks_.at(id);
    CD_CHECK(task.is_range());
    // At most what is left, whatever the worker reports.
    const std::uint64_t least = task.places->count - task.places_left;
    const std::uint64_t count = std::clamp(kept, least, task.places->count);
    const PlaceRange cut{task.places->first + count, task.places->count - count};
    task.places->count = count;
    task.places_copied -= std::min(task.places_copied, cut.count);
    remove_places(task, cut.count);
    return cut;
}

void WorkerProxy::remove_places(ProxyTask& task, std::uint64_t count) {
    if (count == 0) {
        return;
    }
    const auto share = static_cast<double>(count) / static_cast<double>(task.places_left);
    const auto cost_ns =
        count == task.places_left
            ? task.cost_ns
            : static_cast<std::uint64_t>(share * static_cast<double>(task.cost_ns));
    task.places_left -= count;
    task.cost_ns -= cost_ns;
    working_ -= count;
    working_ns_ -= cost_ns;
}

void WorkerProxy::note_busy(TaskId task, double seconds) {
    const auto found = tasks_.find(task);
    if (found != tasks_.end()) {
        found->second.busy_seconds += seconds;
    }
}

void WorkerProxy::add_transfer(double now, double seconds) {
    transfers_end_ = std::max(transfers_end_, now) + seconds;
}

void WorkerProxy::judge_batch(const ProxyTask& ended, double now) {
    const double began = std::max(ended.sent, std::exchange(task_ended_, now));
    const double seconds = now - began;
    if (tasks_.empty() || ended.fetches || !(ended.busy_seconds > 0) || !(seconds > 0)) {
        return;
    }
    const double overhead = 1 - ended.busy_seconds / (seconds * facts_.threads);
    if (overhead > limits::batch_overhead_max) {
        batch_seconds_ = std::min(1.5 * batch_seconds_, limits::batch_seconds_max);
    }
}

ProxyTask WorkerProxy::end_task(TaskId task) {
    auto node = tasks_.extract(task);
    CD_CHECK(!node.empty());
    working_ -= node.mapped().left();
    working_ns_ -= node.mapped().cost_ns;
    claiming_tasks_ -= node.mapped().claims ? 1 : 0;
    return std::move(node.mapped());
}

WorkerStatus WorkerProxy::status() const {
    WorkerStatus status;
    status.worker = id_;
    status.name = facts_.name;
    status.threads = facts_.threads;
    status.claimed = is_claimed();
    status.draining = draining_;
    status.buffered = buffered_;
    status.working = working_;
    status.tasks = tasks_sent_;
    status.scenarios = scenarios_answered_;
    return status;
}

} // namespace cd
