#include "bench/cluster/paper/additions.hpp"

#include "bench/accuracy/csv.hpp"
#include "common/core/limits/master.hpp"

#include <string>
#include <utility>

namespace cd::bench {

void compare_additions(const ExperimentOptions& experiment,
                       const std::vector<Setting>& settings,
                       const Scene& scene) {
    CsvFile csv(experiment.out / "additions.csv",
                {"setting",
                 "scene",
                 "depth",
                 "slow_ratio",
                 "bits_per_second",
                 "peers",
                 "hints",
                 "helps",
                 "seed",
                 "seconds",
                 "speedup",
                 "bound",
                 "tail_share",
                 "recalled",
                 "copies"});
    const auto yes_or_no = [](bool is) { return std::string(is ? "yes" : "no"); };
    const auto compare = [&](const Setting& setting,
                             const Workload& workload,
                             std::uint64_t seed,
                             double bytes_per_second) {
        SimulationOptions options = setting.options;
        options.ahead = 0;
        options.dispatch.strategy = "earliest-finish";
        options.dispatch.v_kb = limits::v_kb_max;
        options.cluster.bytes_per_second = bytes_per_second;
        for (const bool peers : {false, true}) {
            for (const auto& [hints, helps] :
                 {std::pair(false, false), std::pair(false, true), std::pair(true, true)}) {
                options.peers = peers;
                options.dispatch.hints = hints;
                options.helps_at_end = helps;
                if (const auto outcome = simulate_apart(workload, options, experiment.limit)) {
                    csv.row({setting.name,
                             scene.trace->name,
                             std::to_string(scene.depth),
                             cell(workload.slow_ratio),
                             cell(8 * options.cluster.bytes_per_second),
                             yes_or_no(peers),
                             yes_or_no(hints),
                             yes_or_no(helps),
                             cell(seed),
                             cell(outcome->seconds),
                             cell(workload.serial_seconds / outcome->seconds),
                             cell(options.cluster.weighted_cores(workload.slow_ratio)),
                             cell(outcome->tail_share),
                             cell(outcome->recalled),
                             cell(outcome->copies)});
                }
            }
        }
    };
    for (const Setting& setting : settings) {
        for (std::uint64_t seed = 1; seed <= experiment.seeds_of(setting); ++seed) {
            Workload workload =
                make_workload(*scene.trace, *scene.table, {setting.costs, scene.depth, 0, seed});
            const double slow_ratio = workload.slow_ratio;
            for (const auto& [ratio, bytes_per_second] : {std::pair(slow_ratio, 125e6),
                                                          std::pair(10.0, 125e6),
                                                          std::pair(slow_ratio, 12.5e6)}) {
                workload.slow_ratio = ratio;
                compare(setting, workload, seed, bytes_per_second);
            }
        }
    }
}

} // namespace cd::bench
