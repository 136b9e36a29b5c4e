// Handles the events and messages of workers: about joining, silence and leaving, blocks and tasks.
#pragma once

#include "common/core/id.hpp"
#include "master/coordinator/master_services.hpp"
#include "master/coordinator/master_state.hpp"
#include "proto/messages/session_messages.hpp"
#include "proto/messages/work_messages.hpp"

#include <functional>
#include <optional>
#include <set>

namespace cd {

/// Checks each message, and passes it to the services and the dispatcher.
class WorkerDesk : public WorkerEvents {
  public:
    /// State and services outlive the desk. `heartbeat`: the period of the workers' heartbeats.
    WorkerDesk(MasterState& state, MasterServices& services, FailureTimes::Duration heartbeat)
        : state_(state), services_(services), heartbeat_(heartbeat) {}

    // ---- Messages of a worker -----------------------------------------------------------------
    /// Resynchronises a worker after a reconnection: sends or queues again what the worker's
    /// inventory shows to be lost with its last connection.
    void came(WorkerId worker, const Inventory& inventory);
    void came(WorkerId worker, const Evicted& evicted);
    void came(WorkerId worker, const Holding& holding);
    void came(WorkerId worker, const WantSubtrees& want);
    void came(WorkerId worker, const Held& held);
    void came(WorkerId worker, const FetchFailed& failed);
    /// Checks the results on the pool, merges them, and calls `done` when the journal has room.
    /// Acknowledges them once they are durable. Invalid results cut the worker off.
    void came(WorkerId worker, Results results, std::function<void()> done);
    void came(WorkerId worker, const EndOfTask& end);
    void came(WorkerId worker, const Recalled& recalled);
    /// Handles a worker that drains: it gets no new work, and leaves when its work is finished.
    void draining(WorkerId worker);

    // ---- Orders for a connected worker ----------------------------------------------------------
    /// Asks the worker to hand over its work and leave.
    void drain(WorkerId worker);
    /// Orders the worker to exit at once. Its work returns to the queue and is not counted as lost.
    void terminate(WorkerId worker);

    // ---- Events of the worker directory ---------------------------------------------------------
    void worker_joined(WorkerId worker, const Hello& hello) override;
    void worker_replaced(WorkerId worker) override;
    void worker_resumed(WorkerId worker) override;
    void worker_detached(WorkerId worker) override;
    void worker_silent(WorkerId worker) override;
    void worker_heard_again(WorkerId worker) override;
    void worker_left(WorkerId worker) override;
    [[nodiscard]] WorkerStatus work_of(WorkerId worker) const override;

    /// The port at which the worker serves others; empty if it serves none, or is not here.
    [[nodiscard]] std::optional<BlockDelivery::PeerPort> peer_port_of(WorkerId worker) const {
        return state_.blocks.peer_port_of(worker);
    }
    /// True while a timer runs that checks for silent workers and stragglers.
    [[nodiscard]] bool is_watching() const { return is_watching_; }
    /// Blocks that other workers may fetch from this worker. Empty if it is disconnected or has not
    /// sent its inventory. For tests; call it between two events.
    [[nodiscard]] BlockIndex::Blocks blocks_held_by(WorkerId worker) const;

  private:
    void watch();
    [[nodiscard]] Status check(const Inventory& inventory) const;
    void compare_blocks(WorkerId worker, const Inventory& inventory);

    MasterState& state_;
    MasterServices& services_;
    FailureTimes::Duration heartbeat_;
    bool is_watching_ = false;
};

} // namespace cd
