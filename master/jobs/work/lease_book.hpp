// The leases: the tasks that workers have, with the data that the master needs to check results.
#pragma once

#include "common/core/id.hpp"
#include "master/compute/result_check.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// A task at a worker.
struct Lease {
    WorkerId worker;
    std::shared_ptr<const TaskContent> content;
    std::size_t checks = 0;                ///< Number of the task's result messages in check.
    bool ended = false;                    ///< The worker has sent all results of the task.
    bool unbegun = false;                  ///< The task never reached the worker.
    bool is_called_off = false;            ///< Ranges only: the task may end without some answers.
    bool is_copy = false;                  ///< Speculative copy: another worker has this work too.
    std::optional<PlaceRange> places = {}; ///< Ranges only: the positions that were not recalled.
};

/// One entry per task, from its sending until it has ended and its results are checked.
class LeaseBook {
  public:
    void add(TaskId id, Lease task);
    /// Null if there is no such task.
    [[nodiscard]] Lease* find(TaskId task);
    /// Null if there is no such task, or another worker has it.
    [[nodiscard]] Lease* find(TaskId task, WorkerId worker);
    /// Removes the task and returns it; empty if there is no such task.
    std::optional<Lease> take(TaskId task);
    /// Removes the worker's batches. Its ranges stay until the dispatcher reports their end
    /// (`RangeEnded`).
    void forget_batches(WorkerId worker);

    [[nodiscard]] std::vector<TaskId> of(WorkerId worker) const;
    /// Tasks of the worker that are not among `present`.
    [[nodiscard]] std::vector<TaskId> missing(WorkerId worker,
                                              std::span<const Recalled> present) const;
    /// Positions in all range tasks of the job.
    [[nodiscard]] std::vector<PlaceRange> places_of(JobId job) const;
    [[nodiscard]] const std::map<TaskId, Lease>& all() const { return tasks_; }
    [[nodiscard]] std::map<TaskId, Lease>& all() { return tasks_; }

  private:
    std::map<TaskId, Lease> tasks_;
};

} // namespace cd
