// Predicts by simulation the time of a job on one computer that runs the master and workers of one
// thread, to compare it with a real run there. See `prediction`.
//
//   predict TRACE --cores N --workers N --strategy NAME --depth D
//   predict TRACE --cores N --workers N --ranges --depth D
#include "bench/cluster/paper/experiments.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>

namespace cd::bench {

namespace {

struct Computer {
    std::uint32_t cores = 1;
    std::uint32_t workers = 1;
};

/// Uses the product's settings: its master analyses on every core.
SimulationOptions options_of(const Computer& computer, std::string_view strategy) {
    SimulationOptions options = measured_setting().options;
    options.cluster.shared_cores = computer.cores;
    options.cluster.fast_cores = computer.workers;
    options.cluster.slow_cores = 0;
    options.analysts = computer.cores;
    options.dispatch.strategy = strategy;
    options.dispatch.claim = false;
    options.peers = true;
    return options;
}

/// The workload of a job in ranges, whose workers look for the colliding roots.
Workload in_ranges(Workload workload) {
    for (ScenarioCost& cost : workload.costs) {
        cost.work_seconds += std::exchange(cost.analysis_seconds, 0);
    }
    return workload;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    using namespace cd;
    using namespace cd::bench;
    std::filesystem::path path;
    Computer computer;
    std::string name = "earliest-finish";
    std::uint32_t depth = 12;
    bool are_ranges = false;
    CLI::App app("Predicts the seconds of a job on one computer");
    app.add_option("TRACE", path, "The job's trace")->required();
    app.add_option("--cores", computer.cores, "Of the computer")->check(CLI::PositiveNumber);
    app.add_option("--workers", computer.workers, "Of one thread")->check(CLI::PositiveNumber);
    app.add_option("--strategy", name, "How workers are chosen");
    app.add_option("--depth", depth, "At which A is cut");
    app.add_flag("--ranges", are_ranges, "Workers get ranges, which the master does not analyse");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto trace = read_trace(path);
        const bool is_strategy = find_strategy(name) != nullptr;
        if (!trace || !is_strategy || trace.value().at(depth) == nullptr) {
            std::fprintf(stderr,
                         "%s\n",
                         !trace         ? trace.error().detail.c_str()
                         : !is_strategy ? "there is no such strategy"
                                        : "the trace does not have the depth");
            return 2;
        }
        Workload workload =
            make_workload(trace.value(), paper_table_heavy, {Costs::Measured, depth});
        SimulationOptions options = options_of(computer, name);
        if (are_ranges) {
            workload = in_ranges(std::move(workload));
            options.analysis = AnalysisMode::Never;
        }
        constexpr std::chrono::seconds limit{300};
        // The first run measures the coordinator's time; the second charges it.
        const auto uncharged = simulate_apart(workload, options, limit);
        options.dispatch_seconds = uncharged ? 1e-6 * uncharged->coordinator_us : 0;
        const auto outcome = simulate_apart(workload, options, limit);
        if (!uncharged || !outcome) {
            std::fprintf(stderr, "the simulation does not end\n");
            return 2;
        }
        std::printf("%.4f\n", outcome->seconds);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
