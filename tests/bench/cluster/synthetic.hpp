// Small jobs with invented costs, for the bookkeeping of simulated clusters.
#pragma once

#include "bench/cluster/model/workload.hpp"

#include <random>
#include <utility>

namespace cd::tests {

/// Each scenario touches a few of A's 40 roots and one of B's 8.
inline bench::Workload make_synthetic_workload(std::uint64_t seed, std::size_t scenarios) {
    std::mt19937_64 random(seed);
    bench::Workload workload;
    for (std::size_t root = 0; root < 40; ++root) {
        workload.trees[0].push_back({30, 1000 + random() % 100'000, 5000, 1e-4});
    }
    for (std::size_t root = 0; root < 8; ++root) {
        workload.trees[1].push_back({50, 2000 + random() % 100'000, 7000, 1e-4});
    }
    workload.slow_ratio = 1.6;
    for (std::size_t i = 0; i < scenarios; ++i) {
        const std::uint64_t centiseconds = 1 + random() % 9;
        bench::ScenarioCost cost{1e-3,
                                 1e-2 * static_cast<double>(centiseconds),
                                 300,
                                 900,
                                 centiseconds * 8'000'000, // Less than the actual time.
                                 {}};
        for (RootIndex root = 0; root < 40; ++root) {
            if (random() % 8 == 0) {
                cost.blocks.push_back({0, root});
            }
        }
        cost.blocks.push_back({1, static_cast<RootIndex>(random() % 8)});
        workload.serial_seconds += cost.work_seconds;
        workload.scenarios.push_back(static_cast<std::uint32_t>(i));
        workload.costs.push_back(std::move(cost));
    }
    for (const auto& tree : workload.trees) {
        for (const bench::BlockCost& block : tree) {
            workload.geometry_bytes += block.bytes;
        }
    }
    return workload;
}

} // namespace cd::tests
