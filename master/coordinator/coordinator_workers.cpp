// Handles messages from workers and sends them trees and jobs.
#include "common/core/check.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "master/coordinator/coordinator.hpp"

#include <array>

namespace cd {

/// Keeps ranges: the dispatcher still has to return them.
void Coordinator::forget_tasks(WorkerId worker) {
    std::erase_if(tasks_, [&](const auto& task) {
        return task.second.worker == worker && !task.second.content->range;
    });
}

void Coordinator::evicted(WorkerId worker, const Evicted& evicted) {
    blocks_.evicted(worker, evicted);
    act(dispatcher().roots_evicted(worker, evicted.tree, evicted.roots));
}

void Coordinator::blocks_wanted(WorkerId id, const WantSubtrees& want) {
    if (!blocks_.knows(id, want.tree)) {
        return; // The worker is quarantined, or the tree is gone.
    }
    if (const Status known = blocks_.wanted(id, want); !known) {
        return workers_.cut_off(id, known.error());
    }
    dispatcher().roots_wanted(id, want.tree, without_top(want.roots));
    Worker* worker = workers_.find(id);
    const auto geometry = trees_.find(want.tree);
    if (worker == nullptr || geometry == nullptr) {
        return;
    }
    for (const RootIndex root : want.roots) {
        worker->meter.transfers().wanted(want.tree, root, geometry->compressed_bytes(root), now());
    }
}

void Coordinator::blocks_held(WorkerId id, const Held& held) {
    if (const Status known = blocks_.held(id, held); !known) {
        return workers_.cut_off(id, known.error());
    }
    if (Worker* worker = workers_.find(id)) {
        if (const auto measured = worker->meter.transfers().held(held.tree, held.roots, now())) {
            dispatcher().transfer_measured(id, measured->bytes, measured->seconds);
        }
    }
    dispatcher().roots_arrived(id, held.tree, held.roots);
}

void Coordinator::peer_failed(WorkerId worker, const FetchFailed& failed) {
    blocks_.failed(worker, failed);
}

void Coordinator::cuts_held(WorkerId id, const Holding& holding) {
    Worker* worker = workers_.find(id);
    if (worker == nullptr || worker->is_quarantined) {
        return;
    }
    if (const Status kept = worker->supply.cuts_kept(holding); !kept) {
        return workers_.cut_off(id, kept.error());
    }
    if (worker->is_settled) { // Otherwise they are added when its inventory is known.
        worker->send(worker->supply.add_kept(trees_.messages()));
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
        workers_.cut_off(
            worker,
            {ErrorCode::BadFrame,
             "it ended a task without an answer for " + std::to_string(left) + " scenarios"});
    }
}

void Coordinator::add_job_to(Worker& worker, const MasterJob& job) {
    if (worker.supply.has_job(job.id)) {
        return;
    }
    AddJob add{job.id, {job.tree_a, job.tree_b}, job.submit.query, std::nullopt};
    if (const Grid* grid = job.order->grid()) {
        add.grid = encode_grid(*grid);
    }
    const std::array trees{trees_.message(job.tree_a), trees_.message(job.tree_b)};
    worker.send(worker.supply.add_job(add, trees));
    drop_cancelled(worker, job);
}

void Coordinator::drop_cancelled(const Worker& worker, const MasterJob& job) {
    for (const std::uint64_t scenario : job.cancelled) {
        worker.channel->send(DropScenario{job.id, scenario});
    }
}

void Coordinator::note_work(WorkerId id) {
    if (Worker* worker = workers_.find(id)) {
        worker->meter.work_is(dispatcher_.worker_status(id).working != 0, Clock::now());
    }
}

} // namespace cd
