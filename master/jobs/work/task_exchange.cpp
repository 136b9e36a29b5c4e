#include "master/jobs/work/task_exchange.hpp"

#include "common/core/check.hpp"
#include "common/core/host/log.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cd {

// ---- Actions of the dispatcher -----------------------------------------------------------------

void TaskExchange::send(const SendBatch& action) {
    Worker* worker = workers_.find(action.worker);
    if (worker == nullptr) {
        return; // The worker has left, and the dispatcher takes the batch back.
    }
    MasterJob* job = jobs_.find_running(action.job);
    if (job == nullptr) {
        return dispatch_.act(dispatch_->task_ended(action.worker, action.task));
    }
    auto content = std::make_shared<TaskContent>();
    content->job = job->id;
    content->material = job->work()->material;
    WorkUnit unit{action.task, job->id, 0, action.scenarios.size(), {}, {0}, {}};
    std::vector<Scenario> scenarios;
    for (const std::uint64_t index : action.scenarios) {
        const auto analysis = job->work()->open.find(index);
        CD_CHECK(analysis != nullptr);
        scenarios.push_back(analysis->scenario);
        unit.pairs.insert(unit.pairs.end(), analysis->pairs.begin(), analysis->pairs.end());
        unit.pair_offsets.push_back(static_cast<std::uint32_t>(unit.pairs.size()));
        content->scenarios.push_back(analysis);
    }
    unit.scenarios = pack_scenarios(scenarios);
    add_job_to(*worker, *job);
    worker->channel->send(unit);
    Lease task{action.worker, std::move(content)};
    task.is_copy = action.is_copy;
    job->tally.help.copies += action.is_copy ? action.scenarios.size() : 0;
    book_.add(action.task, std::move(task));
    note_work(action.worker);
}

void TaskExchange::send(const SendRange& action) {
    MasterJob* job = jobs_.find_running(action.job);
    if (job == nullptr) {
        return dispatch_.act(dispatch_->task_ended(action.worker, action.task));
    }
    const bool is_copy = action.copy_of != TaskId{};
    const Lease* original = is_copy ? book_.find(action.copy_of) : nullptr;
    CD_CHECK(is_copy == (original != nullptr));
    const GivenPlaces given = is_copy ? GivenPlaces{action.places, original->content->range->window}
                                      : job->work()->given.take(action.places);
    job->tally.help.copies += is_copy ? action.places.count : 0;
    auto content = std::make_shared<TaskContent>();
    content->job = job->id;
    content->material = job->work()->material;
    content->range = RangeContent{action.places, given.window, job->work()->order};
    WorkUnit unit{action.task, job->id, action.places.first, action.places.count, {}, {}, {}};
    if (given.window != nullptr) {
        unit.first = 0;
        unit.scenarios = pack_scenarios(given.window->at(action.places));
    }
    Lease task{action.worker, std::move(content)};
    task.is_copy = is_copy;
    task.places = action.places;
    book_.add(action.task, std::move(task));
    // If the worker has left, the dispatcher ends the range.
    if (Worker* worker = workers_.find(action.worker)) {
        add_job_to(*worker, *job);
        worker->channel->send(unit);
        note_work(action.worker);
    }
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
    if (const Worker* worker = workers_.find(action.worker)) {
        worker->channel->send(Recall{action.task, action.scenarios, action.places});
    }
}

void TaskExchange::send(const CallOff& action) {
    if (const Worker* worker = workers_.find(action.worker)) {
        worker->channel->send(DropScenario{action.job, action.scenario, action.task});
    }
}

void TaskExchange::add_job_to(Worker& worker, const MasterJob& job) {
    if (worker.supply.has_job(job.id)) {
        return;
    }
    const JobWork& work = *job.work();
    AddJob add{job.id, work.trees, job.submit.query, std::nullopt};
    if (const Grid* grid = work.order->grid()) {
        add.grid = encode_grid(*grid);
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
    Lease* task = book_.find(id, worker);
    if (task == nullptr) {
        log_warning("end of an unknown task: worker={} task={}", worker.value, id.value);
        return;
    }
    task->ended = true;
    end_if_complete(id, *task);
}

void TaskExchange::recalled(WorkerId worker, const Recalled& recalled) {
    if (book_.find(recalled.task, worker) != nullptr) {
        dispatch_.act(dispatch_->task_recalled(worker, recalled));
        note_work(worker);
    }
}

void TaskExchange::checked(TaskId id) {
    if (Lease* task = book_.find(id)) { // Null if the worker has left.
        --task->checks;
        end_if_complete(id, *task);
    }
}

// Returned work of a present task may not have arrived, so the inventory's entry counts as a
// return. A missing task either never reached the worker, or has ended after sending all results.
void TaskExchange::compare(WorkerId worker, std::span<const Recalled> present) {
    for (const Recalled& task : present) {
        recalled(worker, task);
    }
    for (const TaskId id : book_.missing(worker, present)) {
        Lease* task = book_.find(id);
        CD_CHECK(task != nullptr);
        task->unbegun = !task->ended;
        task->ended = true;
        end_if_complete(id, *task);
    }
}

void TaskExchange::end_if_complete(TaskId id, Lease& task) {
    if (!task.ended || task.checks != 0) {
        return;
    }
    const WorkerId worker = task.worker;
    const bool unbegun = task.unbegun;
    const bool is_excused = unbegun || task.is_called_off;
    if (!task.content->range) {
        (void)book_.take(id);
    }
    const std::uint64_t left = is_excused ? 0 : dispatch_.view().owed(worker, id);
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
    const std::vector<TaskId> tasks = book_.of(worker);
    // Drains the worker first; otherwise it would get some of the work again.
    dispatch_.act(dispatch_->worker_draining(worker));
    for (const TaskId task : tasks) {
        dispatch_.act(dispatch_->task_unbegun(worker, task));
    }
    book_.forget_batches(worker);
}

// ---- Scenarios that are not to be run ----------------------------------------------------------

void TaskExchange::call_off_copies(JobId job, WorkerId worker, std::uint64_t scenario) {
    for (auto& [id, task] : book_.all()) {
        const Worker* other = workers_.find(task.worker);
        if (task.content->job == job && task.places && task.worker != worker && other != nullptr &&
            task.content->range->scenario(scenario)) {
            other->channel->send(DropScenario{job, scenario, id});
            task.is_called_off = true;
        }
    }
}

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
        worker->meter.work_is(dispatch_.view().worker_status(id).working != 0, Clock::now());
    }
}

} // namespace cd
