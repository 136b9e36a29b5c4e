#include "master/dispatch/view/explain.hpp"

#include "master/dispatch/policy/matching_policy.hpp"

#include <string>

namespace cd {

namespace {

std::uint64_t triangles_of(const ScenarioRoots& roots) {
    std::uint64_t sum = 0;
    for (const TreeRoots& side : roots) {
        for (const WeightedRoot& root : side.roots) {
            sum += root.weight;
        }
    }
    return sum;
}

std::string whereabouts(const WorkerPool& pool, const DispatchJob& job, std::uint64_t position) {
    const auto found = job.scenarios.find(position);
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
        return "in the buffer of " + name_of(found->second.at.worker);
    case Whereabouts::Sent:
        break;
    }
    const Assignment& at = found->second.at;
    std::string text = "at " + name_of(at.worker);
    for (const Assignment& copy : pool.find(at.worker)->tasks.at(at.task).shared.copies) {
        const WorkerProxy* helper = pool.find(copy.worker);
        const TaskInFlight* task = helper == nullptr ? nullptr : helper->tasks.find(copy.task);
        if (task != nullptr && task->positions.contains(position)) {
            text += ", and a copy at " + name_of(copy.worker);
        }
    }
    return text;
}

WorkerScore score_of(const MatchingContext& context,
                     const WorkerProxy& proxy,
                     const DispatchJob& job,
                     const DispatchScenario& scenario) {
    const ScenarioRoots& roots = scenario.roots;
    WorkerScore score;
    score.worker = proxy.id();
    score.name = proxy.facts().name;
    score.may_take = job.policy->may_take(proxy, job);
    score.scenarios = proxy.scenarios();
    score.load = static_cast<double>(proxy.buffers.of(job.id).scenarios.size()) / job.options.q;
    score.held_triangles = held_triangles(context.plan, proxy.slot(), roots);
    score.missing_triangles = triangles_of(roots) - score.held_triangles;
    const FinishTerms terms = job.policy->finish_on(proxy, job, scenario);
    score.backlog = terms.backlog;
    score.coming = terms.coming;
    score.transfer = terms.transfer;
    score.blocks = terms.blocks;
    score.eviction = terms.eviction;
    score.work = terms.work;
    return score;
}

} // namespace

Explained explain_choice(const MatchingContext& context,
                         const DispatchJob& job,
                         const AnalysedScenario& analysed) {
    Explained explained;
    explained.job = job.id;
    explained.strategy = job.options.strategy;
    // The strategies that move work compare workers by the terms of `finish_on`.
    explained.is_by_time = job.policy->moves_work();
    explained.roots_a = static_cast<std::uint32_t>(analysed.roots_a.size());
    explained.roots_b = static_cast<std::uint32_t>(analysed.roots_b.size());
    if (analysed.roots_a.empty()) {
        explained.where = "answered by the master";
        explained.why = "no distribution roots collide, so no worker is asked";
        return explained;
    }
    const DispatchScenario scenario = job.scenario_of(analysed);
    const WorkerProxy* chosen = job.policy->would_choose(job, scenario);
    explained.where = whereabouts(context.pool, job, analysed.position);
    explained.why = chosen == nullptr ? job.policy->why_none() : job.policy->why();
    for (const WorkerProxy* proxy : context.pool.in_order()) {
        explained.workers.push_back(score_of(context, *proxy, job, scenario));
        explained.workers.back().is_chosen = proxy == chosen;
    }
    return explained;
}

} // namespace cd
