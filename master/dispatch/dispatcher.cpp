// Events of the dispatcher.
#include "master/dispatch/dispatcher.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/dispatcher_state.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

std::vector<WeightedRoot> with_triangles(const DispatchTree& tree,
                                         std::span<const RootIndex> roots) {
    std::vector<WeightedRoot> with;
    with.reserve(roots.size());
    for (const RootIndex root : roots) {
        with.push_back({root, tree.root_triangles.at(root)});
    }
    return with;
}

} // namespace

DispatchScenario make_dispatch_scenario(const DispatchJob& job, const AnalysedScenario& analysed) {
    DispatchScenario scenario;
    scenario.roots = {with_triangles(job.a, analysed.roots_a),
                      with_triangles(job.b, analysed.roots_b)};
    scenario.weight = {analysed.bytes,
                       analysed.predicted_ns != 0 ? analysed.predicted_ns
                                                  : limits::scenario_ns_unknown};
    return scenario;
}

Dispatcher::Dispatcher(const DispatcherOptions& options) : state_(std::make_unique<State>()) {
    state_->options = options;
}
Dispatcher::~Dispatcher() = default;

// ---- Workers ----------------------------------------------------------------------------------

Actions Dispatcher::worker_joined(WorkerId worker, const WorkerFacts& facts) {
    CD_CHECK(facts.threads > 0);
    CD_CHECK(facts.weight > 0);
    state_->pool.add(worker, facts);
    Actions actions;
    state_->settle(actions);
    return actions;
}

Actions Dispatcher::worker_lost(WorkerId worker) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr) {
        return {};
    }
    Actions actions;
    state_->take_back_buffers(*proxy);
    // Newest task first, so that the oldest ends up first in the queue.
    while (!proxy->tasks().empty()) {
        const TaskId task = proxy->tasks().rbegin()->first;
        state_->end_task(task, proxy->end_task(task), proxy->facts().process, actions);
    }
    for (auto& [id, job] : state_->jobs) {
        job.place_rates.erase(worker);
    }
    state_->recalls.erase(worker);
    state_->pool.remove(worker);
    state_->settle(actions);
    return actions;
}

Actions Dispatcher::worker_draining(WorkerId worker) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr) {
        return {};
    }
    proxy->set_draining();
    state_->take_back_buffers(*proxy);
    Actions actions;
    state_->settle(actions);
    return actions;
}

Actions Dispatcher::worker_silent(WorkerId worker) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr || proxy->is_silent()) {
        return {};
    }
    proxy->set_silent(true);
    state_->recalls.erase(worker); // The recall or its answer may be lost.
    state_->take_back_buffers(*proxy);
    Actions actions;
    state_->settle(actions);
    return actions;
}

Actions Dispatcher::worker_heard(WorkerId worker) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr || !proxy->is_silent() || mutated(Mutation::HeardAgainForgotten)) {
        return {};
    }
    proxy->set_silent(false);
    Actions actions;
    state_->settle(actions);
    return actions;
}

Actions Dispatcher::task_unbegun(WorkerId worker, TaskId task) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr || !proxy->tasks().contains(task)) {
        return {};
    }
    Actions actions;
    state_->end_task(task, proxy->end_task(task), std::nullopt, actions);
    state_->settle(actions);
    return actions;
}

Actions Dispatcher::task_recalled(WorkerId worker, const Recalled& recalled) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr || !proxy->tasks().contains(recalled.task)) {
        return {};
    }
    Actions actions;
    state_->take_recalled(*proxy, recalled, actions);
    state_->settle(actions);
    return actions;
}

Actions Dispatcher::task_ended(WorkerId worker, TaskId task) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr || !proxy->tasks().contains(task)) {
        return {};
    }
    const ProxyTask ended = proxy->end_task(task);
    proxy->judge_batch(ended, state_->now);
    Actions actions;
    // The worker is alive, so the unanswered scenarios did not kill it.
    state_->end_task(task, ended, std::nullopt, actions);
    if (state_->is_due(state_->settled) || state_->something_waits()) {
        state_->settle(actions);
    } else {
        state_->refill(*proxy, actions);
    }
    return actions;
}

Actions Dispatcher::roots_evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    if (WorkerProxy* proxy = state_->pool.find(worker)) {
        state_->pool.release(*proxy, tree, roots);
    }
    return {};
}

// ---- Jobs ---------------------------------------------------------------------------------------

Actions
Dispatcher::job_opened(JobId job, const ClusterOptions& options, DispatchTree a, DispatchTree b) {
    CD_CHECK(options.q > 0);
    state_->pool.add_tree(a);
    state_->pool.add_tree(b);
    const bool is_new =
        state_->jobs.try_emplace(job, job, options, std::move(a), std::move(b)).second;
    CD_CHECK(is_new);
    return {};
}

Actions Dispatcher::scenario_analysed(JobId job_id, AnalysedScenario analysed) {
    DispatchJob* job = state_->find_job(job_id);
    CD_CHECK(job != nullptr);
    DispatchScenario scenario = make_dispatch_scenario(*job, analysed);
    scenario.losses = analysed.losses;
    if (State::is_lost_for_good(scenario)) {
        return {GiveUp{job_id, analysed.index}}; // The last incarnation did not give it up in time.
    }
    job->work_ns += scenario.weight.cost_ns;
    job->places_after = 0; // The rest is analysed, or comes with the next range.
    state_->mean_cost_ns.add(static_cast<double>(scenario.weight.cost_ns), 1);
    const auto [place, is_new] = job->scenarios.emplace(analysed.index, std::move(scenario));
    CD_CHECK(is_new);
    ++state_->unsent;
    const bool resumes = std::exchange(state_->input_is_paused, false);

    Actions actions;
    if (state_->suspect(job_id, analysed.index, place->second)) {
        state_->give_suspects(actions);
    } else {
        job->waiting.push_back(analysed.index);
    }
    // If others wait before it, no worker can take a scenario of this job now, and nothing has
    // changed; a pulled job, however, may now have a whole task's worth.
    if (job->waiting.size() == 1 || job->is_pulled()) {
        state_->allocate_one(*job, actions);
    }
    if (resumes) {
        // Buffers held back at the end of a job may go now.
        for (auto& [id, proxy] : state_->pool.all()) {
            state_->flush_ripe(proxy, actions);
        }
    }
    return actions;
}

Actions Dispatcher::input_paused() {
    const bool was_paused = std::exchange(state_->input_is_paused, true);
    Actions actions;
    if (!was_paused || state_->is_due(state_->settled)) {
        state_->settle(actions);
    }
    return actions;
}

Actions Dispatcher::job_closed(JobId job_id) {
    DispatchJob* job = state_->find_job(job_id);
    if (job == nullptr) {
        return {};
    }
    state_->unsent -= job->waiting.size();
    state_->unsent -= std::erase_if(state_->suspects,
                                    [&](const Suspect& suspect) { return suspect.job == job_id; });
    for (auto& [id, proxy] : state_->pool.all()) {
        state_->unsent -= proxy.take_buffer(job_id).scenarios.size();
        for (const auto& [task, content] : proxy.tasks()) {
            if (content.job == job_id) {
                proxy.forget_scenarios(task);
            }
        }
    }
    const TreeId tree_a = job->a.tree;
    const TreeId tree_b = job->b.tree;
    state_->jobs.erase(job_id);
    for (const TreeId tree : {tree_a, tree_b}) {
        if (!state_->is_tree_used(tree)) {
            state_->pool.remove_tree(tree);
        }
    }
    Actions actions;
    state_->settle(actions);
    return actions;
}

Actions Dispatcher::scenario_answered(WorkerId worker, JobId job_id, std::uint64_t index) {
    DispatchJob* job = state_->find_job(job_id);
    if (job == nullptr) {
        return {};
    }
    const auto found = job->scenarios.find(index);
    if (found == job->scenarios.end()) {
        return {};
    }
    const bool was_sent = found->second.where == Whereabouts::Sent;
    const WorkerId holder = found->second.worker;
    const std::optional<Assignment> copy = found->second.copy;
    if (was_sent && (holder == worker || (copy && copy->worker == worker))) {
        WorkerProxy& proxy = state_->pool.at(worker);
        state_->pool.arrived(proxy, job->a.tree, found->second.roots.a);
        state_->pool.arrived(proxy, job->b.tree, found->second.roots.b);
        proxy.note_progress(state_->now);
    }
    Actions actions;
    state_->withdraw(*job, index, found->second, worker, actions);
    job->scenarios.erase(found);
    if (was_sent) {
        // The scenario's workers may run dry now; nothing else can have become possible.
        state_->refill(state_->pool.at(holder), actions);
        if (copy) {
            state_->refill(state_->pool.at(copy->worker), actions);
        }
    } else {
        state_->settle(actions);
    }
    return actions;
}

// ---- Measurements -------------------------------------------------------------------------------

void Dispatcher::time_is(double seconds) {
    CD_CHECK(seconds >= state_->now);
    state_->now = seconds;
}

void Dispatcher::work_measured(WorkerId worker, const MeasuredWork& work) {
    if (WorkerProxy* proxy = state_->pool.find(worker)) {
        const double predicted = 1e-9 * static_cast<double>(work.predicted_ns);
        proxy->pace().work.add(predicted, work.seconds);
        state_->general.work.add(predicted, work.seconds);
        proxy->note_busy(work.task, work.seconds);
    }
}

void Dispatcher::transfer_measured(WorkerId worker, std::uint64_t bytes, double seconds) {
    if (WorkerProxy* proxy = state_->pool.find(worker)) {
        proxy->pace().bytes.add(static_cast<double>(bytes), seconds);
        state_->general.bytes.add(static_cast<double>(bytes), seconds);
    }
}

void Dispatcher::roots_arrived(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    if (const WorkerProxy* proxy = state_->pool.find(worker)) {
        state_->pool.arrived(*proxy, tree, roots);
    }
}

// ---- Queries ------------------------------------------------------------------------------------

std::uint64_t Dispatcher::unsent() const {
    return state_->unsent;
}

std::uint64_t Dispatcher::unsent_enough() const {
    std::uint64_t enough = 0;
    for (const auto& [id, job] : state_->jobs) {
        const std::uint64_t workers = state_->pool.in_order().size();
        enough =
            std::max(enough, job.is_by_time() ? state_->enough_by_time() : job.options.q * workers);
    }
    // Leaves enough for other jobs and workers when all buffers are full.
    return limits::unsent_scenarios_max + enough;
}

WorkerStatus Dispatcher::worker_status(WorkerId worker) const {
    const WorkerProxy* proxy = state_->pool.find(worker);
    return proxy == nullptr ? WorkerStatus{} : proxy->status();
}

std::vector<WorkerId> Dispatcher::workers() const {
    std::vector<WorkerId> ids;
    for (const auto& [id, proxy] : state_->pool.all()) {
        ids.push_back(id);
    }
    return ids;
}

std::vector<TaskId> Dispatcher::tasks_of(WorkerId worker) const {
    std::vector<TaskId> ids;
    for (const auto& [id, task] : state_->pool.at(worker).tasks()) {
        ids.push_back(id);
    }
    return ids;
}

std::uint64_t Dispatcher::owed(WorkerId worker, TaskId task) const {
    const WorkerProxy* const proxy = state_->pool.find(worker);
    const bool owes = proxy != nullptr && !proxy->is_draining() && proxy->tasks().contains(task);
    return owes ? proxy->tasks().at(task).left() : 0;
}

std::uint64_t Dispatcher::unanswered(JobId job) const {
    const DispatchJob* const found = state_->find_job(job);
    return found == nullptr ? 0 : found->scenarios.size();
}

std::vector<PlaceRange> Dispatcher::places_of(JobId job) const {
    const std::deque<PlaceRange>& places = state_->jobs.at(job).places;
    return {places.begin(), places.end()};
}

} // namespace cd
