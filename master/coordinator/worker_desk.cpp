#include "master/coordinator/worker_desk.hpp"

#include "common/core/host/log.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// The roots 0 to `count` - 1 that are not in `held`, which must ascend.
std::vector<RootIndex> others(std::uint32_t count, const std::vector<RootIndex>& held) {
    std::vector<RootIndex> all;
    auto next = held.begin();
    for (RootIndex root = 0; root < count; ++root) {
        if (next != held.end() && *next == root) {
            ++next;
        } else {
            all.push_back(root);
        }
    }
    return all;
}

double seconds_of(EventLoop::Time time) {
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

} // namespace

// ---- Joining and returning ---------------------------------------------------------------------

void WorkerDesk::worker_joined(WorkerId id, const Hello& hello) {
    if (!is_watching_) {
        watch();
    }
    const Worker& worker = *state_.workers.find(id);
    const InstanceId process = worker.author->process;
    if (state_.alarms.is_quarantined(process)) {
        (void)state_.workers.quarantine(process);
        log_error("worker stays in quarantine: worker={} name={}", id.value, hello.name);
        return;
    }
    state_.blocks.worker_joined(id, worker.channel, worker.key, hello.peer_port);
    state_.dispatch.act(state_.dispatch->worker_joined(
        id, {hello.name, worker.threads, hello.weight, hello.cache_bytes, process}));
    services_.work.feed();
}

void WorkerDesk::worker_replaced(WorkerId worker) {
    services_.tasks.take_all_back(worker);
}

void WorkerDesk::worker_resumed(WorkerId worker) {
    // The worker counts as silent until its inventory arrives.
    state_.dispatch.act(state_.dispatch->worker_silent(worker));
    state_.blocks.worker_returned(worker, state_.workers.find(worker)->channel);
}

void WorkerDesk::came(WorkerId id, const Inventory& inventory) {
    Worker* worker = state_.workers.find(id);
    if (worker == nullptr) {
        return;
    }
    if (worker->is_settled) { // A new session has nothing to resynchronise.
        state_.awaited.has_told_all(worker->author->process);
        return services_.work.feed();
    }
    if (const Status sound = check(inventory); !sound) {
        return state_.workers.cut_off(id, sound.error());
    }
    state_.workers.settle(id);
    worker->send(worker->supply.compare(inventory));
    compare_blocks(id, inventory);
    for (const JobId job : inventory.jobs) {
        if (worker->supply.has_job(job)) {
            TaskExchange::drop_cancelled(*worker, state_.jobs.at(job));
        }
    }
    if (!worker->is_quarantined) {
        worker->send(worker->supply.add_kept(state_.trees.messages()));
    }
    services_.tasks.compare(id, inventory.tasks);
    state_.dispatch.act(state_.dispatch->worker_heard(id));
    if (state_.dispatch.view().worker_status(id).draining) {
        worker->channel->send(Drain{}); // An earlier Drain may have been lost.
    }
    services_.work.feed();
}

Status WorkerDesk::check(const Inventory& inventory) const {
    for (const InventoryTree& tree : inventory.trees) {
        const auto geometry = state_.trees.find(tree.tree);
        if (geometry != nullptr && !geometry->has_blocks(tree.held)) {
            return Error{ErrorCode::BadFrame, "it speaks of a root that does not exist"};
        }
    }
    return Done{};
}

/// Records that the worker holds exactly the blocks in its inventory.
void WorkerDesk::compare_blocks(WorkerId id, const Inventory& inventory) {
    for (const InventoryTree& tree : inventory.trees) {
        if (state_.workers.find(id)->supply.has_tree(tree.tree)) {
            came(id, Held{tree.tree, tree.held});
            const auto gone = others(state_.trees.find(tree.tree)->root_count(), tree.held);
            state_.dispatch.act(state_.dispatch->roots_evicted(id, tree.tree, gone));
        }
    }
}

// ---- Silence -----------------------------------------------------------------------------------

void WorkerDesk::worker_detached(WorkerId worker) {
    state_.blocks.worker_detached(worker);
    worker_silent(worker);
}

void WorkerDesk::worker_silent(WorkerId worker) {
    state_.dispatch.act(state_.dispatch->worker_silent(worker));
    services_.work.feed();
}

void WorkerDesk::worker_heard_again(WorkerId worker) {
    state_.dispatch.act(state_.dispatch->worker_heard(worker));
    services_.work.feed();
}

void WorkerDesk::watch() {
    is_watching_ = true;
    const FailureTimes::Duration period = heartbeat_ / 2;
    const bool is_at_end = state_.dispatch.view().is_at_end();
    state_.loop.after(is_at_end ? std::min(period, timing::end_check_period) : period,
                      [this, is_at_end] {
                          state_.workers.check();
                          if (is_at_end) {
                              services_.work.feed(); // A straggler may need a speculative copy.
                          }
                          is_watching_ = false;
                          if (state_.workers.is_watching()) {
                              watch();
                          }
                      });
}

// ---- Leaving -----------------------------------------------------------------------------------

void WorkerDesk::draining(WorkerId worker) {
    log_info("worker draining: worker={}", worker.value);
    state_.dispatch.act(state_.dispatch->worker_draining(worker));
    services_.work.feed();
}

void WorkerDesk::drain(WorkerId worker) {
    const auto channel = state_.workers.find(worker)->channel;
    draining(worker);
    channel->send(Drain{}); // Arrives after all messages queued for the worker.
}

void WorkerDesk::terminate(WorkerId worker) {
    log_info("worker told to end at once: worker={}", worker.value);
    services_.tasks.take_all_back(worker);
    state_.workers.dismiss(worker);
    services_.work.feed();
}

void WorkerDesk::worker_left(WorkerId worker) {
    state_.blocks.worker_left(worker);
    state_.writer.forget(worker);
    services_.ingest.forget(worker);
    services_.tasks.book().forget(worker);
    state_.dispatch.act(state_.dispatch->worker_lost(worker));
    services_.work.feed();
}

// ---- Blocks ------------------------------------------------------------------------------------

void WorkerDesk::came(WorkerId worker, const Evicted& evicted) {
    state_.blocks.evicted(worker, evicted);
    state_.dispatch.act(state_.dispatch->roots_evicted(worker, evicted.tree, evicted.roots));
}

void WorkerDesk::came(WorkerId id, const WantSubtrees& want) {
    if (!state_.blocks.knows(id, want.tree)) {
        return; // The worker is quarantined, or the tree is gone.
    }
    if (const Status known = state_.blocks.wanted(id, want); !known) {
        return state_.workers.cut_off(id, known.error());
    }
    state_.dispatch->roots_wanted(id, want.tree, without_top(want.roots));
    Worker* worker = state_.workers.find(id);
    const auto geometry = state_.trees.find(want.tree);
    if (worker == nullptr || geometry == nullptr) {
        return;
    }
    for (const RootIndex root : want.roots) {
        worker->meter.transfers().wanted(
            want.tree, root, geometry->compressed_bytes(root), seconds_of(state_.loop.now()));
    }
}

void WorkerDesk::came(WorkerId id, const Held& held) {
    if (const Status known = state_.blocks.held(id, held); !known) {
        return state_.workers.cut_off(id, known.error());
    }
    if (Worker* worker = state_.workers.find(id)) {
        if (const auto measured = worker->meter.transfers().held(
                held.tree, held.roots, seconds_of(state_.loop.now()))) {
            state_.dispatch->transfer_measured(id, measured->bytes, measured->seconds);
        }
    }
    state_.dispatch->roots_arrived(id, held.tree, held.roots);
}

void WorkerDesk::came(WorkerId worker, const FetchFailed& failed) {
    state_.blocks.failed(worker, failed);
}

void WorkerDesk::came(WorkerId id, const Holding& holding) {
    Worker* worker = state_.workers.find(id);
    if (worker == nullptr || worker->is_quarantined) {
        return;
    }
    if (const Status kept = worker->supply.cuts_kept(holding); !kept) {
        return state_.workers.cut_off(id, kept.error());
    }
    if (worker->is_settled) { // Otherwise the trees are added when the inventory arrives.
        worker->send(worker->supply.add_kept(state_.trees.messages()));
    }
}

BlockIndex::Blocks WorkerDesk::blocks_held_by(WorkerId worker) const {
    const auto known = state_.workers.all().find(worker);
    const bool is_known = known != state_.workers.all().end() && known->second.is_settled &&
                          !known->second.is_quarantined && known->second.channel->is_open();
    return is_known ? state_.blocks.held_by(worker) : BlockIndex::Blocks{};
}

// ---- Tasks -------------------------------------------------------------------------------------

void WorkerDesk::came(WorkerId worker, Results results, std::function<void()> done) {
    services_.ingest.came(worker, std::move(results), std::move(done));
}

void WorkerDesk::came(WorkerId worker, const EndOfTask& end) {
    services_.tasks.ended(worker, end.task);
    services_.work.feed();
}

void WorkerDesk::came(WorkerId worker, const Recalled& recalled) {
    services_.tasks.recalled(worker, recalled);
    services_.work.feed();
}

WorkerStatus WorkerDesk::work_of(WorkerId worker) const {
    WorkerStatus status = state_.dispatch.view().worker_status(worker);
    const BlockDelivery::Sent sent = state_.blocks.sent_to(worker);
    status.subtrees_sent = sent.blocks;
    status.subtree_bytes_sent = sent.bytes;
    return status;
}

} // namespace cd
