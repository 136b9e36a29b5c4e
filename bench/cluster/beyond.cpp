// Simulates clusters far larger than the paper's, over recorded traces. See README.md.
//
//   beyond TRACE --out FOLDER [--depth 8] [--quick] [--many]
#include "bench/accuracy/csv.hpp"
#include "bench/cluster/model/baselines.hpp"
#include "bench/cluster/model/fleet.hpp"
#include "bench/cluster/model/large_cluster.hpp"
#include "bench/cluster/model/strategies.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

namespace cd::bench {

namespace {

constexpr std::uint64_t cache_bytes = 2'000'000'000;

struct Options {
    std::filesystem::path trace;
    std::filesystem::path out;
    std::uint32_t depth = 8;
    bool quick = false;
    bool many = false;
};

/// One cluster and its job.
struct Case {
    std::size_t hosts = 0;
    std::uint64_t each = 0; ///< Mean number of scenario groups per host.
    double gigabits = 1;
};

/// Returns a tenth of the speed for every second host.
std::vector<double> unlike_speeds(std::size_t hosts) {
    std::vector<double> speeds(hosts, 1.0);
    for (std::size_t host = 1; host < hosts; host += 2) {
        speeds[host] = 0.1;
    }
    return speeds;
}

class Beyond {
  public:
    explicit Beyond(const Options& options)
        : depth_(options.depth),
          csv_(options.out / "beyond.csv",
               {"hosts",
                "gigabits",
                "way",
                "scenarios",
                "geometry_mb",
                "serial_seconds",
                "seconds",
                "speedup",
                "bound",
                "sent_mb",
                "sent_by_geometry",
                "peer_mb",
                "received_mb",
                "evictions",
                "start_share",
                "between_share",
                "tail_share",
                "coordinator_us",
                "fits"}) {}

    void run(const Trace& trace, const Case& one) {
        FleetOptions fleet;
        fleet.depth = depth_;
        fleet.count = one.each * one.hosts;
        const Workload workload = make_fleet(trace, fleet);
        LargeOptions options;
        options.speeds = unlike_speeds(one.hosts);
        options.bytes_per_second = 125e6 * one.gigabits;
        options.cache_bytes = cache_bytes;
        options.charges_coordinator = true;
        options.dispatch.v_kb = 16'384;
        options.dispatch.q = 4;
        for (const ComparedStrategy& compared :
             {ComparedStrategy{"earliest-finish", false, true, true},
              ComparedStrategy{"earliest-finish", false, true, false},
              ComparedStrategy{"best-match", false, false, true},
              ComparedStrategy{"random", false, false, true}}) {
            options.dispatch.strategy = compared.strategy;
            options.dispatch.claim = compared.claims;
            options.peers = compared.peers;
            const LargeOutcome outcome = simulate_large(workload, options);
            std::printf("%zu hosts, %g Gb/s, %s: %.4g s\n",
                        one.hosts,
                        one.gigabits,
                        compared.name().c_str(),
                        outcome.seconds);
            std::fflush(stdout);
            add(one, workload, options.speeds, compared.name(), outcome, true);
        }
        const double rate = options.bytes_per_second;
        add(one,
            workload,
            options.speeds,
            "static split",
            static_split(workload, options.speeds, rate));
        add(one,
            workload,
            options.speeds,
            "whole geometry everywhere",
            whole_everywhere(workload, options.speeds, rate));
        add(one,
            workload,
            options.speeds,
            "offline optimum",
            offline_optimum(workload, options.speeds, rate));
    }

  private:
    void add(const Case& one,
             const Workload& workload,
             const std::vector<double>& speeds,
             const std::string& way,
             const BaselineOutcome& baseline) {
        LargeOutcome outcome;
        outcome.seconds = baseline.seconds;
        outcome.sent_bytes = baseline.sent_bytes;
        add(one, workload, speeds, way, outcome, baseline.memory_bytes_max <= cache_bytes);
    }

    void add(const Case& one,
             const Workload& workload,
             const std::vector<double>& speeds,
             const std::string& way,
             const LargeOutcome& outcome,
             bool fits) {
        const auto megabytes = [](std::uint64_t bytes) {
            return cell(1e-6 * static_cast<double>(bytes));
        };
        const FleetOptions fleet;
        csv_.row({cell(std::uint64_t{one.hosts}),
                  cell(one.gigabits),
                  way,
                  cell(workload.count() * fleet.together),
                  megabytes(workload.geometry_bytes),
                  cell(workload.serial_seconds),
                  cell(outcome.seconds),
                  cell(workload.serial_seconds / outcome.seconds),
                  cell(std::accumulate(speeds.begin(), speeds.end(), 0.0)),
                  megabytes(outcome.sent_bytes),
                  cell(static_cast<double>(outcome.sent_bytes) /
                       static_cast<double>(workload.geometry_bytes)),
                  megabytes(outcome.peer_bytes),
                  megabytes(outcome.received_bytes),
                  cell(outcome.evictions),
                  cell(outcome.start_share),
                  cell(outcome.between_share),
                  cell(outcome.tail_share),
                  cell(outcome.coordinator_us / static_cast<double>(fleet.together)),
                  fits ? "yes" : "no"});
    }

    std::uint32_t depth_;
    CsvFile csv_;
};

void run(const Options& options, const Trace& trace) {
    std::filesystem::create_directories(options.out);
    Beyond beyond(options);
    std::vector<Case> all{{1000, 20, 1}, {1000, 20, 10}};
    if (options.many) {
        all.insert(all.end(), {{10'000, 5, 1}, {10'000, 5, 10}});
    }
    const std::vector<Case> few{{100, 20, 1}};
    for (const Case& one : options.quick ? few : all) {
        beyond.run(trace, one);
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    CLI::App app("Simulates clusters of thousands of hosts");
    app.add_option("TRACE", options.trace, "Of a heavy vehicle against a car")->required();
    app.add_option("--out", options.out, "A folder for beyond.csv")->required();
    app.add_option("--depth", options.depth, "At which the bodies are cut");
    app.add_flag("--many", options.many, "10,000 hosts as well; takes long");
    app.add_flag("--quick", options.quick, "One small cluster");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto trace = cd::bench::read_trace(options.trace);
        if (!trace) {
            std::fprintf(stderr, "%s\n", trace.error().detail.c_str());
            return 2;
        }
        cd::bench::run(options, trace.value());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
