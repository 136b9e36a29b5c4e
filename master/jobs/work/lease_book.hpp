// The tasks that workers have, with what the master needs to check their results.
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

struct Lease {
    WorkerId worker;
    std::shared_ptr<const TaskContent> content;
    std::size_t checks = 0;                ///< Result messages being checked.
    bool ended = false;                    ///< The worker has sent all its results.
    bool unbegun = false;                  ///< The task never reached the worker.
    bool is_called_off = false;            ///< Ranges only: some answers are no longer owed.
    bool is_copy = false;                  ///< Speculative copy: another worker has this work too.
    std::optional<PlaceRange> places = {}; ///< Ranges only: the positions not returned.
};

/// One entry per task, from its sending until nothing of it is expected any more.
class LeaseBook {
  public:
    void add(TaskId id, Lease task);
    /// Null: there is no such task.
    [[nodiscard]] Lease* find(TaskId task);
    /// Null also if the task is another worker's.
    [[nodiscard]] Lease* find(TaskId task, WorkerId worker);
    /// Removes the task. Empty: there is none.
    std::optional<Lease> take(TaskId task);
    /// Removes the worker's batches. Its ranges stay: the dispatcher still has to return them.
    void forget_batches(WorkerId worker);

    [[nodiscard]] std::vector<TaskId> of(WorkerId worker) const;
    /// Tasks of the worker that are not among `present`.
    [[nodiscard]] std::vector<TaskId> missing(WorkerId worker,
                                              std::span<const Recalled> present) const;
    /// Ranges of the job: all tasks with positions.
    [[nodiscard]] std::vector<PlaceRange> places_of(JobId job) const;
    [[nodiscard]] const std::map<TaskId, Lease>& all() const { return tasks_; }
    [[nodiscard]] std::map<TaskId, Lease>& all() { return tasks_; }

  private:
    std::map<TaskId, Lease> tasks_;
};

} // namespace cd
