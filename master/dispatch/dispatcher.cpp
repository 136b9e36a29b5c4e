#include "master/dispatch/dispatcher.hpp"

#include "common/core/check.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/dispatch_parts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// True if there are several jobs, scenarios wait, and there are more than `before` actions: one
/// job's turn may have emptied a buffer of another, which has room for waiting scenarios now.
bool made_room(const WorkQueue& queue, const Actions& actions, std::size_t before) {
    return actions.size() != before && queue.jobs().size() > 1 && queue.something_waits();
}

} // namespace

Dispatcher::Dispatcher(const DispatcherOptions& options) : options_(options) {}

Actions Dispatcher::settled(Actions actions) {
    settled_ = parts().pace.now();
    std::size_t before = 0;
    do {
        before = actions.size();
        parts().ranges.forget_totals();
        parts().allocator.settle(actions);
        parts().rebalancer.rebalance(actions);
        parts().filler.give_ranges(actions);
    } while (made_room(parts().queue, actions, before));
    if (options_.helps_at_end) {
        parts().endgame.help(options_.look_seconds(parts().pool.in_order().size()), actions);
    }
    return actions;
}

Actions Dispatcher::refilled(WorkerProxy& proxy, Actions actions) {
    const std::size_t before = actions.size();
    parts().ranges.age_totals();
    parts().filler.fill(proxy, actions);
    return made_room(parts().queue, actions, before) ? settled(std::move(actions)) : actions;
}

Actions Dispatcher::settled_or_refilled(WorkerProxy& proxy, Actions actions) {
    return is_due() || parts().queue.something_waits() ? settled(std::move(actions))
                                                       : refilled(proxy, std::move(actions));
}

void Dispatcher::count_threads() {
    std::uint64_t threads = 0;
    for (const WorkerProxy* proxy : parts().pool.in_order()) {
        threads += proxy->facts().threads;
    }
    parts().queue.order().set_threads(threads);
}

WorkerProxy* Dispatcher::worker_with(WorkerId worker, TaskId task) {
    WorkerProxy* proxy = parts().pool.find(worker);
    return proxy != nullptr && proxy->tasks.find(task) != nullptr ? proxy : nullptr;
}

bool Dispatcher::is_due() const {
    return parts().pace.now() >= settled_ + options_.look_seconds(parts().pool.in_order().size());
}

// ---- Workers ----------------------------------------------------------------------------------

Actions Dispatcher::worker_joined(WorkerId worker, const WorkerFacts& facts) {
    CD_CHECK(facts.threads > 0);
    CD_CHECK(facts.weight > 0);
    WorkerProxy& joined = parts().pool.add(worker, facts);
    parts().plan.join(joined.slot());
    count_threads();
    return settled_or_refilled(joined, {});
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
    parts().plan.leave(proxy->slot());
    parts().pool.remove(worker);
    count_threads();
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
    parts().tasks.forget_recall(worker); // An open recall or its answer may be lost.
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

Actions Dispatcher::job_opened(JobId job,
                               const ClusterOptions& options,
                               DispatchTrees trees,
                               JobRank rank) {
    CD_CHECK(options.q > 0);
    for (const auto& tree : trees.distinct()) {
        parts().plan.add_tree(*tree);
    }
    parts().queue.open(job,
                       options,
                       std::move(trees),
                       make_policy(options, parts().context, options_.strategies),
                       std::move(rank));
    return {};
}

Actions Dispatcher::job_ranked(JobId job, std::int32_t priority) {
    parts().queue.set_priority(job, priority);
    return settled({});
}

void Dispatcher::analysis_took(JobId job, std::uint64_t positions, double seconds) {
    constexpr std::uint64_t position_ns = 1000; // Unless measured.
    parts().queue.analysis_order().answered(
        job, positions * position_ns, seconds, parts().pace.now());
}

Actions Dispatcher::scenario_analysed(JobId job_id, AnalysedScenario analysed) {
    WorkQueue& queue = parts().queue;
    DispatchJob* job = queue.find(job_id);
    CD_CHECK(job != nullptr);
    DispatchScenario scenario = job->scenario_of(analysed);
    if (scenario.is_lost_for_good()) {
        // The master's last incarnation ended before it gave the scenario up.
        return {GiveUp{job_id, analysed.position}};
    }
    job->copies.add_work(scenario.weight.cost_ns);
    job->unsent.nothing_follows();
    parts().pace.add_scenario(scenario.weight.cost_ns);
    const bool is_suspect = queue.add(*job, analysed.position, std::move(scenario));
    const bool resumes = queue.set_paused(false);
    job->input.is_paused = false;

    Actions actions;
    parts().ranges.age_totals();
    parts().allocator.take_up(*job, is_suspect, resumes, actions);
    return made_room(parts().queue, actions, 0) ? settled(std::move(actions)) : actions;
}

Actions Dispatcher::input_paused() {
    const bool was_paused = parts().queue.set_paused(true);
    return was_paused && !is_due() ? Actions{} : settled({});
}

Actions Dispatcher::job_input_paused(JobId job_id) {
    DispatchJob& job = parts().queue.at(job_id);
    Actions actions;
    if (!std::exchange(job.input.is_paused, true) && job.input.unsent != 0) {
        parts().ranges.forget_totals();
        for (WorkerProxy* proxy : parts().pool.in_order()) {
            parts().filler.fill(*proxy, actions);
        }
    }
    return made_room(parts().queue, actions, 0) ? settled(std::move(actions)) : actions;
}

Actions Dispatcher::positions_given(JobId job_id, GivenRange given, std::uint64_t after) {
    DispatchJob* job = parts().queue.find(job_id);
    CD_CHECK(job != nullptr);
    job->unsent.add(std::move(given), after);
    Actions actions;
    parts().filler.give_ranges(actions);
    return made_room(parts().queue, actions, 0) ? settled(std::move(actions)) : actions;
}

std::vector<PositionRange> Dispatcher::take_positions(JobId job_id) {
    DispatchJob* job = parts().queue.find(job_id);
    CD_CHECK(job != nullptr);
    return job->unsent.take_all();
}

Actions Dispatcher::job_closed(JobId job_id) {
    WorkQueue& queue = parts().queue;
    DispatchJob* job = queue.find(job_id);
    if (job == nullptr) {
        return {};
    }
    for (WorkerProxy* proxy : parts().pool.in_order()) {
        queue.leave(*job, proxy->buffers.take(job_id).scenarios.size());
        proxy->tasks.forget_positions(job_id);
    }
    const DispatchTrees trees = job->trees;
    queue.close(job_id);
    for (const auto& tree : trees.distinct()) {
        if (!queue.is_tree_used(tree->tree)) {
            parts().plan.remove_tree(tree->tree);
        }
    }
    return settled({});
}

// ---- Answers and tasks --------------------------------------------------------------------------

Actions Dispatcher::answered(const Answers& answers) {
    DispatchJob* job = parts().queue.find(answers.job);
    if (job == nullptr) {
        return {};
    }
    Actions actions;
    const TaskTable::Relieved relieved = parts().tasks.answer(*job, answers, actions);
    if (relieved.any_unsent) {
        return settled(std::move(actions));
    }
    // Only the relieved workers can take more now, since their load has decreased.
    for (const WorkerId worker : relieved.workers) {
        actions = refilled(parts().pool.at(worker), std::move(actions));
    }
    return actions;
}

Actions Dispatcher::task_ended(WorkerId worker, TaskId task) {
    WorkerProxy* proxy = worker_with(worker, task);
    if (proxy == nullptr) {
        return {};
    }
    Actions actions;
    // The worker is alive, so the unanswered positions did not kill it.
    const TaskInFlight ended = parts().tasks.end(*proxy, task, std::nullopt, actions);
    const bool has_successor = !proxy->tasks.all().empty();
    proxy->batch.judge(ended, has_successor, proxy->facts().threads, parts().pace.now());
    return settled_or_refilled(*proxy, std::move(actions));
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

Actions Dispatcher::task_recalled(WorkerId worker, TaskId task, const PositionSet& returned) {
    WorkerProxy* proxy = worker_with(worker, task);
    if (proxy == nullptr) {
        return {};
    }
    const PendingRecall* recall = parts().tasks.recalls().find(worker);
    WorkerProxy* helper = recall == nullptr ? nullptr : parts().pool.find(recall->helper);
    Actions actions;
    parts().tasks.take_recalled(*proxy, task, returned, actions);
    return settled_or_refilled(helper == nullptr ? *proxy : *helper, std::move(actions));
}

// ---- Blocks and measurements --------------------------------------------------------------------

void Dispatcher::roots_wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    WorkerProxy* proxy = parts().pool.find(worker);
    if (proxy != nullptr && parts().queue.is_tree_used(tree)) {
        proxy->batch.note_blocks(parts().pace.now());
        parts().blocks.hold_wanted(parts().queue, *proxy, tree, roots);
    }
}

Actions Dispatcher::roots_evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    if (const WorkerProxy* proxy = parts().pool.find(worker)) {
        parts().plan.release(proxy->slot(), tree, roots);
    }
    return {};
}

void Dispatcher::roots_arrived(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    if (WorkerProxy* proxy = parts().pool.find(worker)) {
        proxy->batch.note_blocks(parts().pace.now());
        parts().plan.arrived(proxy->slot(), tree, roots);
    }
}

void Dispatcher::time_is(double seconds) {
    parts().pace.time_is(seconds);
}

void Dispatcher::transfer_measured(WorkerId worker, std::uint64_t bytes, double seconds) {
    if (WorkerProxy* proxy = parts().pool.find(worker)) {
        parts().pace.add_transfer(*proxy, bytes, seconds);
    }
}

} // namespace cd
