#include "master/dispatch/view/dispatch_invariants.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <vector>

namespace cd {

namespace {

std::uint64_t cost_of(const DispatchJob& job, std::span<const std::uint64_t> positions) {
    std::uint64_t cost_ns = 0;
    for (const std::uint64_t position : positions) {
        cost_ns += job.at(position).weight.cost_ns;
    }
    return cost_ns;
}

/// Checks a copy against its original, and returns the number of positions that both have.
std::uint64_t
check_copy(const DispatchParts& parts, const WorkerProxy& at, const TaskInFlight& copy) {
    const TaskInFlight* original = parts.tasks.find(copy.shared.original);
    if (original == nullptr) {
        return 0; // The task is no copy, or its original has ended.
    }
    const PositionSet both = copy.positions.common_with(original->positions);
    CD_CHECK(copy.shared.original.worker != at.id());
    CD_CHECK(original->job == copy.job);
    CD_CHECK(original->is_analysed == copy.is_analysed);
    CD_CHECK(both.common_with(original->shared.copied) == both);
    return both.count();
}

/// Checks that each position of the job is in one place, apart from copies.
void check_positions(const DispatchParts& parts, const DispatchJob& job) {
    std::uint64_t known = job.scenarios.size();
    std::uint64_t placed = job.waiting.size();
    PositionSet unanalysed;
    std::uint64_t in_ranges = job.unsent.count();
    for (const PositionRange& range : job.unsent.all()) {
        CD_CHECK(range.count != 0);
        unanalysed.add(range);
    }
    placed += static_cast<std::uint64_t>(
        std::ranges::count(parts.queue.suspects(), job.id, &Suspect::job));
    for (const auto& [id, proxy] : parts.pool.all()) {
        placed += proxy.buffers.of(job.id).scenarios.size();
        for (const auto& [task_id, task] : proxy.tasks.all()) {
            if (task.job == job.id) {
                (task.is_analysed ? placed : in_ranges) += task.left();
                (task.is_analysed ? placed : in_ranges) -= check_copy(parts, proxy, task);
                unanalysed.add(task.is_analysed ? PositionSet() : task.positions);
            }
        }
    }
    // `check_job` finds each scenario in its place. The counts match as well, so none is in two.
    CD_CHECK(known == placed);
    const std::uint64_t ranges_hold_each_position_once = unanalysed.count();
    CD_CHECK(ranges_hold_each_position_once == in_ranges);
}

void check_unsent(const DispatchParts& parts) {
    std::uint64_t not_sent = parts.queue.suspects().size();
    std::uint64_t of_jobs = 0;
    for (const auto& [id, job] : parts.queue.jobs()) {
        not_sent += job.waiting.size();
        of_jobs += job.input.unsent;
    }
    CD_CHECK(of_jobs == parts.queue.unsent());
    for (const auto& [id, proxy] : parts.pool.all()) {
        not_sent += proxy.buffers.count();
    }
    const std::uint64_t unsent = parts.queue.unsent();
    CD_CHECK(unsent == not_sent);
}

void check_job(const DispatchParts& parts, const DispatchJob& job) {
    check_positions(parts, job);
    std::vector<std::uint64_t> waiting(job.waiting.begin(), job.waiting.end());
    std::ranges::sort(waiting); // Linear search would cost quadratic time.
    CD_CHECK(std::ranges::adjacent_find(waiting) == waiting.end());
    for (const auto& [position, scenario] : job.scenarios) {
        CD_CHECK(scenario.losses.count() < limits::scenario_losses_max);
        switch (scenario.where) {
        case Whereabouts::Waiting:
            CD_CHECK(std::ranges::binary_search(waiting, position));
            break;
        case Whereabouts::Suspect:
            CD_CHECK(std::any_of(parts.queue.suspects().begin(),
                                 parts.queue.suspects().end(),
                                 [&, wanted = position](const Suspect& suspect) {
                                     return suspect.job == job.id && suspect.position == wanted;
                                 }));
            break;
        case Whereabouts::Buffered: {
            const WorkerProxy* proxy = parts.pool.find(scenario.at.worker);
            CD_CHECK(proxy != nullptr);
            CD_CHECK(std::ranges::count(proxy->buffers.of(job.id).scenarios, position) == 1);
            break;
        }
        case Whereabouts::Sent: {
            const TaskInFlight* task = parts.tasks.find(scenario.at);
            CD_CHECK(task != nullptr);
            CD_CHECK(task->is_analysed && task->positions.contains(position));
            break;
        }
        }
    }
}

/// Checks that the order of jobs counts the tasks of each job.
void check_order(const DispatchParts& parts) {
    std::map<JobId, std::uint64_t> in_flight_ns;
    for (const auto& [id, proxy] : parts.pool.all()) {
        for (const auto& [task_id, task] : proxy.tasks.all()) {
            in_flight_ns[task.job] += task.cost_ns;
        }
    }
    for (const auto& [id, job] : parts.queue.jobs()) {
        CD_CHECK(parts.queue.order().in_flight_ns(id) == in_flight_ns[id]);
    }
}

void check_recalls(const DispatchParts& parts) {
    for (const auto& [worker, recall] : parts.tasks.recalls().all()) {
        const WorkerProxy* proxy = parts.pool.find(worker);
        CD_CHECK(proxy != nullptr);
        CD_CHECK(proxy->tasks.find(recall.task) != nullptr);
        CD_CHECK(!proxy->is_silent());
    }
}

/// True if several jobs share the workers, and this one has work for all its threads. A job may
/// then have to wait with its next task.
bool is_kept_busy(const DispatchParts& parts, const WorkerProxy& proxy) {
    return parts.queue.jobs().size() > 1 && proxy.tasks.left() >= proxy.facts().threads;
}

void check_worker(const DispatchParts& parts, const WorkerProxy& proxy) {
    std::uint64_t cost_ns = 0;
    std::uint64_t buffered = 0;
    for (const auto& [id, buffer] : proxy.buffers.all()) {
        CD_CHECK(parts.queue.find(id) != nullptr);
        CD_CHECK(!buffer.scenarios.empty());
        const DispatchJob& job = parts.queue.at(id);
        CD_CHECK(buffer.scenarios.size() <= job.policy->bounds(proxy, job).buffered);
        CD_CHECK(buffer.cost_ns == cost_of(job, buffer.scenarios));
        cost_ns += buffer.cost_ns;
        // All ripe buffers have been sent, unless tasks of another job keep the worker busy.
        CD_CHECK(!parts.filler.is_ripe(proxy, job) || is_kept_busy(parts, proxy));
        buffered += buffer.scenarios.size();
    }
    CD_CHECK(buffered == proxy.buffers.count());
    CD_CHECK(proxy.takes_work() || buffered == 0);

    std::uint64_t working = 0;
    std::uint64_t working_ns = 0;
    std::size_t claiming = 0;
    for (const auto& [id, task] : proxy.tasks.all()) {
        CD_CHECK(id <= parts.tasks.last());
        working += task.left();
        claiming += task.claims ? 1 : 0;
        CD_CHECK(!task.is_analysed || task.left() == 0 ||
                 task.cost_ns == cost_of(parts.queue.at(task.job), task.positions.list()));
        CD_CHECK(task.left() != 0 || task.cost_ns == 0);
        working_ns += task.cost_ns;
    }
    CD_CHECK(working_ns == proxy.tasks.cost_ns());
    CD_CHECK(cost_ns + working_ns == proxy.backlog_ns());
    CD_CHECK(working == proxy.tasks.left());
    CD_CHECK(claiming <= 1);
    CD_CHECK((claiming == 1) == proxy.is_claimed());
}

/// Bounds the work at a worker: a job has at most the allowed number of unanswered tasks there or,
/// if that is more, one for each of the worker's threads.
void check_flight(const DispatchParts& parts, const WorkerProxy& proxy) {
    std::map<JobId, std::size_t> unanswered;
    for (const auto& [id, task] : proxy.tasks.all()) {
        if (task.left() == 0) {
            continue; // Fully answered; the worker's end message is under way.
        }
        const DispatchJob& job = parts.queue.at(task.job);
        const std::uint64_t batch_max = job.policy->bounds(proxy, job).batch;
        CD_CHECK(task.left() <= (task.is_analysed ? batch_max : limits::range_scenarios_max));
        ++unanswered[task.job];
    }
    for (const auto& [id, tasks] : unanswered) {
        const DispatchJob& job = parts.queue.at(id);
        const std::size_t tasks_max = job.policy->bounds(proxy, job).tasks;
        CD_CHECK(tasks <= std::max<std::size_t>(tasks_max, proxy.facts().threads));
    }
}

void check_progress(const DispatchParts& parts) {
    parts.ranges.forget_totals();
    for (const auto& [id, proxy] : parts.pool.all()) {
        if (!proxy.takes_work()) {
            continue;
        }
        CD_CHECK(parts.queue.suspects().empty() || !proxy.is_idle());
        for (const auto& [job_id, job] : parts.queue.jobs()) {
            // A worker may still want a range, because range sizes change with the load of others.
            // Some worker must have a task then.
            CD_CHECK(!parts.ranges.would_take(proxy, job) ||
                     std::ranges::any_of(parts.pool.all(), [](const auto& one) {
                         return !one.second.tasks.all().empty();
                     }));
            CD_CHECK(!job.policy->can_pull(proxy, job) || is_kept_busy(parts, proxy));
        }
    }
    for (const auto& [id, job] : parts.queue.jobs()) {
        CD_CHECK(job.waiting.empty() ||
                 job.policy->would_choose(job, job.at(job.waiting.front())) == nullptr);
    }
}

} // namespace

void check_invariants_of(const DispatchParts& parts) {
    check_unsent(parts);
    parts.pool.check();
    parts.plan.check(parts.pool.slots_taken());
    for (const auto& [id, job] : parts.queue.jobs()) {
        check_job(parts, job);
    }
    for (const auto& [id, proxy] : parts.pool.all()) {
        check_worker(parts, proxy);
        check_flight(parts, proxy);
    }
    check_order(parts);
    check_recalls(parts);
    check_progress(parts);
}

} // namespace cd
