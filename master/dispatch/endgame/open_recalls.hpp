// The recalls that workers have not answered.
#pragma once

#include "common/core/id.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace cd {

/// A recall that the worker has not answered.
struct PendingRecall {
    TaskId task;
    WorkerId helper;  ///< Worker that is to get the returned work.
    double since = 0; ///< Time of the recall, s.
};

/// At most one recall for each asked worker, found by that worker and by the helper.
class OpenRecalls {
  public:
    /// Replaces the worker's open recall, if there is one.
    void add(WorkerId worker, const PendingRecall& recall) {
        remove(worker);
        by_helper_.emplace(recall.helper, worker);
        all_.emplace(worker, recall);
    }
    /// Removes the worker's open recall, if there is one.
    void remove(WorkerId worker) {
        if (const auto found = all_.find(worker); found != all_.end()) {
            by_helper_.erase({found->second.helper, worker});
            all_.erase(found);
        }
    }

    /// By the worker that was asked.
    [[nodiscard]] const std::map<WorkerId, PendingRecall>& all() const { return all_; }
    /// The worker's open recall; null if there is none.
    [[nodiscard]] const PendingRecall* find(WorkerId worker) const {
        const auto found = all_.find(worker);
        return found == all_.end() ? nullptr : &found->second;
    }
    /// True if the helper is to get work of a recall made after the time `after`, s.
    [[nodiscard]] bool is_awaited_by(WorkerId helper, double after) const {
        auto place = by_helper_.lower_bound({helper, WorkerId{}});
        while (place != by_helper_.end() && place->first == helper &&
               all_.at(place->second).since <= after) {
            ++place;
        }
        return place != by_helper_.end() && place->first == helper;
    }

  private:
    std::map<WorkerId, PendingRecall> all_;
    std::set<std::pair<WorkerId, WorkerId>> by_helper_; ///< Helper, asked worker.
};

} // namespace cd
