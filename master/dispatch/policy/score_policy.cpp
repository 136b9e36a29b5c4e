#include "master/dispatch/policy/score_policy.hpp"

namespace cd {

void gather_candidates(const MatchingContext& context,
                       const DispatchJob& job,
                       std::vector<WorkerCandidate>& candidates) {
    const WorkerProxy* reserved = context.reserved();
    candidates.clear();
    for (WorkerProxy* proxy : context.pool.in_order()) {
        if (!proxy->takes_work() || proxy->is_claimed() || proxy == reserved) {
            continue;
        }
        const ScenarioBuffer& buffer = proxy->buffers.of(job.id);
        if (!buffer.is_full(job.options)) {
            const double load = static_cast<double>(buffer.scenarios.size()) / job.options.q;
            candidates.push_back({proxy, 0, load});
        }
    }
}

WorkerProxy* ScorePolicy::would_choose(const DispatchJob& job,
                                       const DispatchScenario& scenario) const {
    gather_candidates(context(), job, candidates_);
    if (candidates_.empty()) {
        return nullptr;
    }
    const BlockPlan& plan = context().plan;
    held_triangles_.assign(plan.tree(scenario.roots[0].tree).held.sum_count(), 0);
    for (const TreeRoots& side : scenario.roots) {
        plan.tree(side.tree).held.add_held(side.roots, held_triangles_);
    }
    WorkerProxy* best = nullptr;
    double best_worth = 0;
    for (WorkerCandidate& candidate : candidates_) {
        candidate.held_triangles = held_triangles_[candidate.worker->slot()];
        const double value = worth(candidate);
        if (best == nullptr || value > best_worth ||
            (value == best_worth && candidate.worker->scenarios() < best->scenarios())) {
            best = candidate.worker;
            best_worth = value;
        }
    }
    return best;
}

} // namespace cd
