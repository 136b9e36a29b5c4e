#include "client/report/waiting_note.hpp"

#include "common/core/printable.hpp"
#include "common/core/words.hpp"

#include <algorithm>

namespace cd {

namespace {

std::uint64_t count_in(const ClusterStatus& cluster, WorkerState state) {
    return static_cast<std::uint64_t>(
        std::ranges::count(cluster.workers, state, &WorkerStatus::state));
}

const WorkerStatus& first_in(const ClusterStatus& cluster, WorkerState state) {
    return *std::ranges::find(cluster.workers, state, &WorkerStatus::state);
}

/// Names the workers in a state, at least one: "node-1", or "node-1 and 2 more".
std::string names_in(const ClusterStatus& cluster, WorkerState state) {
    const std::uint64_t count = count_in(cluster, state);
    return escaped(first_in(cluster, state).name) +
           (count == 1 ? "" : " and " + grouped(count - 1) + " more");
}

} // namespace

WaitingNote
waiting_note(const JobStatus& job, const ClusterStatus& cluster, const std::string& master) {
    const std::uint64_t silent = count_in(cluster, WorkerState::Silent);
    const std::uint64_t lost = count_in(cluster, WorkerState::Lost);
    if (job.state != JobState::Running) {
        return {};
    }
    if (!job.paused.empty()) {
        return {"paused: " + escaped(job.paused), true};
    }
    if (cluster.workers.size() == lost) {
        return {"no worker is connected: start cdworker --master " + master, true};
    }
    if (silent != 0) {
        const double seconds = first_in(cluster, WorkerState::Silent).silent_seconds;
        return {"silent: " + names_in(cluster, WorkerState::Silent) + ", for " +
                fixed_text(seconds, 0) + " s; others get the work if that lasts"};
    }
    if (lost != 0) {
        return {"lost: " + names_in(cluster, WorkerState::Lost) + "; others do the work"};
    }
    return {};
}

} // namespace cd
