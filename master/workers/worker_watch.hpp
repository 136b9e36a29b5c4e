// Failure detector: judges by the time since a worker's last message whether the worker is alive. A
// state machine without sockets, clocks or threads.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/messages/client_messages.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace cd {

/// Timeouts of the failure detector.
struct FailureTimes {
    using Duration = std::chrono::milliseconds;

    Duration heartbeat = timing::heartbeat_period; ///< Period between two heartbeats, both ways.
    Duration lost_after = timing::peer_lost_after; ///< Silence until a connected worker is lost.
    /// Time after a broken connection until a worker that has not returned is lost.
    Duration return_within = timing::peer_lost_after;
    /// Silence until a lost worker is no longer shown.
    Duration forgotten_after = timing::worker_forgotten_after;

    /// Silence after which a worker counts as silent, and gets no new work.
    [[nodiscard]] Duration silent_after() const {
        return limits::heartbeats_missed_max * heartbeat;
    }
};

/// Without messages, a worker changes from alive to silent, then to lost, and is then forgotten. A
/// long pause between two checks may skip the state silent. A message makes a silent worker alive
/// again; a lost worker must join again.
class WorkerWatch {
  public:
    using Time = std::chrono::steady_clock::time_point;

    struct Change {
        WorkerId worker;
        std::optional<WorkerState> state; ///< Empty: forgotten.

        friend bool operator==(const Change&, const Change&) = default;
    };

    explicit WorkerWatch(const FailureTimes& times) : times_(times) {}

    /// The worker must be new.
    void joined(WorkerId worker, Time now);
    /// Records a message or a reconnection. Returns whether the worker was silent until now.
    /// Ignores lost and unknown workers.
    bool heard(WorkerId worker, Time now);
    /// The connection broke, so the worker becomes silent. Returns whether it was alive before.
    /// Ignores lost workers.
    bool detached(WorkerId worker, Time now);
    /// Suspends the detection of silence until `heard` is called: the master does not read from the
    /// worker.
    void unheard(WorkerId worker);
    /// Declares the worker lost, regardless of its last message.
    void lost(WorkerId worker);
    /// Removes a worker that has left, or need not be shown as lost any more.
    void left(WorkerId worker);

    /// Advances the time. Returns all changes of state that follow.
    [[nodiscard]] std::vector<Change> time_is(Time now);

    /// Empty if there is no such worker.
    [[nodiscard]] std::optional<WorkerState> state(WorkerId worker) const;
    /// Time since the worker's last message; zero if there is no such worker.
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
    /// If more than `limits::lost_workers_kept_max` workers are lost, forgets the ones that joined
    /// first.
    void forget_some(std::vector<Change>& changes);

    FailureTimes times_;
    std::map<WorkerId, Entry> workers_;
};

} // namespace cd
