// The scenarios that the master collects for one worker until they form a task.
#pragma once

#include "common/core/id.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace cd {

/// Scenarios of one job that form the worker's next task.
struct ScenarioBuffer {
    std::vector<std::uint64_t> scenarios;
    std::uint64_t bytes = 0;
    std::uint64_t cost_ns = 0; ///< Predicted time.

    /// True if the buffer has q scenarios or more than V kB of 1000 bytes (paper, 6.4.3).
    [[nodiscard]] bool is_full(const ClusterOptions& options) const {
        return scenarios.size() >= options.q || bytes > std::uint64_t{options.v_kb} * 1000;
    }
};

/// Size and cost of a scenario in a buffer or task.
struct ScenarioWeight {
    std::uint64_t bytes = 0;
    std::uint64_t cost_ns = 0;
};

/// A buffer for each job that has scenarios for the worker.
class WorkerBuffers {
  public:
    /// Scenarios in all buffers.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Predicted time of all buffers.
    [[nodiscard]] std::uint64_t cost_ns() const { return cost_ns_; }
    /// The job's buffer; empty if nothing is buffered.
    [[nodiscard]] const ScenarioBuffer& of(JobId job) const;
    [[nodiscard]] const std::map<JobId, ScenarioBuffer>& all() const { return buffers_; }

    void add(JobId job, std::uint64_t scenario, const ScenarioWeight& weight);
    /// The scenario must be in the buffer.
    void remove(JobId job, std::uint64_t scenario, const ScenarioWeight& weight);
    /// Removes the buffer's first `count` scenarios; `weight` is the sum of their weights.
    void remove_first(JobId job, std::size_t count, const ScenarioWeight& weight);
    /// Sorts the job's buffer stably. The buffer must not be empty.
    void sort(JobId job, const std::function<bool(std::uint64_t, std::uint64_t)>& before);
    /// Removes and returns the whole buffer, in order; empty if nothing is buffered.
    ScenarioBuffer take(JobId job);

  private:
    using Place = std::map<JobId, ScenarioBuffer>::iterator;
    [[nodiscard]] Place existing(JobId job);
    void lighten(Place buffer, std::size_t count, const ScenarioWeight& weight);

    std::map<JobId, ScenarioBuffer> buffers_; ///< Non-empty ones only.
    std::uint64_t count_ = 0;
    std::uint64_t cost_ns_ = 0;
};

} // namespace cd
