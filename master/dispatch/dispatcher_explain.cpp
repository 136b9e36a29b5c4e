// Explains how the dispatcher would place a scenario.
#include "common/core/check.hpp"
#include "master/dispatch/dispatcher_state.hpp"

#include <algorithm>

namespace cd {

namespace {

std::uint64_t sum_of(std::span<const WeightedRoot> roots) {
    std::uint64_t sum = 0;
    for (const WeightedRoot& root : roots) {
        sum += root.weight;
    }
    return sum;
}

std::string reason(Strategy strategy, bool is_anyone) {
    if (strategy == Strategy::BestMatchPull) {
        return "no worker is chosen: a free one takes the q scenarios of which it holds most";
    }
    if (!is_anyone) {
        return "no worker may take a scenario now";
    }
    switch (strategy) {
    case Strategy::BestMatch:
        return "it holds the most triangles of the scenario";
    case Strategy::BestMatchLoad:
        return "it holds the most triangles of the scenario, times the free share of its buffer";
    case Strategy::Random:
        return "it is drawn next";
    case Strategy::Lowest:
        return "it holds the fewest triangles of the scenario";
    case Strategy::EarliestFinish:
    case Strategy::BestMatchPull:
        break;
    }
    return "the scenario would be done there first";
}

} // namespace

std::string Dispatcher::State::whereabouts(const DispatchJob& job, std::uint64_t index) const {
    const auto found = job.scenarios.find(index);
    if (found == job.scenarios.end()) {
        return "not analysed yet, or in a range at a worker";
    }
    const auto name_of = [&](WorkerId worker) { return pool.find(worker)->facts().name; };
    switch (found->second.where) {
    case Whereabouts::Waiting:
        return "waits";
    case Whereabouts::Suspect:
        return "was lost with workers, waits for an idle one";
    case Whereabouts::Buffered:
        return "in the buffer of " + name_of(found->second.worker);
    case Whereabouts::Sent:
        break;
    }
    const auto& copy = found->second.copy;
    return "at " + name_of(found->second.worker) +
           (copy ? ", and a copy at " + name_of(copy->worker) : "");
}

bool Dispatcher::State::may_take(const WorkerProxy& proxy, const DispatchJob& job) const {
    if (!proxy.takes_work() || &proxy == reserved()) {
        return false;
    }
    if (job.is_by_time()) {
        return true;
    }
    if (job.is_pulled()) {
        return proxy.has_room_for_task(job.id, job.options);
    }
    return !proxy.is_claimed() && !proxy.buffer(job.id).is_full(job.options);
}

WorkerId Dispatcher::State::would_choose(DispatchJob& job, const DispatchScenario& scenario) {
    if (job.is_pulled()) {
        return {};
    }
    const WorkerProxy* chosen = nullptr;
    if (job.is_by_time()) {
        chosen = earliest(job, scenario);
    } else {
        const Matchmaker before = job.matchmaker; // A random draw would change later choices.
        chosen = choose(job, scenario);
        job.matchmaker = before;
    }
    return chosen == nullptr ? WorkerId{} : chosen->id();
}

WorkerScore Dispatcher::State::score_of(const WorkerProxy& proxy,
                                        const DispatchJob& job,
                                        const DispatchScenario& scenario) const {
    const ScenarioRoots& roots = scenario.roots;
    WorkerScore score;
    score.worker = proxy.id();
    score.name = proxy.facts().name;
    score.may_take = may_take(proxy, job);
    score.scenarios = proxy.buffered() + proxy.working();
    score.load = static_cast<double>(proxy.buffer(job.id).scenarios.size()) / job.options.q;
    score.held_triangles = pool.tree(job.a.tree).held.held(proxy.slot(), roots.a) +
                           pool.tree(job.b.tree).held.held(proxy.slot(), roots.b);
    score.missing_triangles = sum_of(roots.a) + sum_of(roots.b) - score.held_triangles;
    if (job.is_by_time()) {
        const FinishTerms terms = finish_on(proxy, job, scenario);
        score.backlog = terms.backlog;
        score.coming = terms.coming;
        score.transfer = terms.transfer;
        score.blocks = terms.blocks;
        score.eviction = terms.eviction;
        score.work = terms.work;
    }
    return score;
}

Explained Dispatcher::explain(JobId job_id, const AnalysedScenario& analysed) const {
    DispatchJob* job = state_->find_job(job_id);
    CD_CHECK(job != nullptr);
    Explained explained;
    explained.job = job_id;
    explained.scenario = analysed.index;
    explained.strategy = job->options.strategy;
    explained.roots_a = static_cast<std::uint32_t>(analysed.roots_a.size());
    explained.roots_b = static_cast<std::uint32_t>(analysed.roots_b.size());
    if (analysed.roots_a.empty()) {
        explained.where = "answered by the master";
        explained.why = "no distribution roots collide, so no worker is asked";
        return explained;
    }
    const DispatchScenario scenario = make_dispatch_scenario(*job, analysed);
    const WorkerId chosen = state_->would_choose(*job, scenario);
    explained.where = state_->whereabouts(*job, analysed.index);
    explained.why = reason(explained.strategy, chosen != WorkerId{});
    for (const WorkerProxy* proxy : state_->pool.in_order()) {
        explained.workers.push_back(state_->score_of(*proxy, *job, scenario));
        explained.workers.back().is_chosen = proxy->id() == chosen;
    }
    return explained;
}

} // namespace cd
