#include "master/dispatch/blocks/block_needs.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void MissingBlocks::hint(const WorkerProxy& proxy, const DispatchJob& job, Actions& actions) {
    for (BlockPlan::Missing& missing : of_trees) {
        if (!missing.roots.empty()) {
            actions.push_back(SendHint{proxy.id(), job.id, missing.tree, std::move(missing.roots)});
        }
    }
}

MissingBlocks BlockNeeds::hold(DispatchJob& job, DispatchScenario& scenario, WorkerProxy& proxy) {
    if (job.missing.is_sampled()) {
        // Must precede `hold_roots`, which marks the blocks as held.
        job.missing.add_sample(seconds_with_any(scenario));
    }
    MissingBlocks missing = hold_roots(scenario.roots, proxy);
    scenario.fetches = !missing.is_nothing();
    job.missing.add_matched(seconds_of(missing, proxy));
    return missing;
}

MissingBlocks BlockNeeds::hold_roots(const ScenarioRoots& roots, WorkerProxy& proxy) {
    MissingBlocks missing{{plan_.hold(proxy.slot(), roots[0].tree, roots[0].roots),
                           plan_.hold(proxy.slot(), roots[1].tree, roots[1].roots)}};
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
        if (job.trees.have(tree) && proxy.tasks.count_of(id) != 0) {
            job.missing.add_in_ranges(pace_.seconds_of(missing, proxy));
        }
    }
}

double BlockNeeds::seconds_of(const MissingBlocks& missing, const WorkerProxy& proxy) const {
    const auto& [a, b] = missing.of_trees;
    return pace_.seconds_of(a, proxy) + pace_.seconds_of(b, proxy);
}

double BlockNeeds::missing_share(const WorkerProxy& proxy, const DispatchJob& job) const {
    double held = 0;
    std::uint64_t roots = 0;
    for (const auto& one : job.trees.distinct()) {
        const PlannedTree& tree = plan_.tree(one->tree);
        held += tree.held.roots_of(proxy.slot());
        roots += tree.held.root_count();
    }
    return 1 - held / static_cast<double>(roots);
}

double BlockNeeds::seconds_with_any(const DispatchScenario& scenario) {
    held_triangles_.assign(plan_.tree(scenario.roots[0].tree).held.sum_count(), 0);
    double triangles = 0;
    double bytes = 0;
    double blocks = 0;
    for (const auto& [id, roots] : scenario.roots) {
        const PlannedTree& tree = plan_.tree(id);
        tree.held.add_held(roots, held_triangles_);
        blocks += static_cast<double>(roots.size());
        for (const WeightedRoot& root : roots) {
            triangles += root.weight;
            bytes += static_cast<double>(tree.bytes_of(root.root));
        }
    }
    double held = 0;
    double bytes_per_second = 0;
    for (const WorkerProxy* proxy : pool_.in_order()) {
        held += static_cast<double>(held_triangles_[proxy->slot()]);
        bytes_per_second += pace_.link_of(*proxy);
    }
    const auto workers = static_cast<double>(pool_.in_order().size());
    const double missing = std::max(0.0, 1 - held / (workers * std::max(triangles, 1.0)));
    return missing * (bytes * workers / bytes_per_second + blocks * timing::block_seconds);
}

MissingCosts BlockNeeds::costs_of(const DispatchJob& job) const {
    MissingCosts costs;
    costs.all_fits = true;
    job.missing.tell(costs);
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;
    std::uint64_t blocks = 0;
    for (const auto& one : job.trees.distinct()) {
        const PlannedTree& tree = plan_.tree(one->tree);
        triangles += tree.triangles_total;
        bytes += tree.bytes_total;
        blocks += tree.triangles.size();
    }
    for (const WorkerProxy* proxy : pool_.in_order()) {
        const double missing = missing_share(*proxy, job);
        const double of_byte = 1 / pace_.link_of(*proxy);
        costs.of_byte += of_byte / static_cast<double>(pool_.in_order().size());
        costs.all += missing * (static_cast<double>(bytes) * of_byte +
                                static_cast<double>(blocks) * timing::block_seconds);
        const std::uint64_t memory = proxy->facts().cache_bytes;
        costs.all_fits = costs.all_fits &&
                         (memory == 0 || triangles * limits::wide_bytes_per_triangle <= memory);
    }
    return costs;
}

} // namespace cd
