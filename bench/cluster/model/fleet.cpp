#include "bench/cluster/model/fleet.hpp"

#include "common/core/check.hpp"
#include "master/dispatch/cost_model.hpp"

#include <random>

namespace cd::bench {

namespace {

BlockCost block_cost(const RootTrace& root) {
    return {root.triangles, root.compressed_bytes, root.memory_bytes, root.open_seconds};
}

ScenarioCost
scaled_cost(const ScenarioTrace& from, RootIndex first_root, const FleetOptions& options) {
    const auto together = static_cast<double>(options.together);
    ScenarioCost cost;
    cost.analysis_seconds = from.analysis_seconds;
    cost.work_seconds = together * from.work_seconds;
    cost.batch_bytes = from.batch_bytes;
    cost.result_bytes = options.together * options.scenario_bytes;
    cost.predicted_ns = options.together * predicted_ns(from.meeting_size);
    cost.blocks.reserve(from.roots_a.size() + from.roots_b.size());
    for (const RootIndex root : from.roots_a) {
        cost.blocks.push_back({0, first_root + root});
    }
    for (const RootIndex root : from.roots_b) {
        cost.blocks.push_back({1, root});
    }
    return cost;
}

} // namespace

Workload make_fleet(const Trace& trace, const FleetOptions& options) {
    const DepthTrace* depth = trace.at(options.depth);
    CD_CHECK(depth != nullptr);
    const std::uint64_t copies = (options.triangles + trace.triangles_a - 1) / trace.triangles_a;
    const std::size_t roots = depth->a.roots.size();
    Workload fleet;
    for (std::uint64_t copy = 0; copy < copies; ++copy) {
        for (const RootTrace& root : depth->a.roots) {
            fleet.trees[0].push_back(block_cost(root));
        }
    }
    for (const RootTrace& root : trace.b.roots) {
        fleet.trees[1].push_back(block_cost(root));
    }
    for (const auto& tree : fleet.trees) {
        for (const BlockCost& block : tree) {
            fleet.geometry_bytes += block.bytes;
        }
    }
    std::mt19937_64 random(options.seed);
    for (std::uint64_t i = 0; i < options.count; ++i) {
        const std::uint64_t copy = random() % copies;
        const ScenarioTrace& from = depth->scenarios[random() % depth->scenarios.size()];
        fleet.scenarios.push_back(static_cast<std::uint32_t>(i));
        fleet.costs.push_back(scaled_cost(from, static_cast<RootIndex>(copy * roots), options));
        fleet.serial_seconds += fleet.costs.back().work_seconds;
    }
    return fleet;
}

} // namespace cd::bench
