// The strategy `best-match-pull`: a free worker takes from the waiting scenarios (paper, 5.1).
#include "master/dispatch/dispatcher_state.hpp"

namespace cd {

bool Dispatcher::State::pull_one(DispatchJob& job, Actions& actions) {
    for (WorkerProxy* proxy : pool.in_order()) {
        if (can_pull(*proxy, job)) {
            served_last = job.id;
            pull(*proxy, job, actions);
            return true;
        }
    }
    return false;
}

bool Dispatcher::State::can_pull(const WorkerProxy& proxy, const DispatchJob& job) const {
    if (job.waiting.empty() || !proxy.takes_work() || &proxy == reserved() ||
        !proxy.has_room_for_task(job.id, job.options)) {
        return false;
    }
    // Takes less than a task's worth only if nothing more comes and the worker needs it.
    return job.waiting.size() >= job.options.q ||
           (input_is_paused && proxy.would_run_dry(job.options));
}

void Dispatcher::State::pull(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    const RootHolders& held_a = pool.tree(job.a.tree).held;
    const RootHolders& held_b = pool.tree(job.b.tree).held;
    std::vector<std::uint64_t> scores;
    scores.reserve(job.waiting.size());
    for (const std::uint64_t index : job.waiting) {
        const ScenarioRoots& roots = job.at(index).roots;
        scores.push_back(held_a.held(proxy.slot(), roots.a) + held_b.held(proxy.slot(), roots.b));
    }
    std::vector<std::uint64_t> taken;
    std::uint64_t bytes = 0;
    std::vector<bool> is_taken(job.waiting.size(), false);
    for (const std::size_t place : Matchmaker::most_similar(scores, job.options.q)) {
        // Paper, 6.4.3: a task ends as soon as it exceeds V kB.
        if (bytes > std::uint64_t{job.options.v_kb} * 1000) {
            break;
        }
        const std::uint64_t index = job.waiting[place];
        DispatchScenario& scenario = job.at(index);
        hold_roots(job, scenario, proxy);
        bytes += scenario.weight.bytes;
        is_taken[place] = true;
        taken.push_back(index);
    }
    std::size_t place = 0;
    std::erase_if(job.waiting, [&](std::uint64_t) { return is_taken[place++]; });
    send(proxy, job, std::move(taken), job.options.claim, actions);
}

} // namespace cd
