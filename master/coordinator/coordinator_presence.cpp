// Tells the dispatcher and the block delivery which workers come, return, fall silent and leave.
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "master/coordinator/coordinator.hpp"

#include <algorithm>

namespace cd {

namespace {

bool names(const std::vector<Recalled>& list, TaskId one) {
    return std::ranges::find(list, one, &Recalled::task) != list.end();
}

/// All roots below `count` that are not in `held`, which ascends.
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

} // namespace

// ---- Joining and returning --------------------------------------------------------------------

void Coordinator::worker_joined(WorkerId id, const Hello& hello) {
    if (watch_timer_ == nullptr && !closed_) {
        watch_timer_ = std::make_shared<asio::steady_timer>(parts_.executor);
        spawn(parts_.executor, "watch over workers", watch_workers());
    }
    const Worker& worker = *workers_.find(id);
    const InstanceId process = worker.author->process;
    if (alarms_.is_quarantined(process)) {
        (void)workers_.quarantine(process);
        log_error("worker stays in quarantine: worker={} name={}", id.value, hello.name);
        return;
    }
    blocks_.worker_joined(id, worker.channel, worker.key, hello.peer_port);
    act(dispatcher().worker_joined(
        id, {hello.name, worker.threads, hello.weight, hello.cache_bytes, process}));
    feed();
}

void Coordinator::take_all_back(WorkerId worker) {
    std::vector<TaskId> given;
    for (const auto& [task, running] : tasks_) {
        if (running.worker == worker) {
            given.push_back(task);
        }
    }
    act(dispatcher().worker_draining(worker)); // Otherwise the worker would get some of it again.
    for (const TaskId task : given) {
        act(dispatcher().task_unbegun(worker, task));
    }
}

void Coordinator::worker_resumed(WorkerId worker) {
    act(dispatcher().worker_silent(worker)); // Ends when its Standing arrives.
    blocks_.worker_returned(worker, workers_.find(worker)->channel);
}

void Coordinator::worker_stands(WorkerId id, const Standing& standing) {
    Worker* worker = workers_.find(id);
    if (worker == nullptr) {
        return;
    }
    if (worker->is_settled) { // The session is new.
        awaited_.has_told_all(worker->author->process);
        return feed();
    }
    if (const Status sound = check_standing(standing); !sound) {
        return workers_.cut_off(id, sound.error());
    }
    workers_.settle(id);
    worker->send(worker->supply.stands(standing));
    take_lost_blocks(id, standing);
    for (const JobId job : standing.jobs) {
        if (worker->supply.has_job(job)) {
            drop_cancelled(*worker, jobs_.at(job));
        }
    }
    if (!worker->is_quarantined) {
        worker->send(worker->supply.add_kept(trees_.messages()));
    }
    take_lost_tasks(id, standing);
    act(dispatcher().worker_heard(id));
    if (dispatcher_.worker_status(id).draining) {
        worker->channel->send(Drain{}); // The first may have been lost with a connection.
    }
    feed();
}

Status Coordinator::check_standing(const Standing& standing) const {
    for (const StandingTree& tree : standing.trees) {
        const auto geometry = trees_.find(tree.tree);
        if (geometry != nullptr && !geometry->has_blocks(tree.held)) {
            return Error{ErrorCode::BadFrame, "it speaks of a root that does not exist"};
        }
    }
    return Done{};
}

/// Takes the blocks in the worker's inventory for those that it holds, and no others.
void Coordinator::take_lost_blocks(WorkerId id, const Standing& standing) {
    for (const StandingTree& tree : standing.trees) {
        if (workers_.find(id)->supply.has_tree(tree.tree)) {
            blocks_held(id, Held{tree.tree, tree.held});
            const auto gone = others(trees_.find(tree.tree)->root_count(), tree.held);
            act(dispatcher().roots_evicted(id, tree.tree, gone));
        }
    }
}

/// A missing task never arrived or has ended; in the latter case its results arrived before. For a
/// present task, a return of work may have been lost, so it is processed again.
void Coordinator::take_lost_tasks(WorkerId worker, const Standing& standing) {
    for (const Recalled& task : standing.tasks) {
        task_recalled(worker, task);
    }
    std::vector<TaskId> missing;
    for (const auto& [id, task] : tasks_) {
        if (task.worker == worker && !names(standing.tasks, id)) {
            missing.push_back(id);
        }
    }
    for (const TaskId id : missing) {
        RunningTask& task = tasks_.at(id);
        task.unbegun = !task.ended;
        task.ended = true;
        end_task_if_complete(id);
    }
}

// ---- Silence ----------------------------------------------------------------------------------

void Coordinator::worker_detached(WorkerId worker) {
    blocks_.worker_detached(worker);
    worker_silent(worker);
}

void Coordinator::worker_silent(WorkerId worker) {
    act(dispatcher().worker_silent(worker));
    feed();
}

void Coordinator::worker_heard_again(WorkerId worker) {
    act(dispatcher().worker_heard(worker));
    feed();
}

asio::awaitable<void> Coordinator::watch_workers() {
    const auto timer = watch_timer_;
    while (!closed_ && workers_.is_watching()) {
        const FailureTimes::Duration period = parts_.times.heartbeat / 2;
        const bool is_at_end = dispatcher_.is_at_end();
        timer->expires_after(is_at_end ? std::min(period, limits::end_check_period) : period);
        boost::system::error_code ignored;
        co_await timer->async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        if (!closed_) {
            workers_.check();
        }
        if (!closed_ && is_at_end) {
            feed(); // A straggler may need a speculative copy.
        }
    }
    watch_timer_.reset();
}

void Coordinator::close() {
    closed_ = true;
    *closing_ = true;
    workers_.close();
    blocks_.close();
    if (watch_timer_ != nullptr) {
        watch_timer_->cancel();
    }
    if (awaited_until_ != nullptr) {
        awaited_until_->cancel();
    }
    retries_.close();
    references_.close();
}

// ---- Leaving ----------------------------------------------------------------------------------

void Coordinator::worker_draining(WorkerId worker) {
    log_info("worker draining: worker={}", worker.value);
    act(dispatcher().worker_draining(worker));
    feed();
}

void Coordinator::drain_worker(WorkerId worker) {
    const auto channel = workers_.find(worker)->channel;
    worker_draining(worker);
    channel->send(Drain{}); // Sent after everything queued for the worker.
}

void Coordinator::terminate_worker(WorkerId worker) {
    log_info("worker told to end at once: worker={}", worker.value);
    take_all_back(worker);
    workers_.dismiss(worker);
    feed();
}

void Coordinator::worker_left(WorkerId worker) {
    blocks_.worker_left(worker);
    writer_.forget(worker);
    forget_late_results(worker);
    forget_tasks(worker);
    act(dispatcher().worker_lost(worker));
    feed();
}

WorkerStatus Coordinator::work_of(WorkerId worker) const {
    WorkerStatus status = dispatcher_.worker_status(worker);
    const BlockDelivery::Sent sent = blocks_.sent_to(worker);
    status.subtrees_sent = sent.blocks;
    status.subtree_bytes_sent = sent.bytes;
    return status;
}

} // namespace cd
