#include "master/workers/worker_sessions.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"

#include <iterator>

namespace cd {

void WorkerSessions::joined(WorkerId worker, WorkerProcess process, const std::string& holder) {
    CD_CHECK(process != 0);
    sessions_[worker] = {process, holder};
}

WorkerId WorkerSessions::earlier(WorkerProcess process, WorkerId next) {
    const auto [known, is_new] = earlier_.try_emplace(process, next);
    if (is_new) {
        earlier_last_ = next;
        joined(next, process, "");
    }
    return known->second;
}

WorkerProcess WorkerSessions::process_of(WorkerId worker) const {
    const auto known = sessions_.find(worker);
    return known == sessions_.end() ? 0 : known->second.process;
}

std::string WorkerSessions::holder_of(WorkerId worker) const {
    const auto known = sessions_.find(worker);
    return known == sessions_.end() ? "" : known->second.holder;
}

std::set<WorkerId> WorkerSessions::all_of(WorkerProcess process) const {
    std::set<WorkerId> found;
    for (const auto& [worker, session] : sessions_) {
        if (session.process == process) {
            found.insert(worker);
        }
    }
    return found;
}

void WorkerSessions::forget(const std::function<bool(WorkerId)>& is_needed, bool with_latest) {
    auto place = sessions_.begin();
    std::size_t left = sessions_.size();
    const std::size_t latest = with_latest ? 0 : limits::worker_sessions_kept;
    for (; left > latest; --left) {
        place = is_needed(place->first) ? std::next(place) : sessions_.erase(place);
    }
    many_ = 2 * std::max(limits::worker_sessions_kept, sessions_.size());
}

} // namespace cd
