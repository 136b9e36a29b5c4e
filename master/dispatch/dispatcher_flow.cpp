// Moves scenarios from the queues through the buffers to the workers, and back.
#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/dispatcher_state.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// Number of losses after which a scenario is given up.
std::uint32_t losses_max() {
    return mutated(Mutation::PoisonToleratedTooLong)  ? ~0u
           : mutated(Mutation::PoisonGivenUpTooEarly) ? limits::scenario_losses_max - 1
                                                      : limits::scenario_losses_max;
}

template <class Scenarios>
auto& unanswered_one(Scenarios& scenarios, std::uint64_t index) {
    const auto found = scenarios.find(index);
    const bool scenario_in_hand_is_unanswered = found != scenarios.end();
    CD_CHECK(scenario_in_hand_is_unanswered);
    return found->second;
}

} // namespace

DispatchScenario& DispatchJob::at(std::uint64_t index) {
    return unanswered_one(scenarios, index);
}

const DispatchScenario& DispatchJob::at(std::uint64_t index) const {
    return unanswered_one(scenarios, index);
}

DispatchJob* Dispatcher::State::find_job(JobId job) {
    const auto found = jobs.find(job);
    return found == jobs.end() ? nullptr : &found->second;
}

bool Dispatcher::State::is_due(double last) const {
    const std::size_t workers = pool.in_order().size();
    const std::size_t beyond = workers - std::min(workers, options.workers_few);
    return now >= last + options.look_seconds_each * static_cast<double>(beyond);
}

bool Dispatcher::State::something_waits() const {
    return !suspects.empty() ||
           std::ranges::any_of(jobs, [](const auto& job) { return !job.second.waiting.empty(); });
}

void Dispatcher::State::settle(Actions& actions) {
    settled = now;
    give_suspects(actions);
    set_batches();
    for (WorkerProxy* proxy : pool.in_order()) {
        flush_ripe(*proxy, actions);
    }
    while (allocate_next(actions)) {
    }
    // Only now is it certain that nothing more comes for these workers.
    for (WorkerProxy* proxy : pool.in_order()) {
        flush_ripe(*proxy, actions);
    }
    rebalance(actions);
    give_places(actions);
    help_at_end(actions);
}

bool Dispatcher::State::allocate_next(Actions& actions) {
    // Round robin: first the jobs after the one served last, then those up to it.
    const auto next = jobs.upper_bound(served_last);
    for (auto place = next; place != jobs.end(); ++place) {
        if (allocate_one(place->second, actions)) {
            return true;
        }
    }
    for (auto place = jobs.begin(); place != next; ++place) {
        if (allocate_one(place->second, actions)) {
            return true;
        }
    }
    return false;
}

bool Dispatcher::State::allocate_one(DispatchJob& job, Actions& actions) {
    if (job.waiting.empty()) {
        return false;
    }
    if (job.is_pulled()) {
        return pull_one(job, actions);
    }
    const std::uint64_t index = job.waiting.front();
    DispatchScenario& scenario = job.at(index);
    WorkerProxy* proxy = job.is_by_time() ? earliest(job, scenario) : choose(job, scenario);
    if (proxy == nullptr) {
        return false;
    }
    job.waiting.pop_front();
    served_last = job.id;
    scenario.where = Whereabouts::Buffered;
    scenario.worker = proxy->id();
    MissingOfJob missing = hold_roots(job, scenario, *proxy);
    proxy->add_to_buffer(job.id, index, scenario.weight);
    // In matching by time, a batch takes only part of a buffer.
    while (is_full(*proxy, job) && has_room_for_task(*proxy, job)) {
        flush(*proxy, job, actions);
    }
    if (job.hints() && scenario.where == Whereabouts::Buffered) {
        hint(*proxy, job, std::move(missing), actions);
    }
    return true;
}

WorkerProxy* Dispatcher::State::choose(DispatchJob& job, const DispatchScenario& scenario) {
    gather_candidates(job);
    if (!candidates.empty() && job.matchmaker.looks_at_scores()) {
        score_candidates(job, scenario);
    }
    const auto chosen = job.matchmaker.choose(candidates);
    return chosen ? &pool.at(*chosen) : nullptr;
}

void Dispatcher::State::gather_candidates(const DispatchJob& job) {
    const WorkerProxy* excluded = reserved();
    candidates.clear();
    slots.clear();
    for (const WorkerProxy* proxy : pool.in_order()) {
        if (!proxy->takes_work() || proxy->is_claimed() || proxy == excluded) {
            continue;
        }
        const ScenarioBuffer& buffer = proxy->buffer(job.id);
        if (buffer.is_full(job.options)) {
            continue;
        }
        const double load = static_cast<double>(buffer.scenarios.size()) / job.options.q;
        candidates.push_back({proxy->id(), 0, load, proxy->buffered() + proxy->working()});
        slots.push_back(proxy->slot());
    }
}

void Dispatcher::State::score_candidates(const DispatchJob& job, const DispatchScenario& scenario) {
    const RootHolders& holders_a = pool.tree(job.a.tree).held;
    const RootHolders& holders_b = pool.tree(job.b.tree).held;
    held_triangles.assign(holders_a.sum_count(), 0);
    holders_a.add_held(scenario.roots.a, held_triangles);
    holders_b.add_held(scenario.roots.b, held_triangles);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        candidates[i].held_triangles = held_triangles[slots[i]];
    }
}

MissingOfJob
Dispatcher::State::hold_roots(DispatchJob& job, DispatchScenario& scenario, WorkerProxy& proxy) {
    measure_missing(job, scenario);
    MissingOfJob missing = hold_all(job, scenario.roots, proxy);
    scenario.fetches = !missing.is_nothing();
    job.missing_seconds += seconds_of(missing.a, proxy) + seconds_of(missing.b, proxy);
    return missing;
}

MissingOfJob Dispatcher::State::hold_all(const DispatchJob& job,
                                         const ScenarioRoots& roots,
                                         WorkerProxy& proxy) {
    MissingOfJob missing{pool.hold(proxy, job.a.tree, roots.a),
                         pool.hold(proxy, job.b.tree, roots.b)};
    if (!missing.is_nothing()) {
        proxy.add_transfer(now, seconds_of(missing.a, proxy) + seconds_of(missing.b, proxy));
    }
    return missing;
}

void Dispatcher::State::hint(const WorkerProxy& proxy,
                             const DispatchJob& job,
                             MissingOfJob missing,
                             Actions& actions) {
    const auto say = [&](TreeId tree, WorkerPool::Missing& of_tree) {
        if (!of_tree.roots.empty()) {
            actions.push_back(SendHint{proxy.id(), job.id, tree, std::move(of_tree.roots)});
        }
    };
    say(job.a.tree, missing.a);
    say(job.b.tree, missing.b);
}

double Dispatcher::State::seconds_of(const WorkerPool::Missing& missing,
                                     const WorkerProxy& proxy) const {
    return static_cast<double>(missing.bytes) / link_of(proxy) +
           static_cast<double>(missing.roots.size()) * limits::block_seconds;
}

void Dispatcher::State::give_suspects(Actions& actions) {
    for (auto& [id, proxy] : pool.all()) {
        if (suspects.empty()) {
            return;
        }
        if (!proxy.takes_work() || !proxy.is_idle()) {
            continue;
        }
        const Suspect suspect = suspects.front();
        suspects.pop_front();
        DispatchJob& job = jobs.at(suspect.job);
        hold_roots(job, job.at(suspect.scenario), proxy);
        send(proxy, job, {suspect.scenario}, true, actions);
    }
}

const WorkerProxy* Dispatcher::State::reserved() const {
    if (suspects.empty()) {
        return nullptr;
    }
    for (const auto& [id, proxy] : pool.all()) {
        if (proxy.takes_work()) {
            return &proxy;
        }
    }
    return nullptr;
}

void Dispatcher::State::flush_ripe(WorkerProxy& proxy, Actions& actions) {
    while (DispatchJob* job = next_ripe(proxy)) {
        flush(proxy, *job, actions);
    }
}

DispatchJob* Dispatcher::State::next_ripe(const WorkerProxy& proxy) {
    // Round robin over the jobs, as in `allocate_next`.
    const auto next = proxy.buffers().upper_bound(proxy.flushed_last());
    for (auto place = next; place != proxy.buffers().end(); ++place) {
        if (is_ripe(proxy, jobs.at(place->first))) {
            return &jobs.at(place->first);
        }
    }
    for (auto place = proxy.buffers().begin(); place != next; ++place) {
        if (is_ripe(proxy, jobs.at(place->first))) {
            return &jobs.at(place->first);
        }
    }
    return nullptr;
}

bool Dispatcher::State::is_ripe(const WorkerProxy& proxy, const DispatchJob& job) const {
    if (proxy.buffer(job.id).scenarios.empty() || !has_room_for_task(proxy, job)) {
        return false;
    }
    const bool nothing_comes = (input_is_paused && job.waiting.empty()) || &proxy == reserved();
    return is_full(proxy, job) || (nothing_comes && would_run_dry(proxy, job));
}

bool Dispatcher::State::is_full(const WorkerProxy& proxy, const DispatchJob& job) const {
    const ScenarioBuffer& buffer = proxy.buffer(job.id);
    if (job.is_by_time()) {
        return !buffer.scenarios.empty() && buffer.cost_ns >= proxy.batch_ns();
    }
    return buffer.is_full(job.options);
}

bool Dispatcher::State::has_room_for_task(const WorkerProxy& proxy, const DispatchJob& job) const {
    if (job.is_by_time()) {
        return has_room_by_time(proxy, job);
    }
    return proxy.has_room_for_task(job.id, job.options) ||
           (mutated(Mutation::BatchesWithoutBound) && !proxy.is_claimed());
}

bool Dispatcher::State::would_run_dry(const WorkerProxy& proxy, const DispatchJob& job) const {
    return job.is_by_time() ? runs_dry_by_time(proxy) : proxy.would_run_dry(job.options);
}

void Dispatcher::State::refill(WorkerProxy& proxy, Actions& actions) {
    flush_ripe(proxy, actions);
    for (auto& [id, job] : jobs) {
        while (job.is_pulled() && can_pull(proxy, job)) {
            pull(proxy, job, actions);
        }
    }
    forget_place_totals();
    give_places_to(proxy, actions);
}

void Dispatcher::State::flush(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    if (job.is_by_time()) {
        send(proxy, job, take_batch(proxy, job), false, actions);
    } else {
        send(proxy, job, proxy.take_buffer(job.id).scenarios, job.options.claim, actions);
    }
}

void Dispatcher::State::send(WorkerProxy& proxy,
                             DispatchJob& job,
                             std::vector<std::uint64_t> scenarios,
                             bool claims,
                             Actions& actions) {
    const TaskId task{++task_last};
    ProxyTask content{job.id, scenarios, claims, 0, now, false, 0};
    for (const std::uint64_t index : scenarios) {
        DispatchScenario& scenario = job.at(index);
        content.cost_ns += scenario.weight.cost_ns;
        content.fetches = content.fetches || scenario.fetches;
        scenario.where = Whereabouts::Sent;
        scenario.worker = proxy.id();
        scenario.task = task;
    }
    unsent -= scenarios.size();
    proxy.start_task(task, std::move(content));
    actions.push_back(SendBatch{proxy.id(), task, job.id, std::move(scenarios)});
}

void Dispatcher::State::take_back_buffers(WorkerProxy& proxy) {
    while (!proxy.buffers().empty()) {
        DispatchJob& job = jobs.at(proxy.buffers().begin()->first);
        wait_first(job, proxy.take_buffer(job.id).scenarios);
    }
}

void Dispatcher::State::end_task(TaskId task,
                                 const ProxyTask& ended,
                                 LostWith lost_with,
                                 Actions& actions) {
    std::erase_if(recalls, [&](const auto& asked) { return asked.second.task == task; });
    if (ended.is_range()) {
        if (DispatchJob* job = find_job(ended.job)) {
            job->work_ns -= std::min(job->work_ns, ended.cost_ns); // Will be sent again.
        }
        actions.push_back(RangeEnded{task, ended.job, *ended.places, lost_with});
    } else {
        take_back(task, ended, lost_with, actions);
    }
}

void Dispatcher::State::take_back(TaskId task,
                                  const ProxyTask& ended,
                                  LostWith lost_with,
                                  Actions& actions) {
    const JobId job_id = ended.job;
    DispatchJob* job = find_job(job_id);
    if (job == nullptr) {
        return;
    }
    std::vector<std::uint64_t> again;
    ScenariosLost lost{job_id, {}, lost_with.value_or(0)};
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
        if (leave_task(scenario, task) && !mutated(Mutation::CopyIsAlone)) {
            continue;
        }
        if (is_lost_for_good(scenario)) {
            job->scenarios.erase(index);
            actions.push_back(GiveUp{job_id, index});
            continue;
        }
        ++unsent;
        if (!suspect(job_id, index, scenario)) {
            again.push_back(index);
        }
    }
    wait_first(*job, again);
    if (!lost.scenarios.empty()) {
        actions.push_back(std::move(lost));
    }
}

bool Dispatcher::State::is_lost_for_good(const DispatchScenario& scenario) {
    return scenario.losses.count() >= losses_max();
}

bool Dispatcher::State::suspect(JobId job, std::uint64_t index, DispatchScenario& scenario) {
    if (scenario.losses.count() + 1 != limits::scenario_losses_max) {
        return false;
    }
    scenario.where = Whereabouts::Suspect;
    suspects.push_back({job, index});
    return true;
}

void Dispatcher::State::wait_first(DispatchJob& job, std::span<const std::uint64_t> scenarios) {
    for (const std::uint64_t index : scenarios) {
        job.at(index).where = Whereabouts::Waiting;
    }
    job.waiting.insert(job.waiting.begin(), scenarios.begin(), scenarios.end());
}

void Dispatcher::State::withdraw(DispatchJob& job,
                                 std::uint64_t index,
                                 DispatchScenario& scenario,
                                 WorkerId by,
                                 Actions& actions) {
    switch (scenario.where) {
    case Whereabouts::Waiting:
        std::erase(job.waiting, index);
        --unsent;
        return;
    case Whereabouts::Suspect:
        std::erase_if(suspects, [&](const Suspect& suspect) {
            return suspect.job == job.id && suspect.scenario == index;
        });
        --unsent;
        return;
    case Whereabouts::Buffered:
        pool.at(scenario.worker).remove_from_buffer(job.id, index, scenario.weight);
        unsent -= mutated(Mutation::RoomNotGivenBack) ? 0 : 1;
        return;
    case Whereabouts::Sent:
        if (mutated(Mutation::AnswerLeftAtWorker)) {
            return;
        }
        pool.at(scenario.worker)
            .answer(scenario.task, index, scenario.weight.cost_ns, scenario.worker == by);
        if (scenario.copy && !mutated(Mutation::CopyLeftAtWorker)) {
            const auto& [worker, task] = *scenario.copy;
            pool.at(worker).answer(task, index, scenario.weight.cost_ns, worker == by);
            const bool copy_won = worker == by;
            actions.push_back(CallOff{copy_won ? scenario.worker : worker,
                                      copy_won ? scenario.task : task,
                                      job.id,
                                      index});
        }
        return;
    }
}

bool Dispatcher::State::is_tree_used(TreeId tree) const {
    return std::any_of(jobs.begin(), jobs.end(), [&](const auto& entry) {
        return entry.second.a.tree == tree || entry.second.b.tree == tree;
    });
}

} // namespace cd
