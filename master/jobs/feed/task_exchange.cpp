#include "master/jobs/feed/task_exchange.hpp"

#include "common/core/check.hpp"
#include "common/core/host/log.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cd {

// ---- Actions of the dispatcher -----------------------------------------------------------------

void TaskExchange::send(const SendUnit& action) {
    Worker* worker = workers_.find(action.worker);
    if (worker == nullptr) {
        return; // The worker has left, and the dispatcher queues the positions again.
    }
    MasterJob* job = jobs_.find_running(action.job);
    if (job == nullptr) {
        return dispatch_.act(dispatch_->task_ended(action.worker, action.task));
    }
    job->tally.help.copies += action.copy_of == TaskId{} ? 0 : action.positions.count();
    auto content = std::make_shared<const TaskContent>(content_of(*job, action));
    add_job_to(*worker, *job);
    WorkUnit unit = content->unit(action.task);
    unit.results_wait_ms = static_cast<std::uint32_t>(1e3 * action.results_wait_seconds);
    worker->channel->send(unit);
    book_.add(action.worker, action.task, {std::move(content)});
    note_work(action.worker);
}

TaskContent TaskExchange::content_of(const MasterJob& job, const SendUnit& action) {
    const JobWork& work = *job.work();
    TaskContent content{job.id, work.material, {}, std::nullopt};
    if (!action.is_analysed) {
        const auto runs = action.positions.runs();
        CD_CHECK(runs.size() == 1);
        content.range = RangeContent{runs.front(), action.window, job.run->poses};
        return content;
    }
    for (const std::uint64_t position : action.positions.list()) {
        content.analyses.push_back(work.open.find(position));
        CD_CHECK(content.analyses.back() != nullptr);
    }
    return content;
}

void TaskExchange::send(const SendHint& action) {
    Worker* worker = workers_.find(action.worker);
    const MasterJob* job = jobs_.find_running(action.job);
    if (worker != nullptr && job != nullptr) {
        add_job_to(*worker, *job);
        worker->channel->send(Hint{action.job, action.tree, action.roots});
    }
}

void TaskExchange::send(const AskBack& action) {
    const Worker* worker = workers_.find(action.worker);
    const Lease* lease = book_.find(action.worker, action.task);
    if (worker != nullptr && lease != nullptr) {
        worker->channel->send(lease->content->recall(action.task, action.positions));
    }
}

void TaskExchange::send(const UnitsReturned& action) {
    if (MasterJob* job = jobs_.find_running(action.job)) {
        job->tally.help.recalled += action.positions;
    }
}

void TaskExchange::send(const CallOff& action) {
    const Worker* worker = workers_.find(action.worker);
    const Lease* lease = book_.find(action.worker, action.task);
    if (worker == nullptr || lease == nullptr) {
        return;
    }
    for (const std::uint64_t position : action.positions.list()) {
        const std::uint64_t index = lease->content->index_of(position);
        worker->channel->send(DropScenario{lease->content->job, index, action.task});
    }
}

void TaskExchange::add_job_to(Worker& worker, const MasterJob& job) {
    if (worker.supply.has_job(job.id)) {
        return;
    }
    const JobWork& work = *job.work();
    AddJob add{job.id, work.trees, job.submit.query, std::nullopt};
    if (const Grid* grid = job.run->poses->grid()) {
        add.grid = encode_grid(*grid);
    }
    if (work.material != nullptr) {
        add.radii = work.material->radii;
    }
    if (work.material != nullptr && work.material->parts != nullptr) {
        for (const PartRuns& body : *work.material->parts) {
            add.parts.push_back(body.runs());
        }
    }
    std::vector<AddTree> trees;
    for (const TreeId tree : work.trees) {
        trees.push_back(trees_.message(tree));
    }
    worker.send(worker.supply.add_job(add, trees));
    drop_cancelled(worker, job);
}

// ---- From a worker -----------------------------------------------------------------------------

void TaskExchange::ended(WorkerId worker, TaskId id) {
    Lease* lease = book_.find(worker, id);
    if (lease == nullptr) {
        log_warning("end of an unknown task: worker={} task={}", worker.value, id.value);
        return;
    }
    lease->ended = true;
    end_if_complete(worker, id, *lease);
}

void TaskExchange::recalled(WorkerId worker, const Recalled& recalled) {
    if (const Lease* lease = book_.find(worker, recalled.task)) {
        dispatch_.act(
            dispatch_->task_recalled(worker, recalled.task, lease->content->returned(recalled)));
        note_work(worker);
    }
}

void TaskExchange::checked(WorkerId worker, TaskId id) {
    if (Lease* lease = book_.find(worker, id)) { // Null if the worker has left.
        --lease->checks;
        end_if_complete(worker, id, *lease);
    }
}

// A message that returned work may be lost, so a task's inventory entry counts as a return. A task
// that the inventory lacks never reached the worker, or has ended with all its results sent.
void TaskExchange::compare(WorkerId worker, std::span<const Recalled> present) {
    for (const Recalled& task : present) {
        recalled(worker, task);
    }
    for (const TaskId id : book_.missing(worker, present)) {
        Lease* lease = book_.find(worker, id);
        CD_CHECK(lease != nullptr);
        lease->unbegun = !lease->ended;
        lease->ended = true;
        end_if_complete(worker, id, *lease);
    }
}

void TaskExchange::end_if_complete(WorkerId worker, TaskId id, const Lease& lease) {
    if (!lease.ended || lease.checks != 0) {
        return;
    }
    const bool unbegun = lease.unbegun;
    book_.remove(worker, id);
    const std::uint64_t left = unbegun ? 0 : dispatch_.view().owed(worker, id);
    dispatch_.act(unbegun ? dispatch_->task_unbegun(worker, id)
                          : dispatch_->task_ended(worker, id));
    note_work(worker);
    if (left != 0) {
        // The worker is alive, so the work is taken back without counting as lost.
        take_all_back(worker);
        workers_.cut_off(
            worker,
            {ErrorCode::BadFrame,
             "it ended a task without an answer for " + std::to_string(left) + " scenarios"});
    }
}

void TaskExchange::take_all_back(WorkerId worker) {
    // Drains the worker first; otherwise it would get some of the work again.
    dispatch_.act(dispatch_->worker_draining(worker));
    for (const TaskId task : book_.missing(worker, {})) {
        dispatch_.act(dispatch_->task_unbegun(worker, task));
    }
    book_.forget(worker);
}

// ---- Cancelled scenarios -----------------------------------------------------------------------

void TaskExchange::drop(JobId job, std::uint64_t scenario) {
    for (const auto& [id, worker] : workers_.all()) {
        if (worker.supply.has_job(job)) {
            worker.channel->send(DropScenario{job, scenario});
        }
    }
}

void TaskExchange::drop_cancelled(const Worker& worker, const MasterJob& job) {
    for (const std::uint64_t scenario : job.work()->cancelled) {
        worker.channel->send(DropScenario{job.id, scenario});
    }
}

void TaskExchange::note_work(WorkerId id) {
    if (Worker* worker = workers_.find(id)) {
        worker->meter.work_is(dispatch_.view().worker_status(id).working != 0, jobs_.now());
    }
}

} // namespace cd
