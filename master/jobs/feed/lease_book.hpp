// Keeps for each task in flight what the dispatcher does not need: its content and its checks.
#pragma once

#include "common/core/id.hpp"
#include "master/compute/task_content.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace cd {

struct Lease {
    std::shared_ptr<const TaskContent> content;
    std::size_t checks = 0; ///< Number of result messages that are being checked.
    bool ended = false;     ///< The worker has sent all results of the task.
    bool unbegun = false;   ///< The task never reached the worker.
};

/// One entry per task, from its sending until it has ended and its results are checked.
class LeaseBook {
  public:
    void add(WorkerId worker, TaskId task, Lease lease);
    /// Null if the worker has no such task.
    [[nodiscard]] Lease* find(WorkerId worker, TaskId task);
    [[nodiscard]] bool has(WorkerId worker, TaskId task) const {
        return leases_.contains({worker, task});
    }
    void remove(WorkerId worker, TaskId task) { leases_.erase({worker, task}); }
    /// Removes all leases of the worker.
    void forget(WorkerId worker);

    /// Tasks of the worker that are not among `present`.
    [[nodiscard]] std::vector<TaskId> missing(WorkerId worker,
                                              std::span<const Recalled> present) const;
    /// Number of leases.
    [[nodiscard]] std::size_t size() const { return leases_.size(); }

  private:
    std::map<std::pair<WorkerId, TaskId>, Lease> leases_;
};

} // namespace cd
