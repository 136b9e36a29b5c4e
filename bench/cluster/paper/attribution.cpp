#include "bench/cluster/paper/attribution.hpp"

#include <cstdio>
#include <string>
#include <vector>

namespace cd::bench {

namespace {

constexpr std::uint64_t seeds_all = 5;

struct Variant {
    ComparedStrategy strategy;
    bool longest_first = false;
    bool equal_predictions = false;
    bool helps_at_end = true;
    bool is_with_free_bytes = true; ///< Runs again with bytes that cost nothing.

    [[nodiscard]] std::string name() const {
        return strategy.name() + (longest_first ? ", longest first" : "") +
               (equal_predictions ? ", equal predictions" : "") +
               (helps_at_end ? "" : ", no help at the end");
    }
};

std::vector<Variant> variants() {
    std::vector<Variant> all;
    for (const bool peers : {false, true}) {
        for (std::size_t i = 0; i < 3; ++i) {
            all.push_back({client_first_strategies[i]});
            all.back().strategy.peers = peers;
            all.back().is_with_free_bytes = !peers;
        }
    }
    for (const bool longest_first : {false, true}) {
        for (const bool peers : {false, true}) {
            for (const std::string_view name : {"best-match", "random", "lowest"}) {
                // The longest can come first only if all are analysed before.
                all.push_back({{name, true, longest_first, peers}, longest_first});
                all.back().is_with_free_bytes = !longest_first && !peers;
            }
        }
    }
    const ComparedStrategy ours{"earliest-finish", false, true, true};
    ComparedStrategy without_peers = ours;
    without_peers.peers = false;
    ComparedStrategy blind = ours;
    blind.variation = Variation::Blind;
    all.insert(all.end(),
               {{ours},
                {blind},
                {without_peers},
                {ours, false, true},
                {ours, true},
                {ours, false, false, false}});
    return all;
}

} // namespace

std::vector<std::string> attribution_columns() {
    return {"setting",
            "scene",
            "depth",
            "q",
            "way",
            "bytes",
            "seed",
            "seconds",
            "speedup",
            "bound",
            "paper_speedup",
            "paper_bound",
            "sent_mb",
            "peer_mb",
            "master_share",
            "start_share",
            "between_share",
            "tail_share"};
}

void attribute(CsvFile& csv,
               const ExperimentOptions& experiment,
               const Setting& setting,
               const Scene& scene) {
    Point point;
    point.depth = scene.depth;
    const ClusterSpec& cluster = setting.options.cluster;
    for (const Variant& variant : variants()) {
        for (std::uint64_t seed = 1; seed <= (experiment.quick ? 1 : seeds_all); ++seed) {
            WorkloadOptions options{setting.costs, point.depth, 0, seed, setting.analysis_seconds};
            options.longest_first = variant.longest_first;
            options.equal_predictions = variant.equal_predictions;
            const Workload workload = make_workload(*scene.trace, *scene.table, options);
            const double bound = cluster.weighted_cores(workload.slow_ratio);
            const double weight = cluster.weighted_ratio(workload.slow_ratio);
            for (const bool bytes_cost : {true, false}) {
                if (!bytes_cost && !variant.is_with_free_bytes) {
                    continue;
                }
                SimulationOptions simulation = setting.options_for(variant.strategy, point, seed);
                simulation.helps_at_end = variant.helps_at_end;
                if (!bytes_cost) {
                    simulation.pipe_bytes_per_second = 0;
                    simulation.cluster.bytes_per_second = 1e12;
                }
                const auto outcome = simulate_apart(workload, simulation, experiment.limit);
                if (!outcome) {
                    std::fprintf(stderr, "no end: %s\n", variant.name().c_str());
                    continue;
                }
                const double speedup = workload.serial_seconds / outcome->seconds;
                csv.row({setting.name,
                         scene.trace->name,
                         cell(std::uint64_t{point.depth}),
                         cell(std::uint64_t{point.q}),
                         variant.name(),
                         bytes_cost ? "cost" : "free",
                         cell(seed),
                         cell(outcome->seconds),
                         cell(speedup),
                         cell(bound),
                         cell(speedup * weight),
                         cell(bound * weight),
                         cell(1e-6 * static_cast<double>(outcome->sent_bytes)),
                         cell(1e-6 * static_cast<double>(outcome->peer_bytes)),
                         cell(outcome->master_seconds / outcome->seconds),
                         cell(outcome->start_share),
                         cell(outcome->between_share),
                         cell(outcome->tail_share)});
            }
        }
        std::printf("%s: %s\n", scene.trace->name.c_str(), variant.name().c_str());
        std::fflush(stdout);
    }
}

} // namespace cd::bench
