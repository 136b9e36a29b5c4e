// Handles messages from workers and sends them trees and jobs.
#include "common/core/check.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "master/coordinator/coordinator.hpp"

namespace cd {

/// Keeps ranges: the dispatcher still has to return them.
void Coordinator::forget_tasks(WorkerId worker) {
    std::erase_if(tasks_, [&](const auto& task) {
        return task.second.worker == worker && !task.second.content->range;
    });
}

void Coordinator::heartbeat_came(WorkerId worker, const Heartbeat& heartbeat) {
    const auto link = workers_.find(worker);
    if (link != workers_.end()) {
        link->second.cached_bytes = heartbeat.cached_bytes;
        link->second.cache = heartbeat.traffic;
        link->second.longest = heartbeat.longest;
    }
}

void Coordinator::evicted(WorkerId worker, const Evicted& evicted) {
    blocks_.evicted(worker, evicted);
    act(dispatcher().roots_evicted(worker, evicted.tree, evicted.roots));
}

void Coordinator::blocks_wanted(WorkerId worker, const WantSubtrees& want) {
    if (!blocks_.knows(worker, want.tree)) {
        return; // The worker is quarantined, or the tree is gone.
    }
    if (const Status known = blocks_.wanted(worker, want); !known) {
        return cut_off(worker, known.error());
    }
    dispatcher().roots_wanted(worker, want.tree, without_top(want.roots));
    const auto link = workers_.find(worker);
    const auto geometry = trees_.find(want.tree);
    if (link == workers_.end() || geometry == nullptr) {
        return;
    }
    for (const RootIndex root : want.roots) {
        link->second.transfers.wanted(want.tree, root, geometry->compressed_bytes(root), now());
    }
}

void Coordinator::blocks_held(WorkerId worker, const Held& held) {
    if (const Status known = blocks_.held(worker, held); !known) {
        return cut_off(worker, known.error());
    }
    if (const auto link = workers_.find(worker); link != workers_.end()) {
        if (const auto measured = link->second.transfers.held(held.tree, held.roots, now())) {
            dispatcher().transfer_measured(worker, measured->bytes, measured->seconds);
        }
    }
    dispatcher().roots_arrived(worker, held.tree, held.roots);
}

void Coordinator::peer_failed(WorkerId worker, const FetchFailed& failed) {
    blocks_.failed(worker, failed);
}

void Coordinator::cuts_held(WorkerId worker, const Holding& holding) {
    const auto link = workers_.find(worker);
    if (link != workers_.end() && !link->second.quarantined) {
        link->second.cuts.insert(holding.cuts.begin(), holding.cuts.end());
        if (link->second.cuts.size() > limits::cuts_held_max) {
            return cut_off(worker, {ErrorCode::TooLarge, "it holds blocks of too many cuts"});
        }
        add_held_trees(link->second);
    }
}

void Coordinator::add_held_trees(WorkerLink& link) {
    if (!link.is_settled) {
        return; // Runs again when the worker's inventory is known.
    }
    for (const TreeId tree : trees_.all()) {
        if (link.cuts.contains(trees_.cut(tree))) {
            add_tree_to(link, tree);
        }
    }
}

void Coordinator::task_ended(WorkerId worker, TaskId id) {
    const auto task = tasks_.find(id);
    if (task == tasks_.end() || task->second.worker != worker) {
        log_warning("end of an unknown task: worker={} task={}", worker.value, id.value);
        return;
    }
    task->second.ended = true;
    end_task_if_complete(id);
    feed();
}

void Coordinator::task_recalled(WorkerId worker, const Recalled& recalled) {
    const auto task = tasks_.find(recalled.task);
    if (task != tasks_.end() && task->second.worker == worker) {
        act(dispatcher().task_recalled(worker, recalled));
        note_work(worker);
        feed();
    }
}

void Coordinator::end_task_if_complete(TaskId id) {
    const auto task = tasks_.find(id);
    CD_CHECK(task != tasks_.end());
    if (!task->second.ended || task->second.in_hand != 0) {
        return;
    }
    const WorkerId worker = task->second.worker;
    const bool unbegun = task->second.unbegun;
    const bool is_excused = unbegun || task->second.is_called_off;
    if (!task->second.content->range) {
        tasks_.erase(task);
    }
    const std::uint64_t left = is_excused ? 0 : dispatcher_.owed(worker, id);
    act(unbegun ? dispatcher().task_unbegun(worker, id) : dispatcher().task_ended(worker, id));
    note_work(worker);
    if (left != 0) {
        // The process is alive, so its tasks did not kill it.
        take_all_back(worker);
        cut_off(worker,
                {ErrorCode::BadFrame,
                 "it ended a task without an answer for " + std::to_string(left) + " scenarios"});
    }
}

void Coordinator::add_job_to(WorkerLink& link, const MasterJob& job) {
    if (!link.jobs.insert(job.id).second) {
        return;
    }
    add_tree_to(link, job.tree_a);
    add_tree_to(link, job.tree_b);
    AddJob add{job.id, {job.tree_a, job.tree_b}, job.submit.query, std::nullopt};
    if (const Grid* grid = job.order->grid()) {
        add.grid = encode_grid(*grid);
    }
    link.channel->send(add);
    for (const std::uint64_t scenario : job.cancelled) {
        link.channel->send(DropScenario{job.id, scenario});
    }
}

void Coordinator::add_tree_to(WorkerLink& link, TreeId tree) {
    if (link.trees.insert(tree).second) {
        const auto geometry = trees_.find(tree);
        CD_CHECK(geometry != nullptr);
        link.channel->send(AddTree{tree,
                                   geometry->form(),
                                   trees_.cut(tree),
                                   geometry->hash(top_root),
                                   geometry->root_count(),
                                   geometry->top().triangle_count()});
    }
}

void Coordinator::note_work(WorkerId worker) {
    const auto found = workers_.find(worker);
    if (found == workers_.end()) {
        return;
    }
    WorkerLink& link = found->second;
    const bool is_busy = dispatcher_.worker_status(worker).working != 0;
    if (is_busy && !link.busy_since) {
        link.busy_since = Clock::now();
    } else if (!is_busy && link.busy_since) {
        link.busy += Clock::now() - *link.busy_since;
        link.busy_since.reset();
    }
}

WorkerStatus Coordinator::worker_status(WorkerId worker, const WorkerLink& link) const {
    WorkerStatus status = dispatcher_.worker_status(worker);
    status.worker = worker;
    status.name = link.author->name;
    status.quarantined = link.quarantined;
    status.state = watch_.state(worker).value_or(WorkerState::Alive);
    status.silent_seconds = watch_.silence(worker, Clock::now()).count();
    status.longest = link.longest;
    status.cache_bytes = link.cache_bytes;
    status.cached_bytes = link.cached_bytes;
    const auto busy =
        link.busy + (link.busy_since ? Clock::now() - *link.busy_since : Clock::duration{});
    const double seconds = std::chrono::duration<double>(busy).count();
    status.scenarios_per_second = seconds > 0 ? static_cast<double>(status.scenarios) / seconds : 0;
    status.bytes_sent = link.channel->traffic().bytes_sent;
    status.bytes_received = link.channel->traffic().bytes_received;
    status.subtrees_sent = blocks_.sent_to(worker).blocks;
    status.subtree_bytes_sent = blocks_.sent_to(worker).bytes;
    status.cache = link.cache;
    return status;
}

} // namespace cd
