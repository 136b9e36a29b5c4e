// Which workers are alive, as far as can be told by when they were heard of: a state machine
// without sockets, clocks or threads.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "proto/messages/client_messages.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace cd {

/// How long a silence means what.
struct FailureTimes {
    using Duration = std::chrono::milliseconds;

    Duration heartbeat = limits::heartbeat_period; ///< Between two heartbeats, both ways.
    Duration lost_after = limits::peer_lost_after;
    /// For a worker whose connection broke: so long its tasks wait for it to come back.
    Duration return_within = limits::peer_lost_after;
    Duration forgotten_after = limits::worker_forgotten_after;

    /// So many heartbeats were missed that a side is suspected to be gone.
    [[nodiscard]] Duration silent_after() const {
        return limits::heartbeats_missed_max * heartbeat;
    }
};

/// A worker is alive, then silent, lost, forgotten, as time passes without a word of it. Silent and
/// lost may be reached in one step, when time makes a leap. A silent worker that is heard again is
/// alive; a lost one is not: it joins anew.
class WorkerWatch {
  public:
    using Time = std::chrono::steady_clock::time_point;

    struct Change {
        WorkerId worker;
        std::optional<WorkerState> state; ///< Nothing: forgotten.

        friend bool operator==(const Change&, const Change&) = default;
    };

    explicit WorkerWatch(const FailureTimes& times) : times_(times) {}

    /// The worker is new.
    void joined(WorkerId worker, Time now);
    /// Also when it has connected again. True: it was silent until now. Of a worker that is lost or
    /// not here: nothing.
    bool heard(WorkerId worker, Time now);
    /// The connection broke: it is silent. True: it was not before. Of one that is lost: nothing.
    bool detached(WorkerId worker, Time now);
    /// This side does not listen to it now: its silence says nothing until it is heard.
    void unheard(WorkerId worker);
    /// It is known to be gone, whatever was heard of it.
    void lost(WorkerId worker);
    /// It has ended, and said so; or is of no interest any more.
    void left(WorkerId worker);

    /// What has become of whom, by ascending worker.
    [[nodiscard]] std::vector<Change> time_is(Time now);

    /// Nothing for a worker that is not here.
    [[nodiscard]] std::optional<WorkerState> state(WorkerId worker) const;
    /// Since it was heard of. The worker is here.
    [[nodiscard]] std::chrono::duration<double> silence(WorkerId worker, Time now) const;
    [[nodiscard]] std::size_t size() const { return workers_.size(); }

  private:
    struct Entry {
        Time heard;
        std::optional<Time> detached;
        bool is_unheard = false;
        WorkerState state = WorkerState::Alive;
    };

    [[nodiscard]] bool is_due_to_be_lost(const Entry& entry, Time now) const;
    /// Beyond `limits::lost_workers_kept_max` lost ones those go that joined first.
    void forget_some(std::vector<Change>& changes);

    FailureTimes times_;
    std::map<WorkerId, Entry> workers_;
};

} // namespace cd
