// The results of one task that have not been sent.
#pragma once

#include "common/job/result/contact_map.hpp"
#include "proto/messages/work_messages.hpp"
#include "worker/execution/walk.hpp"
#include "worker/execution/worker_job.hpp"

#include <cstddef>
#include <optional>

namespace cd {

class TaskResults {
  public:
    void add(const FinishedScenarios& finished);
    /// Uncompressed bytes of the results not yet taken.
    [[nodiscard]] std::size_t bytes() const { return sum_.records.size() + map_.bytes(); }
    /// Mean thread time per scenario of the last `add`, in seconds; 0 before the first.
    [[nodiscard]] double seconds_per_scenario() const { return seconds_per_scenario_; }
    /// Removes the results, and makes a message of them. Empty if there are none.
    /// `is_within_host`: the master runs on this host.
    [[nodiscard]] std::optional<Results>
    take(TaskId task, const WorkerJob& job, bool is_within_host);

  private:
    FinishedScenarios sum_; ///< Sum of the results not yet taken, without the contact map.
    ContactMapSum map_;     ///< Contact map of `sum_`.
    double seconds_per_scenario_ = 0;
};

} // namespace cd
