// Maps sessions to worker processes for as long as results of them matter: a worker that was wrong
// remains known after it rejoins under another id.
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
    /// `process` is not 0; `holder` is the holder of its certificate, empty without one.
    void joined(WorkerId worker, WorkerProcess process, const std::string& holder);
    /// Worker id for a process known to an earlier incarnation of the master: the one assigned
    /// before, or else `next`. Call it for all such processes before the first worker joins.
    [[nodiscard]] WorkerId earlier(WorkerProcess process, WorkerId next);

    /// 0: the master, or no longer known.
    [[nodiscard]] WorkerProcess process_of(WorkerId worker) const;
    /// Empty: no certificate, or no longer known.
    [[nodiscard]] std::string holder_of(WorkerId worker) const;
    [[nodiscard]] std::set<WorkerId> all_of(WorkerProcess process) const;
    [[nodiscard]] bool is_earlier(WorkerId worker) const { return worker <= earlier_last_; }
    [[nodiscard]] std::size_t size() const { return sessions_.size(); }

    /// True if there are so many sessions that `forget` should be called.
    [[nodiscard]] bool are_many() const { return sessions_.size() >= many_; }
    /// Forgets the sessions for which `is_needed` is false. Unless `with_latest`, keeps the latest
    /// `limits::worker_sessions_kept`, whose results may be under way.
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
