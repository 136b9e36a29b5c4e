// One record per worker, from its Hello until it is forgotten.
#pragma once

#include "common/core/id.hpp"
#include "common/core/result.hpp"
#include "master/base/instance_id.hpp"
#include "master/workers/worker_meter.hpp"
#include "master/workers/worker_supply.hpp"
#include "master/workers/worker_watch.hpp"
#include "proto/channel/channel.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/session_messages.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// The answer to a worker's Hello.
struct Reception {
    WorkerId worker;
    PeerKey key;
    bool is_resumed = false; ///< True if the worker resumes an earlier session.
    std::string holder = {}; ///< Holder of its certificate; empty without one.
};

/// Counts the result messages of one worker process that are being checked or wait for the journal.
/// All its connections and sessions share the count: reconnecting gives no second allowance.
struct WorkerIntake {
    std::size_t messages = 0;
    std::function<void()> has_room = {}; ///< Called when a message leaves.
};

/// The session of a worker that has neither left nor been lost. Only the directory changes the
/// members above `results_last`.
struct Worker {
    std::shared_ptr<Channel> channel; ///< Closed while the worker is disconnected.
    PeerKey key;
    std::shared_ptr<const Author> author; ///< The session as author of results.
    std::uint64_t instance = 0;           ///< `Hello::instance`.
    std::uint32_t threads = 1;
    bool is_settled = true;         ///< The master knows the worker's inventory.
    bool is_cut_off = false;        ///< The worker may not resume its session.
    bool is_dismissed = false;      ///< The worker has been ordered to exit at once.
    bool is_quarantined = false;    ///< The worker gets no work, and its results are ignored.
    std::uint64_t results_last = 0; ///< Highest sequence number of its result messages.
    WorkerSupply supply;
    WorkerMeter meter;

    void send(const WorkerSupply::Messages& messages) const;
};

/// Reports and questions of the directory. Each report comes after the record has changed.
class WorkerEvents {
  public:
    WorkerEvents() = default;
    WorkerEvents(const WorkerEvents&) = delete;
    WorkerEvents& operator=(const WorkerEvents&) = delete;
    virtual ~WorkerEvents() = default;

    /// The worker has no work yet.
    virtual void worker_joined(WorkerId worker, const Hello& hello) = 0;
    /// The process of this session begins another one. The session is lost next; its tasks did not
    /// kill the process.
    virtual void worker_replaced(WorkerId worker) = 0;
    /// The worker has a new connection, and its inventory is unknown.
    virtual void worker_resumed(WorkerId worker) = 0;
    virtual void worker_detached(WorkerId worker) = 0;
    virtual void worker_silent(WorkerId worker) = 0;
    /// A silent worker whose inventory is known is heard again.
    virtual void worker_heard_again(WorkerId worker) = 0;
    /// The worker has left or is lost, and its record is gone.
    virtual void worker_left(WorkerId worker) = 0;

    /// The worker's scenarios and blocks; zeros for a worker that gets none.
    [[nodiscard]] virtual WorkerStatus work_of(WorkerId worker) const = 0;
};

/// Owns the failure detector. Holds no timer: call `check` from time to time, twice a heartbeat or
/// so, while `is_watching`.
class WorkerDirectory {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using Workers = std::map<WorkerId, Worker>;
    struct Counts {
        std::uint64_t lost = 0;
        std::uint64_t resumed = 0;    ///< Sessions that went on over another connection.
        std::uint64_t given_back = 0; ///< Scenarios at workers when they were lost.
    };

    /// `epoch` identifies this master process; `now` is the clock. `events` outlives the directory.
    WorkerDirectory(const FailureTimes& times,
                    std::uint64_t epoch,
                    WorkerEvents& events,
                    std::function<Time()> now);

    [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
    /// Decides how to answer a Hello; `holder` is the holder of the certificate, empty without one.
    /// Resumes the session if this master process created it for the same process and holder and
    /// has not declared the worker lost.
    [[nodiscard]] Reception receive(const Hello& hello, const std::string& holder);
    /// Call after the Welcome has been sent. Ends earlier sessions of the process. Closes the
    /// channel of a worker that was lost since its Hello.
    void join(const Reception& reception, const Hello& hello, std::shared_ptr<Channel> channel);
    /// Intake counters shared by all sessions of the worker's process.
    [[nodiscard]] std::shared_ptr<WorkerIntake> intake_of(WorkerId worker);

    /// Records a message of any type. False: the worker has another connection by now, or is lost.
    [[nodiscard]] bool heard(WorkerId worker, const Channel& channel);
    /// Suspends silence detection: the master reads no messages from the worker for now.
    void unheard(WorkerId worker, const Channel& channel);
    void heartbeat_came(WorkerId worker, const Heartbeat& heartbeat);
    /// The master has compared its record with the worker's inventory.
    void settle(WorkerId worker);
    /// Finds workers that have become silent, lost or forgotten.
    void check();

    /// Detaches the worker; its session survives unless the worker was to go. Ignored if the worker
    /// has a newer connection, or after `close`.
    void connection_ended(WorkerId worker, const Channel& channel, const std::string& why);
    /// Closes the connection of a worker that violates the protocol, and loses the worker.
    void cut_off(WorkerId worker, const Error& why);
    /// Orders the worker to exit at once. It leaves, and is not counted as lost.
    void dismiss(WorkerId worker);
    /// Marks the sessions of the process, and returns them.
    std::vector<WorkerId> quarantine(InstanceId process);
    /// The master is shutting down.
    void close() { is_closed_ = true; }

    /// Null for a worker that has left or is lost.
    [[nodiscard]] Worker* find(WorkerId worker);
    [[nodiscard]] Workers& all() { return workers_; }
    [[nodiscard]] const Workers& all() const { return workers_; }
    /// True while there are workers, or lost ones to forget.
    [[nodiscard]] bool is_watching() const { return watch_.size() != 0; }
    /// All workers, and after them those lost not long ago.
    [[nodiscard]] std::vector<WorkerStatus> statuses() const;
    [[nodiscard]] const Counts& counts() const { return counts_; }
    /// Aborts if an invariant is broken. For tests; call it between two events.
    void check_invariants() const;

  private:
    struct Lost {
        WorkerStatus status; ///< As of the loss.
        InstanceId process = 0;
    };

    void resume(WorkerId worker, std::shared_ptr<Channel> channel);
    void end_earlier_sessions(InstanceId process);
    [[nodiscard]] bool is_its_channel(WorkerId worker, const Channel& channel) const;
    void note_life(WorkerId worker);
    void hear_bytes();
    void lose(WorkerId worker, const std::string& why);
    void leave(WorkerId worker, const std::string& why);
    [[nodiscard]] WorkerStatus status(WorkerId id, const Worker& worker) const;

    std::uint64_t epoch_;
    WorkerEvents& events_;
    std::function<Time()> now_;
    Workers workers_;
    std::uint64_t last_ = 0; ///< The last id given out.
    WorkerWatch watch_;
    std::map<WorkerId, Lost> lost_; ///< Shown for a while.
    std::map<InstanceId, std::weak_ptr<WorkerIntake>> intakes_;
    Counts counts_;
    bool is_closed_ = false;
};

} // namespace cd
