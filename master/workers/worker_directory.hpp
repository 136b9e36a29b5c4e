// The directory of workers: one record per worker, from its Hello until it is forgotten.
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
    std::string holder = {}; ///< Holder of the worker's certificate; empty without one.
};

/// Counts the result messages of one worker process that are being checked or wait for the journal.
/// All connections and sessions of the process share the count, so that a reconnection does not
/// raise the limit.
struct WorkerIntake {
    std::size_t messages = 0;
    std::function<void()> has_room = {}; ///< Called when `messages` decreases.
};

/// The session of a worker that has neither left nor been lost. Only the directory changes the
/// members before `results_last`.
struct Worker {
    std::shared_ptr<Channel> channel; ///< Closed while the worker is disconnected.
    PeerKey key;
    std::shared_ptr<const Author> author; ///< The session as author of results.
    std::uint64_t instance = 0;           ///< `Hello::instance`.
    std::uint32_t threads = 1;
    bool is_settled = true;         ///< False from a broken connection until the inventory comes.
    bool is_cut_off = false;        ///< The worker may not resume its session.
    bool is_dismissed = false;      ///< The worker has been ordered to exit at once.
    bool is_quarantined = false;    ///< The worker gets no work, and its results are ignored.
    std::uint64_t results_last = 0; ///< Highest sequence number of the worker's result messages.
    WorkerSupply supply;
    WorkerMeter meter;

    void send(const WorkerSupply::Messages& messages) const;
};

/// Receives the directory's reports, and answers its questions. The directory changes its records
/// before it reports.
class WorkerEvents {
  public:
    WorkerEvents() = default;
    WorkerEvents(const WorkerEvents&) = delete;
    WorkerEvents& operator=(const WorkerEvents&) = delete;
    virtual ~WorkerEvents() = default;

    /// A worker has joined, and has no work yet.
    virtual void worker_joined(WorkerId worker, const Hello& hello) = 0;
    /// The worker's process begins another session, so this session is lost next. The process
    /// lives, so the tasks of this session do not count as lost with it.
    virtual void worker_replaced(WorkerId worker) = 0;
    /// The worker has a new connection and will send its inventory.
    virtual void worker_resumed(WorkerId worker) = 0;
    virtual void worker_detached(WorkerId worker) = 0;
    virtual void worker_silent(WorkerId worker) = 0;
    /// A silent worker has given a sign of life again. Its inventory is known.
    virtual void worker_heard_again(WorkerId worker) = 0;
    /// The worker has left or is lost, and its record is gone.
    virtual void worker_left(WorkerId worker) = 0;

    /// A status with only the worker's scenarios and blocks; zeros for a worker that gets no work.
    [[nodiscard]] virtual WorkerStatus work_of(WorkerId worker) const = 0;
};

/// Owns the failure detector, but has no timer: call `check` about twice per heartbeat period while
/// `is_watching`.
class WorkerDirectory {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using Workers = std::map<WorkerId, Worker>;
    struct Counts {
        std::uint64_t lost = 0;
        std::uint64_t resumed = 0;    ///< Sessions that continued over a new connection.
        std::uint64_t given_back = 0; ///< Unanswered scenarios at workers that were lost.
    };

    /// `epoch` identifies this master process; `now` is the clock. `events` outlives the directory.
    WorkerDirectory(const FailureTimes& times,
                    std::uint64_t epoch,
                    WorkerEvents& events,
                    std::function<Time()> now);

    [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
    /// Decides how to answer a Hello; `holder` is the holder of the certificate, empty without one.
    /// Resumes the session that the worker names if this master process created it for the same
    /// worker process and holder, and the worker was not lost since.
    [[nodiscard]] Reception receive(const Hello& hello, const std::string& holder);
    /// Begins or resumes a session, after the Welcome has been sent. A new session ends the
    /// process's earlier ones. Closes the channel if the session to resume was lost since the
    /// Hello.
    void join(const Reception& reception, const Hello& hello, std::shared_ptr<Channel> channel);
    /// The intake counter that all sessions of the worker's process share.
    [[nodiscard]] std::shared_ptr<WorkerIntake> intake_of(WorkerId worker);

    /// Records that a message came. False if the worker has a newer connection, or is lost.
    [[nodiscard]] bool heard(WorkerId worker, const Channel& channel);
    /// Suspends the detection of silence: the master reads nothing from the worker for now.
    void unheard(WorkerId worker, const Channel& channel);
    void heartbeat_came(WorkerId worker, const Heartbeat& heartbeat);
    /// Marks the worker as settled: its inventory has come and passed the checks.
    void settle(WorkerId worker);
    /// Reports workers that have become silent or lost, and forgets the ones lost long ago.
    void check();

    /// Handles the end of a connection. The session survives, unless the worker had drained or was
    /// cut off, dismissed or quarantined. Ignored if the worker has a newer connection, or after
    /// `close`.
    void connection_ended(WorkerId worker, const Channel& channel, const std::string& why);
    /// Closes the connection of a worker that violates the protocol, and loses the worker.
    void cut_off(WorkerId worker, const Error& why);
    /// Orders the worker to exit at once. It leaves, and is not counted as lost.
    void dismiss(WorkerId worker);
    /// Marks the sessions of the process as quarantined, and returns them.
    std::vector<WorkerId> quarantine(InstanceId process);
    /// Call when the master shuts down: connections that end are ignored from now on.
    void close() { is_closed_ = true; }

    /// Null for a worker that has left or is lost.
    [[nodiscard]] Worker* find(WorkerId worker);
    [[nodiscard]] Workers& all() { return workers_; }
    [[nodiscard]] const Workers& all() const { return workers_; }
    /// True while there are workers, or lost ones to forget.
    [[nodiscard]] bool is_watching() const { return watch_.size() != 0; }
    /// All workers, followed by the recently lost workers.
    [[nodiscard]] std::vector<WorkerStatus> statuses() const;
    [[nodiscard]] const Counts& counts() const { return counts_; }
    /// Aborts if an invariant is broken. For tests; call it between two events.
    void check_invariants() const;

  private:
    struct Lost {
        WorkerStatus status; ///< Status at the time of the loss.
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
    std::uint64_t last_ = 0; ///< Id of the worker that joined last.
    WorkerWatch watch_;
    std::map<WorkerId, Lost> lost_; ///< Lost workers that status still shows.
    std::map<InstanceId, std::weak_ptr<WorkerIntake>> intakes_;
    Counts counts_;
    bool is_closed_ = false;
};

} // namespace cd
