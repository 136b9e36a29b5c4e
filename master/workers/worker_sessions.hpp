// Who each session of a worker was, for as long as a result may be of it: a worker that comes back
// as another is still the one that was wrong.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/worker_process.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>

namespace cd {

class WorkerSessions {
  public:
    /// `process` is not 0; `holder` is that of its certificate, empty without one.
    void joined(WorkerId worker, WorkerProcess process, const std::string& holder);
    /// A number for a process of which an earlier life of the master knew: its own, or else `next`.
    /// All of them come before the first that joins.
    [[nodiscard]] WorkerId earlier(WorkerProcess process, WorkerId next);

    /// 0: the master, or not known any more.
    [[nodiscard]] WorkerProcess process_of(WorkerId worker) const;
    /// Empty: none, or not known any more.
    [[nodiscard]] std::string holder_of(WorkerId worker) const;
    [[nodiscard]] std::set<WorkerId> all_of(WorkerProcess process) const;
    [[nodiscard]] bool is_earlier(WorkerId worker) const { return worker <= earlier_last_; }
    [[nodiscard]] std::size_t size() const { return sessions_.size(); }

    /// So many that it is time to forget those of whom nothing is left.
    [[nodiscard]] bool are_many() const { return sessions_.size() >= many_; }
    /// Forgets each that `is_needed` is false of; but, unless `with_latest`, none of the latest
    /// `limits::worker_sessions_kept`, whose results may be on their way.
    void forget(const std::function<bool(WorkerId)>& is_needed, bool with_latest);

  private:
    struct Session {
        WorkerProcess process = 0;
        std::string holder;
    };

    std::map<WorkerId, Session> sessions_;
    std::map<WorkerProcess, WorkerId> earlier_;
    WorkerId earlier_last_;
    std::size_t many_ = 2 * limits::worker_sessions_kept;
};

} // namespace cd
