#include "bench/cluster/ranges/range_job.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <random>

namespace cd::bench {

namespace {

std::uint64_t wire_bytes(const Trace& trace, const DepthTrace& depth) {
    std::uint64_t bytes = depth.a.top_bytes + trace.b.top_bytes;
    for (const CutTrace* cut : {&depth.a, &trace.b}) {
        for (const RootTrace& root : cut->roots) {
            bytes += root.compressed_bytes;
        }
    }
    return bytes;
}

} // namespace

Workload make_range_job(const Trace& trace, const RangeJobOptions& options) {
    const DepthTrace* depth = trace.at(options.depth);
    CD_CHECK(depth != nullptr);
    const double size = static_cast<double>(options.geometry_bytes) /
                        static_cast<double>(wire_bytes(trace, *depth));
    const auto scaled = [size](std::uint64_t bytes) {
        return static_cast<std::uint64_t>(size * static_cast<double>(bytes));
    };
    Workload job;
    const CutTrace* const cuts[] = {&depth->a, &trace.b};
    for (std::size_t tree = 0; tree < job.trees.size(); ++tree) {
        job.tops[tree] = {0, scaled(cuts[tree]->top_bytes), 0, 0};
        job.geometry_bytes += job.tops[tree].bytes;
        for (const RootTrace& root : cuts[tree]->roots) {
            job.trees[tree].push_back({root.triangles,
                                       scaled(root.compressed_bytes),
                                       scaled(root.memory_bytes),
                                       size * root.open_seconds});
            job.geometry_bytes += job.trees[tree].back().bytes;
        }
    }
    double recorded = 0;
    for (const ScenarioTrace& from : depth->scenarios) {
        recorded += from.analysis_seconds + from.work_seconds;
    }
    const double slower =
        options.scenario_seconds * static_cast<double>(depth->scenarios.size()) / recorded;
    for (const ScenarioTrace& from : depth->scenarios) {
        ScenarioCost& cost = job.costs.emplace_back();
        cost.work_seconds = slower * (from.analysis_seconds + from.work_seconds);
        cost.result_bytes = options.result_bytes;
        for (const RootIndex root : from.roots_a) {
            cost.blocks.push_back({0, root});
        }
        for (const RootIndex root : from.roots_b) {
            cost.blocks.push_back({1, root});
        }
    }
    std::mt19937_64 random(options.seed);
    job.scenarios.reserve(options.count);
    while (job.scenarios.size() < options.count) {
        const auto drawn = static_cast<std::uint32_t>(random() % job.costs.size());
        const std::uint64_t left = options.count - job.scenarios.size();
        job.scenarios.insert(job.scenarios.end(), std::min(options.together, left), drawn);
    }
    for (const std::uint32_t cost : job.scenarios) {
        job.serial_seconds += job.costs[cost].work_seconds;
    }
    return job;
}

double RangeLimits::largest() const {
    return std::max({compute, geometry, master});
}

RangeLimits limits_of(const Workload& workload,
                      std::uint64_t hosts,
                      std::uint32_t threads,
                      double bytes_per_second,
                      double result_seconds) {
    RangeLimits limits;
    const auto all = static_cast<double>(hosts);
    limits.compute = workload.serial_seconds / (all * threads);
    limits.geometry = static_cast<double>(workload.geometry_bytes) / bytes_per_second;
    limits.master = result_seconds * static_cast<double>(workload.count());
    return limits;
}

} // namespace cd::bench
