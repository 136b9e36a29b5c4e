#include "master/dispatch/dispatcher.hpp"

#include "common/core/check.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/dispatch_parts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace cd {

Dispatcher::Dispatcher(const DispatcherOptions& options) : options_(options) {}

Actions Dispatcher::settled(Actions actions) {
    settled_ = parts().pace.now();
    parts().allocator.settle(actions);
    parts().rebalancer.rebalance(actions);
    parts().ranges.give(actions);
    if (options_.helps_at_end) {
        parts().endgame.help(options_.look_seconds(parts().pool.in_order().size()), actions);
    }
    return actions;
}

Actions Dispatcher::refilled(WorkerProxy& proxy, Actions actions) {
    parts().allocator.refill(proxy, actions);
    parts().ranges.give_to(proxy, actions);
    return actions;
}

WorkerProxy* Dispatcher::worker_with(WorkerId worker, TaskId task) {
    WorkerProxy* proxy = parts().pool.find(worker);
    return proxy != nullptr && proxy->tasks.contains(task) ? proxy : nullptr;
}

bool Dispatcher::is_due() const {
    return parts().pace.now() >= settled_ + options_.look_seconds(parts().pool.in_order().size());
}

// ---- Workers ----------------------------------------------------------------------------------

Actions Dispatcher::worker_joined(WorkerId worker, const WorkerFacts& facts) {
    CD_CHECK(facts.threads > 0);
    CD_CHECK(facts.weight > 0);
    parts().pool.add(worker, facts);
    return settled({});
}

Actions Dispatcher::worker_lost(WorkerId worker) {
    WorkerProxy* proxy = parts().pool.find(worker);
    if (proxy == nullptr) {
        return {};
    }
    Actions actions;
    parts().allocator.take_back_buffers(*proxy);
    parts().tasks.lose_all(*proxy, actions);
    for (auto& [id, job] : parts().queue.jobs()) {
        job.range_pace.forget(worker);
    }
    parts().pool.remove(worker);
    return settled(std::move(actions));
}

Actions Dispatcher::worker_draining(WorkerId worker) {
    WorkerProxy* proxy = parts().pool.find(worker);
    if (proxy == nullptr) {
        return {};
    }
    proxy->set_draining();
    parts().allocator.take_back_buffers(*proxy);
    return settled({});
}

Actions Dispatcher::worker_silent(WorkerId worker) {
    WorkerProxy* proxy = parts().pool.find(worker);
    if (proxy == nullptr || proxy->is_silent()) {
        return {};
    }
    proxy->set_silent(true);
    parts().tasks.forget_recall(worker); // The recall or its answer may be lost.
    parts().allocator.take_back_buffers(*proxy);
    return settled({});
}

Actions Dispatcher::worker_heard(WorkerId worker) {
    WorkerProxy* proxy = parts().pool.find(worker);
    if (proxy == nullptr || !proxy->is_silent() || mutated(Mutation::HeardAgainForgotten)) {
        return {};
    }
    proxy->set_silent(false);
    return settled({});
}

// ---- Jobs ---------------------------------------------------------------------------------------

Actions
Dispatcher::job_opened(JobId job, const ClusterOptions& options, DispatchTree a, DispatchTree b) {
    CD_CHECK(options.q > 0);
    parts().pool.add_tree(a);
    parts().pool.add_tree(b);
    parts().queue.open(job,
                       options,
                       std::move(a),
                       std::move(b),
                       make_policy(options, parts().context, options_.strategies));
    return {};
}

Actions Dispatcher::scenario_analysed(JobId job_id, AnalysedScenario analysed) {
    WorkQueue& queue = parts().queue;
    DispatchJob* job = queue.find(job_id);
    CD_CHECK(job != nullptr);
    DispatchScenario scenario = job->scenario_of(analysed);
    if (scenario.is_lost_for_good()) {
        return {
            GiveUp{job_id, analysed.index}}; // The last incarnation ended before it gave this up.
    }
    job->copies.add_work(scenario.weight.cost_ns);
    job->places.nothing_follows();
    parts().pace.add_scenario(scenario.weight.cost_ns);
    const bool is_suspect = queue.add(*job, analysed.index, std::move(scenario));
    const bool resumes = queue.set_paused(false);

    Actions actions;
    parts().allocator.take_up(*job, is_suspect, resumes, actions);
    return actions;
}

Actions Dispatcher::input_paused() {
    const bool was_paused = parts().queue.set_paused(true);
    return was_paused && !is_due() ? Actions{} : settled({});
}

Actions Dispatcher::places_given(JobId job_id, const PlaceRange& places, std::uint64_t after) {
    DispatchJob* job = parts().queue.find(job_id);
    CD_CHECK(job != nullptr);
    job->places.add(places, after);
    Actions actions;
    parts().ranges.give(actions);
    return actions;
}

std::vector<PlaceRange> Dispatcher::take_places(JobId job_id) {
    DispatchJob* job = parts().queue.find(job_id);
    CD_CHECK(job != nullptr);
    return job->places.take_all();
}

Actions Dispatcher::job_closed(JobId job_id) {
    WorkQueue& queue = parts().queue;
    const DispatchJob* job = queue.find(job_id);
    if (job == nullptr) {
        return {};
    }
    for (WorkerProxy* proxy : parts().pool.in_order()) {
        queue.leave(proxy->buffers.take(job_id).scenarios.size());
        proxy->tasks.forget_scenarios(job_id);
    }
    const TreeId tree_a = job->a.tree;
    const TreeId tree_b = job->b.tree;
    queue.close(job_id);
    for (const TreeId tree : {tree_a, tree_b}) {
        if (!queue.is_tree_used(tree)) {
            parts().pool.remove_tree(tree);
        }
    }
    return settled({});
}

// ---- Answers and tasks --------------------------------------------------------------------------

Actions Dispatcher::scenario_answered(WorkerId worker, JobId job_id, std::uint64_t index) {
    DispatchJob* job = parts().queue.find(job_id);
    if (job == nullptr) {
        return {};
    }
    const auto found = job->scenarios.find(index);
    if (found == job->scenarios.end()) {
        return {};
    }
    WorkerPool& pool = parts().pool;
    const bool was_sent = found->second.where == Whereabouts::Sent;
    const WorkerId holder = found->second.worker;
    const std::optional<Assignment> copy = found->second.copy;
    if (was_sent && (holder == worker || (copy && copy->worker == worker))) {
        WorkerProxy& proxy = pool.at(worker);
        pool.arrived(proxy, job->a.tree, found->second.roots.a);
        pool.arrived(proxy, job->b.tree, found->second.roots.b);
        proxy.tasks.note_progress(parts().pace.now());
    }
    Actions actions;
    parts().tasks.withdraw(*job, index, found->second, worker, actions);
    job->scenarios.erase(found);
    if (!was_sent) {
        return settled(std::move(actions));
    }
    // Only the scenario's workers can take more now, since their load has decreased.
    actions = refilled(pool.at(holder), std::move(actions));
    return copy ? refilled(pool.at(copy->worker), std::move(actions)) : actions;
}

Actions Dispatcher::places_answered(WorkerId worker,
                                    TaskId task,
                                    std::uint64_t count,
                                    double busy_seconds) {
    WorkerProxy* proxy = worker_with(worker, task);
    if (proxy == nullptr) {
        return {};
    }
    const TaskInFlight& content = proxy->tasks.at(task);
    if (DispatchJob* job = parts().queue.find(content.job)) {
        job->range_pace.add(worker, count, busy_seconds);
        job->missing.ranges_answered(count);
    }
    proxy->tasks.note_busy(task, busy_seconds);
    proxy->tasks.note_progress(parts().pace.now());
    proxy->tasks.answer_places(task, std::min(count, content.places_left));
    return refilled(*proxy, {});
}

Actions Dispatcher::task_ended(WorkerId worker, TaskId task) {
    WorkerProxy* proxy = worker_with(worker, task);
    if (proxy == nullptr) {
        return {};
    }
    Actions actions;
    // The worker is alive, so the unanswered scenarios did not kill it.
    const TaskInFlight ended = parts().tasks.end(*proxy, task, std::nullopt, actions);
    const bool has_successor = !proxy->tasks.all().empty();
    proxy->batch.judge(ended, has_successor, proxy->facts().threads, parts().pace.now());
    return is_due() || parts().queue.something_waits() ? settled(std::move(actions))
                                                       : refilled(*proxy, std::move(actions));
}

Actions Dispatcher::task_unbegun(WorkerId worker, TaskId task) {
    WorkerProxy* proxy = worker_with(worker, task);
    if (proxy == nullptr) {
        return {};
    }
    Actions actions;
    parts().tasks.end(*proxy, task, std::nullopt, actions);
    return settled(std::move(actions));
}

Actions Dispatcher::task_recalled(WorkerId worker, const Recalled& recalled) {
    WorkerProxy* proxy = worker_with(worker, recalled.task);
    if (proxy == nullptr) {
        return {};
    }
    Actions actions;
    parts().tasks.take_recalled(*proxy, recalled, actions);
    return settled(std::move(actions));
}

// ---- Blocks and measurements --------------------------------------------------------------------

void Dispatcher::roots_wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    WorkerProxy* proxy = parts().pool.find(worker);
    if (proxy != nullptr && parts().queue.is_tree_used(tree)) {
        parts().blocks.hold_wanted(parts().queue, *proxy, tree, roots);
    }
}

Actions Dispatcher::roots_evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    if (WorkerProxy* proxy = parts().pool.find(worker)) {
        parts().pool.release(*proxy, tree, roots);
    }
    return {};
}

void Dispatcher::roots_arrived(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    if (const WorkerProxy* proxy = parts().pool.find(worker)) {
        parts().pool.arrived(*proxy, tree, roots);
    }
}

void Dispatcher::time_is(double seconds) {
    parts().pace.time_is(seconds);
}

void Dispatcher::work_measured(WorkerId worker, const MeasuredWork& work) {
    if (WorkerProxy* proxy = parts().pool.find(worker)) {
        parts().pace.add_work(*proxy, work);
    }
}

void Dispatcher::transfer_measured(WorkerId worker, std::uint64_t bytes, double seconds) {
    if (WorkerProxy* proxy = parts().pool.find(worker)) {
        parts().pace.add_transfer(*proxy, bytes, seconds);
    }
}

} // namespace cd
