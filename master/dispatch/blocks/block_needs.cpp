#include "master/dispatch/blocks/block_needs.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void MissingOfJob::hint(const WorkerProxy& proxy, const DispatchJob& job, Actions& actions) {
    const auto say = [&](TreeId tree, BlockPlan::Missing& of_tree) {
        if (!of_tree.roots.empty()) {
            actions.push_back(SendHint{proxy.id(), job.id, tree, std::move(of_tree.roots)});
        }
    };
    say(job.a.tree, a);
    say(job.b.tree, b);
}

MissingOfJob BlockNeeds::hold(DispatchJob& job, DispatchScenario& scenario, WorkerProxy& proxy) {
    if (job.missing.is_sampled()) {
        // Must precede `hold_roots`, which marks the blocks as held.
        job.missing.add_sample(seconds_with_any(job, scenario));
    }
    MissingOfJob missing = hold_roots(job, scenario.roots, proxy);
    scenario.fetches = !missing.is_nothing();
    job.missing.add_matched(seconds_of(missing, proxy));
    return missing;
}

MissingOfJob
BlockNeeds::hold_roots(const DispatchJob& job, const ScenarioRoots& roots, WorkerProxy& proxy) {
    MissingOfJob missing{plan_.hold(proxy.slot(), job.a.tree, roots.a),
                         plan_.hold(proxy.slot(), job.b.tree, roots.b)};
    if (!missing.is_nothing()) {
        proxy.add_transfer(pace_.now(), seconds_of(missing, proxy));
    }
    return missing;
}

void BlockNeeds::hold_wanted(WorkQueue& queue,
                             WorkerProxy& proxy,
                             TreeId tree,
                             std::span<const RootIndex> roots) {
    const BlockPlan::Missing missing = plan_.hold(proxy.slot(), tree, roots);
    for (auto& [id, job] : queue.jobs()) {
        if (job.uses(tree) && proxy.tasks.count_of(id) != 0) {
            job.missing.add_in_ranges(pace_.seconds_of(missing, proxy));
        }
    }
}

double BlockNeeds::seconds_of(const MissingOfJob& missing, const WorkerProxy& proxy) const {
    return pace_.seconds_of(missing.a, proxy) + pace_.seconds_of(missing.b, proxy);
}

double BlockNeeds::missing_share(const WorkerProxy& proxy, const DispatchJob& job) const {
    const PlannedTree& a = plan_.tree(job.a.tree);
    const PlannedTree& b = plan_.tree(job.b.tree);
    const double held = a.held.roots_of(proxy.slot()) + b.held.roots_of(proxy.slot());
    return 1 - held / static_cast<double>(a.held.root_count() + b.held.root_count());
}

double BlockNeeds::seconds_with_any(const DispatchJob& job, const DispatchScenario& scenario) {
    const PlannedTree& a = plan_.tree(job.a.tree);
    const PlannedTree& b = plan_.tree(job.b.tree);
    held_triangles_.assign(a.held.sum_count(), 0);
    a.held.add_held(scenario.roots.a, held_triangles_);
    b.held.add_held(scenario.roots.b, held_triangles_);
    double held = 0;
    double bytes_per_second = 0;
    for (const WorkerProxy* proxy : pool_.in_order()) {
        held += static_cast<double>(held_triangles_[proxy->slot()]);
        bytes_per_second += pace_.link_of(*proxy);
    }
    const auto workers = static_cast<double>(pool_.in_order().size());
    double triangles = 0;
    double bytes = 0;
    for (const auto* side : {&a, &b}) {
        for (const WeightedRoot& root : side == &a ? scenario.roots.a : scenario.roots.b) {
            triangles += root.weight;
            bytes += static_cast<double>(side->bytes_of(root.root));
        }
    }
    const double blocks = static_cast<double>(scenario.roots.a.size() + scenario.roots.b.size());
    const double missing = std::max(0.0, 1 - held / (workers * std::max(triangles, 1.0)));
    return missing * (bytes * workers / bytes_per_second + blocks * timing::block_seconds);
}

MissingCosts BlockNeeds::costs_of(const DispatchJob& job) const {
    MissingCosts costs;
    costs.all_fits = true;
    job.missing.tell(costs);
    const PlannedTree& a = plan_.tree(job.a.tree);
    const PlannedTree& b = plan_.tree(job.b.tree);
    const bool is_one = job.a.tree == job.b.tree;
    const std::uint64_t triangles = a.triangles_total + (is_one ? 0 : b.triangles_total);
    const std::uint64_t bytes = a.bytes_total + (is_one ? 0 : b.bytes_total);
    const std::uint64_t blocks = a.triangles.size() + (is_one ? 0 : b.triangles.size());
    for (const WorkerProxy* proxy : pool_.in_order()) {
        const double missing = missing_share(*proxy, job);
        costs.all += missing * (static_cast<double>(bytes) / pace_.link_of(*proxy) +
                                static_cast<double>(blocks) * timing::block_seconds);
        const std::uint64_t memory = proxy->facts().cache_bytes;
        costs.all_fits = costs.all_fits &&
                         (memory == 0 || triangles * limits::wide_bytes_per_triangle <= memory);
    }
    return costs;
}

} // namespace cd
