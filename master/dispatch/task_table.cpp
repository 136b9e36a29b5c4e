#include "master/dispatch/task_table.hpp"

#include "master/base/mutation.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace cd {

// ---- Sending ------------------------------------------------------------------------------------

void TaskTable::send(WorkerProxy& proxy,
                     DispatchJob& job,
                     std::vector<std::uint64_t> positions,
                     bool claims,
                     Actions& actions) {
    TaskInFlight task{job.id, {}, true, claims, 0, pace_.now()};
    for (const std::uint64_t position : positions) {
        DispatchScenario& scenario = job.at(position);
        task.cost_ns += scenario.weight.cost_ns;
        task.fetches = task.fetches || scenario.fetches;
        scenario.where = Whereabouts::Sent;
        scenario.at = {proxy.id(), TaskId{last_ + 1}};
    }
    queue_.leave(job, positions.size());
    task.positions = PositionSet::of(std::move(positions));
    start(proxy, std::move(task), actions);
}

void TaskTable::send_range(WorkerProxy& proxy,
                           DispatchJob& job,
                           const GivenRange& range,
                           std::uint64_t each_ns,
                           Actions& actions) {
    const std::uint64_t cost_ns = range.positions.count * each_ns;
    TaskInFlight task{job.id, range.positions, false, false, cost_ns, pace_.now()};
    task.window = range.window;
    job.copies.add_work(pace_.mean_cost_of(range.positions.count));
    start(proxy, std::move(task), actions);
}

void TaskTable::send_copy(const Assignment& original,
                          WorkerProxy& helper,
                          const PositionSet& positions,
                          bool fetches,
                          Actions& actions) {
    WorkerTasks& tasks = pool_.at(original.worker).tasks;
    const TaskInFlight& copied = tasks.at(original.task);
    DispatchJob& job = queue_.at(copied.job);
    const std::uint64_t cost_ns = cost_of(job, copied, positions);
    TaskInFlight copy{job.id, positions, copied.is_analysed, false, cost_ns, pace_.now(), fetches};
    copy.shared.original = original;
    copy.window = copied.window;
    job.copies.add_copy(copied.is_analysed ? cost_ns : pace_.mean_cost_of(positions.count()));
    tasks.add_copy(original.task, {helper.id(), TaskId{last_ + 1}}, positions);
    start(helper, std::move(copy), actions);
}

void TaskTable::start(WorkerProxy& proxy, TaskInFlight task, Actions& actions) {
    queue_.order().sent(task.job, task.cost_ns);
    const TaskId id{++last_};
    actions.push_back(
        SendUnit{proxy.id(),
                 id,
                 task.job,
                 task.positions,
                 task.is_analysed,
                 task.shared.original.task,
                 task.window,
                 std::max(timing::results_wait_seconds_min, pool_.message_seconds())});
    proxy.tasks.start(id, std::move(task));
}

// ---- Answers ------------------------------------------------------------------------------------

const TaskInFlight* TaskTable::find(const Assignment& task) const {
    const WorkerProxy* const proxy = pool_.find(task.worker);
    return proxy == nullptr ? nullptr : proxy->tasks.find(task.task);
}

TaskTable::Relieved TaskTable::answer(DispatchJob& job, const Answers& answers, Actions& actions) {
    Relieved relieved;
    PositionSet rest = answers.positions;
    // `sought` counts the positions that are answered for the first time and not yet removed from a
    // task or queue. Only they justify a search of all workers' ranges.
    std::uint64_t sought = rest.count() - std::min(rest.count(), answers.repeated);
    const auto are_found = [&](std::uint64_t count) { sought -= std::min(sought, count); };
    const Assignment named{answers.worker, answers.task};
    const TaskInFlight* const task = find(named);
    if (task != nullptr && task->job == job.id) {
        const std::uint64_t cost_before = task->cost_ns;
        PositionSet found = answer_in(job, named, answers.worker, rest, relieved);
        learn(job, answers, cost_before - task->cost_ns);
        const auto call_off = [&](const Assignment& at) {
            PositionSet there = answer_in(job, at, answers.worker, rest, relieved);
            found.add(there);
            if (!there.is_empty()) {
                actions.push_back(CallOff{at.worker, at.task, std::move(there)});
            }
        };
        call_off(task->shared.original);
        std::ranges::for_each(task->shared.copies, call_off);
        if (task->is_analysed) {
            for (const std::uint64_t position : found.list()) {
                job.scenarios.erase(position);
            }
        }
        rest.remove(found);
        are_found(found.count());
    }
    if (rest.is_empty()) {
        return relieved;
    }
    const std::uint64_t unsent_before = job.unsent.rest();
    const PositionSet unanalysed = answer_elsewhere(job, answers.worker, rest, relieved);
    are_found(rest.count() - unanalysed.count() + unsent_before - job.unsent.rest());
    if (sought != 0 && !unanalysed.is_empty()) {
        answer_in_ranges(job, answers.worker, unanalysed, relieved);
    }
    return relieved;
}

PositionSet TaskTable::answer_in(DispatchJob& job,
                                 const Assignment& at,
                                 WorkerId by,
                                 const PositionSet& positions,
                                 Relieved& relieved) {
    const TaskInFlight* const task = find(at);
    if (task == nullptr || task->job != job.id) {
        return {};
    }
    PositionSet found = task->positions.common_with(positions);
    if (found.is_empty()) {
        return found;
    }
    WorkerProxy& proxy = pool_.at(at.worker);
    const bool is_own = at.worker == by;
    if (!mutated(is_own ? Mutation::AnswerLeftAtWorker : Mutation::CopyLeftAtWorker)) {
        take_from(proxy, at.task, job, found);
    }
    relieved.workers.insert(at.worker);
    if (!is_own) {
        return found;
    }
    proxy.tasks.note_answers(found.count(), pace_.now());
    if (task->is_analysed) {
        for (const std::uint64_t position : found.list()) {
            for (const TreeRoots& side : job.at(position).roots) {
                plan_.arrived(proxy.slot(), side.tree, side.roots);
            }
        }
    }
    return found;
}

PositionSet TaskTable::answer_elsewhere(DispatchJob& job,
                                        WorkerId by,
                                        const PositionSet& positions,
                                        Relieved& relieved) {
    PositionSet unanalysed;
    for (const std::uint64_t position : positions.list()) {
        const auto found = job.scenarios.find(position);
        if (found == job.scenarios.end()) {
            unanalysed.add({position, 1});
            continue;
        }
        const DispatchScenario& scenario = found->second;
        if (scenario.where == Whereabouts::Sent) {
            const PositionRange alone{position, 1};
            answer_in(job, scenario.at, by, alone, relieved);
            for (const Assignment& copy : find(scenario.at)->shared.copies) {
                answer_in(job, copy, by, alone, relieved);
            }
        } else {
            if (scenario.where == Whereabouts::Buffered) {
                pool_.at(scenario.at.worker).buffers.remove(job.id, position, scenario.weight);
            }
            queue_.remove(job, position, scenario);
            relieved.any_unsent = true;
        }
        job.scenarios.erase(found);
    }
    if (!unanalysed.is_empty()) {
        relieved.any_unsent = job.unsent.remove(unanalysed) || relieved.any_unsent;
    }
    return unanalysed;
}

void TaskTable::answer_in_ranges(DispatchJob& job,
                                 WorkerId by,
                                 const PositionSet& positions,
                                 Relieved& relieved) {
    for (const WorkerProxy* proxy : pool_.in_order()) {
        for (const auto& [id, task] : proxy->tasks.all()) {
            if (!task.is_analysed) {
                answer_in(job, {proxy->id(), id}, by, positions, relieved);
            }
        }
    }
}

void TaskTable::learn(DispatchJob& job, const Answers& answers, std::uint64_t cost_ns) {
    WorkerProxy& proxy = pool_.at(answers.worker);
    if (proxy.tasks.at(answers.task).is_analysed) {
        pace_.add_work(proxy, cost_ns, answers.busy_seconds);
    } else {
        const std::uint64_t count = answers.positions.count();
        job.range_pace.add(answers.worker, count, answers.busy_seconds);
        job.missing.ranges_answered(count);
    }
    queue_.order().answered(job.id, cost_ns, answers.busy_seconds, pace_.now());
    proxy.tasks.note_busy(answers.task, answers.busy_seconds);
}

void TaskTable::take_from(WorkerProxy& proxy,
                          TaskId task,
                          const DispatchJob& job,
                          const PositionSet& positions) {
    const std::uint64_t cost_ns = cost_of(job, proxy.tasks.at(task), positions);
    proxy.tasks.remove(task, positions, cost_ns);
    queue_.order().left(job.id, cost_ns);
}

// ---- Ends ---------------------------------------------------------------------------------------

TaskInFlight TaskTable::end(WorkerProxy& proxy, TaskId task, LostWith lost_with, Actions& actions) {
    TaskInFlight ended = proxy.tasks.end(task);
    queue_.order().left(ended.job, ended.cost_ns);
    if (const PendingRecall* asked = recalls_.find(proxy.id());
        asked != nullptr && asked->task == task) {
        recalls_.remove(proxy.id());
    }
    if (DispatchJob* job = queue_.find(ended.job)) {
        requeue(*job, ended, unshared(*job, ended, ended.positions), lost_with, actions);
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

PositionSet TaskTable::unshared(DispatchJob& job, const TaskInFlight& left, PositionSet positions) {
    const auto leave_to = [&](const Assignment& at) {
        const TaskInFlight* const other = find(at);
        if (other == nullptr) {
            return;
        }
        const PositionSet there = positions.common_with(other->positions);
        if (left.is_analysed) {
            for (const std::uint64_t position : there.list()) {
                job.at(position).at = at;
            }
        }
        positions.remove(there);
    };
    if (!mutated(Mutation::CopyIsAlone)) {
        leave_to(left.shared.original);
        std::ranges::for_each(left.shared.copies, leave_to);
    }
    return positions;
}

void TaskTable::requeue(DispatchJob& job,
                        const TaskInFlight& left,
                        const PositionSet& positions,
                        LostWith lost_with,
                        Actions& actions) {
    if (positions.is_empty()) {
        return;
    }
    if (left.is_analysed) {
        return requeue_analysed(job, positions, lost_with, actions);
    }
    job.copies.remove_work(pace_.mean_cost_of(positions.count()));
    if (mutated(Mutation::LostRangeForgotten)) {
        return;
    }
    if (lost_with) {
        actions.push_back(PositionsLost{job.id, positions, false, *lost_with});
    } else {
        job.unsent.put_back(positions, left.window);
    }
}

void TaskTable::requeue_analysed(DispatchJob& job,
                                 const PositionSet& positions,
                                 LostWith lost_with,
                                 Actions& actions) {
    std::vector<std::uint64_t> again;
    PositionSet lost;
    for (const std::uint64_t position : positions.list()) {
        if (mutated(lost_with ? Mutation::LostLeaseForgotten : Mutation::DrainedWorkForgotten)) {
            job.scenarios.erase(position);
            continue;
        }
        DispatchScenario& scenario = job.at(position);
        if (lost_with) {
            scenario.losses.add(*lost_with);
        }
        if (scenario.is_lost_for_good()) {
            job.scenarios.erase(position);
            actions.push_back(GiveUp{job.id, position});
            continue;
        }
        if (lost_with) {
            lost.add({position, 1});
        }
        if (!queue_.suspect(job, position, scenario)) {
            again.push_back(position);
        }
    }
    queue_.put_back_sent(job, again);
    if (!lost.is_empty()) {
        actions.push_back(PositionsLost{job.id, std::move(lost), true, *lost_with});
    }
}

std::uint64_t
TaskTable::cost_of(const DispatchJob& job, const TaskInFlight& task, const PositionSet& positions) {
    std::uint64_t cost_ns = 0;
    if (task.is_analysed) {
        for (const std::uint64_t position : positions.list()) {
            cost_ns += job.at(position).weight.cost_ns;
        }
    } else if (positions.count() == task.left()) {
        cost_ns = task.cost_ns;
    } else {
        const auto share =
            static_cast<double>(positions.count()) / static_cast<double>(task.left());
        cost_ns = static_cast<std::uint64_t>(share * static_cast<double>(task.cost_ns));
    }
    return cost_ns;
}

std::uint64_t TaskTable::owed(const Assignment& task) const {
    const TaskInFlight* const found = find(task);
    return found == nullptr || pool_.find(task.worker)->is_draining() ? 0 : found->left();
}

// ---- Recalls ------------------------------------------------------------------------------------

void TaskTable::ask_back(AskBack ask, WorkerId helper, Actions& actions) {
    recalls_.add(ask.worker, {ask.task, helper, pace_.now()});
    actions.push_back(std::move(ask));
}

void TaskTable::take_recalled(WorkerProxy& proxy,
                              TaskId id,
                              const PositionSet& returned,
                              Actions& actions) {
    // A copy, because `remove` below shrinks the task.
    const TaskInFlight task = proxy.tasks.at(id);
    const PositionSet back = task.positions.common_with(returned);
    DispatchJob* job = queue_.find(task.job);
    if (!back.is_empty() && job != nullptr) {
        if (!mutated(Mutation::RecalledLeftAtWorker)) {
            take_from(proxy, id, *job, back);
        }
        const PositionSet alone = unshared(*job, task, back);
        for (const std::uint64_t position :
             task.is_analysed ? alone.list() : std::vector<std::uint64_t>{}) {
            ++job->at(position).recalls;
        }
        if (!mutated(Mutation::RecalledIsLost)) {
            requeue(*job, task, alone, std::nullopt, actions);
        }
        actions.push_back(UnitsReturned{job->id, back.count()});
    }
    const PendingRecall* asked = recalls_.find(proxy.id());
    if (asked != nullptr && asked->task == id) {
        if (back.is_empty()) {
            proxy.tasks.set_begun(id);
        }
        recalls_.remove(proxy.id());
    }
}

} // namespace cd
