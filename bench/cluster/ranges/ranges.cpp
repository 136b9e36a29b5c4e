// Simulates jobs in ranges on thousands of hosts of several cores, from empty caches, beside what
// limits them. See README.md.
//
//   ranges TRACE --out FOLDER [--quick]
#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/machine.hpp"
#include "bench/cluster/model/large_cluster.hpp"
#include "bench/cluster/ranges/range_job.hpp"
#include "common/core/timing/worker.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace cd::bench {

namespace {

constexpr std::uint32_t threads = 4;
constexpr double bytes_per_second = 125e6; // 1 Gb/s.

struct Case {
    std::size_t hosts = 0;
    double scenario_seconds = 0;
    double result_seconds = 0; ///< Time of the master for each result.
    std::uint64_t count = 0;
};

/// What the master costs a scenario in `rate`, all threads, and what it should cost. The simulation
/// charges the coordinator's own time as well, so it counts that part twice.
constexpr double result_now = 1.0e-6;
constexpr double result_wanted = 0.3e-6;

std::vector<Case> cases(bool is_quick) {
    if (is_quick) {
        return {{20, 1e-4, result_now, 100'000}, {20, 1e-2, result_now, 10'000}};
    }
    std::vector<Case> all;
    // The master is the limit: 0.1 ms a scenario.
    for (const double result : {result_now, result_wanted}) {
        all.push_back({1000, 1e-4, result, 1'000'000});
        all.push_back({1000, 1e-4, result, 4'000'000});
    }
    // The hosts are.
    for (const std::uint64_t count :
         {250'000, 500'000, 1'000'000, 2'000'000, 4'000'000, 8'000'000}) {
        all.push_back({1000, 1e-2, result_now, count});
    }
    // Ten times as many hosts.
    all.push_back({10'000, 0.1, result_now, 4'000'000});
    all.push_back({10'000, 0.1, result_now, 16'000'000});
    return all;
}

void run(const Trace& trace, const Case& one, std::uint32_t depth, CsvFile& csv) {
    RangeJobOptions job;
    job.depth = depth;
    job.count = one.count;
    job.scenario_seconds = one.scenario_seconds;
    const Workload workload = make_range_job(trace, job);
    LargeOptions options;
    options.speeds.assign(one.hosts, 1.0);
    options.threads = threads;
    options.analysis = AnalysisMode::Never;
    options.bytes_per_second = bytes_per_second;
    options.at_once_seconds = timing::walk_seconds;
    options.result_seconds = one.result_seconds;
    options.charges_coordinator = true;
    const LargeOutcome outcome = simulate_large(workload, options);
    const RangeLimits limits =
        limits_of(workload, one.hosts, threads, bytes_per_second, one.result_seconds);
    csv.row({cell(std::uint64_t{one.hosts}),
             cell(std::uint64_t{threads}),
             cell(8e-9 * bytes_per_second),
             cell(1e3 * one.scenario_seconds),
             cell(1e6 * one.result_seconds),
             cell(workload.count()),
             cell(outcome.answered),
             cell(1e-6 * static_cast<double>(workload.geometry_bytes)),
             cell(limits.compute),
             cell(limits.geometry),
             cell(limits.master),
             cell(outcome.seconds),
             cell(limits.compute / outcome.seconds),
             cell(limits.largest() / outcome.seconds),
             cell(outcome.uploads_max),
             cell(1e-6 * static_cast<double>(outcome.block_bytes)),
             cell(1e-6 * static_cast<double>(outcome.peer_bytes)),
             cell(outcome.start_share),
             cell(outcome.between_share),
             cell(outcome.tail_share),
             cell(outcome.coordinator_us),
             cell(outcome.master_share)});
    std::printf("%zu hosts, %g ms, %llu scenarios: %.4g s, %.1f %% of the bound\n",
                one.hosts,
                1e3 * one.scenario_seconds,
                static_cast<unsigned long long>(one.count),
                outcome.seconds,
                100 * limits.compute / outcome.seconds);
    std::fflush(stdout);
}

void run_all(const Trace& trace,
             const std::filesystem::path& out,
             std::uint32_t depth,
             const std::vector<Case>& all) {
    std::filesystem::create_directories(out);
    write_machine(out, {});
    CsvFile csv(out / "ranges.csv",
                {"hosts",           "threads",          "gigabits",       "scenario_ms",
                 "result_us",       "scenarios",        "answered",       "geometry_mb",
                 "compute_seconds", "geometry_seconds", "master_seconds", "seconds",
                 "share",           "share_of_limit",   "uploads_max",    "block_mb",
                 "peer_mb",         "start_share",      "between_share",  "tail_share",
                 "coordinator_us",  "master_share"});
    for (const Case& one : all) {
        run(trace, one, depth, csv);
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    using namespace cd::bench;
    std::filesystem::path path;
    std::filesystem::path out;
    std::uint32_t depth = 6;
    bool is_quick = false;
    std::vector<double> only;
    CLI::App app("Simulates jobs in ranges on thousands of hosts");
    app.add_option("TRACE", path, "Of a heavy vehicle against a car")->required();
    app.add_option("--out", out, "A folder for ranges.csv")->required();
    app.add_option("--depth", depth, "At which A is cut");
    app.add_option("--case", only, "Only this: hosts, ms a scenario, us a result, scenarios")
        ->expected(4);
    app.add_flag("--quick", is_quick, "One small cluster");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto trace = read_trace(path);
        if (!trace) {
            std::fprintf(stderr, "%s\n", trace.error().detail.c_str());
            return 2;
        }
        std::vector<Case> all = cases(is_quick);
        if (!only.empty()) {
            all = {{static_cast<std::size_t>(only[0]),
                    1e-3 * only[1],
                    1e-6 * only[2],
                    static_cast<std::uint64_t>(only[3])}};
        }
        run_all(trace.value(), out, depth, all);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
