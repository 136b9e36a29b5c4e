#include "master/dispatch/task_table.hpp"

#include "common/core/check.hpp"
#include "master/base/mutation.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace cd {

// ---- Sending ------------------------------------------------------------------------------------

void TaskTable::send(WorkerProxy& proxy,
                     DispatchJob& job,
                     std::vector<std::uint64_t> scenarios,
                     bool claims,
                     Actions& actions) {
    const TaskId task{++last_};
    TaskInFlight content{job.id, scenarios, claims, 0, pace_.now(), false, 0};
    for (const std::uint64_t index : scenarios) {
        DispatchScenario& scenario = job.at(index);
        content.cost_ns += scenario.weight.cost_ns;
        content.fetches = content.fetches || scenario.fetches;
        scenario.where = Whereabouts::Sent;
        scenario.worker = proxy.id();
        scenario.task = task;
    }
    queue_.leave(scenarios.size());
    proxy.tasks.start(task, std::move(content));
    actions.push_back(SendBatch{proxy.id(), task, job.id, std::move(scenarios)});
}

void TaskTable::send_places(WorkerProxy& proxy,
                            DispatchJob& job,
                            const PlaceRange& places,
                            std::uint64_t each_ns,
                            Actions& actions) {
    const TaskId task{++last_};
    const std::uint64_t cost_ns = places.count * each_ns;
    job.copies.add_work(cost_ns);
    proxy.tasks.start(task,
                      {job.id, {}, false, cost_ns, pace_.now(), false, 0, places, places.count});
    actions.push_back(SendRange{proxy.id(), task, job.id, places});
}

void TaskTable::send_copy(
    WorkerProxy& helper, DispatchJob& job, std::uint64_t index, bool fetches, Actions& actions) {
    const TaskId task{++last_};
    DispatchScenario& scenario = job.at(index);
    TaskInFlight content{job.id, {index}, false, scenario.weight.cost_ns, pace_.now(), fetches, 0};
    content.is_copy = true;
    scenario.copy = {helper.id(), task};
    scenario.was_copied = true;
    job.copies.add_copy(scenario.weight.cost_ns);
    helper.tasks.start(task, std::move(content));
    actions.push_back(SendBatch{helper.id(), task, job.id, {index}, true});
}

void TaskTable::copy_places(
    WorkerProxy& from, TaskId task, WorkerProxy& helper, std::uint64_t count, Actions& actions) {
    const TaskInFlight& original = from.tasks.at(task);
    DispatchJob& job = queue_.at(original.job);
    const PlaceRange places{original.places->end() - original.places_copied - count, count};
    const std::uint64_t cost_ns = count * original.each_ns();
    const TaskId id{++last_};
    TaskInFlight content{job.id, {}, false, cost_ns, pace_.now(), false, 0, places, count};
    content.is_copy = true;
    from.tasks.add_copied(task, count);
    job.copies.add_copy(cost_ns);
    helper.tasks.start(id, std::move(content));
    actions.push_back(SendRange{helper.id(), id, job.id, places, task});
}

// ---- Answers and ends ---------------------------------------------------------------------------

void TaskTable::withdraw(DispatchJob& job,
                         std::uint64_t index,
                         DispatchScenario& scenario,
                         WorkerId by,
                         Actions& actions) {
    switch (scenario.where) {
    case Whereabouts::Waiting:
    case Whereabouts::Suspect:
        queue_.remove(job, index, scenario);
        return;
    case Whereabouts::Buffered:
        pool_.at(scenario.worker).buffers.remove(job.id, index, scenario.weight);
        queue_.leave(mutated(Mutation::RoomNotGivenBack) ? 0 : 1);
        return;
    case Whereabouts::Sent:
        if (!mutated(Mutation::AnswerLeftAtWorker)) {
            answer_sent(job, index, scenario, by, actions);
        }
        return;
    }
}

void TaskTable::answer_sent(DispatchJob& job,
                            std::uint64_t index,
                            const DispatchScenario& scenario,
                            WorkerId by,
                            Actions& actions) {
    const std::uint64_t cost_ns = scenario.weight.cost_ns;
    pool_.at(scenario.worker).tasks.answer(scenario.task, index, cost_ns, scenario.worker == by);
    if (scenario.copy && !mutated(Mutation::CopyLeftAtWorker)) {
        const auto& [worker, task] = *scenario.copy;
        const bool copy_won = worker == by;
        pool_.at(worker).tasks.answer(task, index, cost_ns, copy_won);
        actions.push_back(CallOff{
            copy_won ? scenario.worker : worker, copy_won ? scenario.task : task, job.id, index});
    }
}

TaskInFlight TaskTable::end(WorkerProxy& proxy, TaskId task, LostWith lost_with, Actions& actions) {
    TaskInFlight ended = proxy.tasks.end(task);
    std::erase_if(recalls_, [&](const auto& asked) { return asked.second.task == task; });
    if (ended.is_range()) {
        if (DispatchJob* job = queue_.find(ended.job)) {
            job->copies.remove_work(ended.cost_ns);
        }
        actions.push_back(RangeEnded{task, ended.job, *ended.places, lost_with});
    } else {
        take_back(task, ended, lost_with, actions);
    }
    return ended;
}

void TaskTable::lose_all(WorkerProxy& proxy, Actions& actions) {
    // Newest task first: each goes to the queue's head, so the oldest task is handed out first.
    while (!proxy.tasks.all().empty()) {
        end(proxy, proxy.tasks.all().rbegin()->first, proxy.facts().process, actions);
    }
    forget_recall(proxy.id());
}

void TaskTable::take_back(TaskId task,
                          const TaskInFlight& ended,
                          LostWith lost_with,
                          Actions& actions) {
    DispatchJob* job = queue_.find(ended.job);
    if (job == nullptr) {
        return;
    }
    std::vector<std::uint64_t> again;
    ScenariosLost lost{job->id, {}, lost_with.value_or(0)};
    for (const std::uint64_t index : ended.scenarios) {
        if (mutated(lost_with ? Mutation::LostLeaseForgotten : Mutation::DrainedWorkForgotten)) {
            job->scenarios.erase(index);
            continue;
        }
        DispatchScenario& scenario = job->at(index);
        // Losing a copy does not count while the original is still running.
        const bool is_copy = scenario.copy && scenario.copy->task == task;
        if (lost_with && !is_copy) {
            scenario.losses.add(*lost_with);
            lost.scenarios.push_back(index);
        }
        if (scenario.leave_task(task) && !mutated(Mutation::CopyIsAlone)) {
            continue;
        }
        if (scenario.is_lost_for_good()) {
            job->scenarios.erase(index);
            actions.push_back(GiveUp{job->id, index});
        } else if (!queue_.suspect(*job, index, scenario)) {
            again.push_back(index);
        }
    }
    queue_.put_back_sent(*job, again);
    if (!lost.scenarios.empty()) {
        actions.push_back(std::move(lost));
    }
}

std::uint64_t TaskTable::owed(WorkerId worker, TaskId task) const {
    const WorkerProxy* const proxy = pool_.find(worker);
    const bool owes = proxy != nullptr && !proxy->is_draining() && proxy->tasks.contains(task);
    return owes ? proxy->tasks.at(task).left() : 0;
}

// ---- Recalls ------------------------------------------------------------------------------------

void TaskTable::ask_back(AskBack ask, std::uint64_t count, WorkerId helper, Actions& actions) {
    recalls_[ask.worker] = {ask.task, count, helper, pace_.now()};
    actions.push_back(std::move(ask));
}

void TaskTable::take_recalled(WorkerProxy& proxy, const Recalled& recalled, Actions& actions) {
    const TaskInFlight& task = proxy.tasks.at(recalled.task);
    DispatchJob* job = queue_.find(task.job);
    GivenBack given{recalled.task, task.job, 0, {}};
    if (job != nullptr && task.is_range()) {
        const std::uint64_t before = task.cost_ns;
        given.places = proxy.tasks.cut_places(recalled.task, recalled.places);
        job->copies.remove_work(before - task.cost_ns);
    } else if (job != nullptr) {
        given.scenarios = take_recalled_scenarios(proxy, *job, recalled);
    }
    const std::uint64_t count = given.scenarios + given.places.count;
    const auto asked = recalls_.find(proxy.id());
    if (asked != recalls_.end() && asked->second.task == recalled.task) {
        if (count < asked->second.asked) {
            proxy.tasks.set_begun(recalled.task);
        }
        recalls_.erase(asked);
    }
    if (count != 0) {
        actions.push_back(given);
    }
}

std::uint64_t
TaskTable::take_recalled_scenarios(WorkerProxy& proxy, DispatchJob& job, const Recalled& recalled) {
    std::uint64_t count = 0;
    std::vector<std::uint64_t> again;
    for (const std::uint64_t index : recalled.scenarios) {
        const auto found = job.scenarios.find(index);
        if (found == job.scenarios.end() || !found->second.is_in(recalled.task)) {
            continue; // Returned before, or answered by another worker.
        }
        DispatchScenario& scenario = found->second;
        ++count;
        if (!mutated(Mutation::RecalledLeftAtWorker)) {
            proxy.tasks.answer(recalled.task, index, scenario.weight.cost_ns, false);
        }
        if (!scenario.leave_task(recalled.task)) {
            ++scenario.recalls;
            again.push_back(index);
        }
    }
    queue_.put_back_sent(job, again);
    return count;
}

} // namespace cd
