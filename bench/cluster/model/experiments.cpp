#include "bench/cluster/model/experiments.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/timing/worker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace cd::bench {

namespace {

const std::vector<std::string> columns{"setting",
                                       "scene",
                                       "experiment",
                                       "x",
                                       "strategy",
                                       "seed",
                                       "scenarios",
                                       "depth",
                                       "q",
                                       "fast_cores",
                                       "slow_cores",
                                       "seconds",
                                       "serial_seconds",
                                       "speedup",
                                       "bound",
                                       "paper_speedup",
                                       "paper_bound",
                                       "transfer",
                                       "sent_mb",
                                       "block_mb",
                                       "received_mb",
                                       "memory_max_mb",
                                       "memory_sum_mb",
                                       "master_share",
                                       "worker_share",
                                       "start_share",
                                       "between_share",
                                       "tail_share",
                                       "peer_mb",
                                       "coordinator_us",
                                       "batches"};

double megabytes(std::uint64_t bytes) {
    return 1e-6 * static_cast<double>(bytes);
}

/// Returns the paper's weighted serial time (7.1) relative to that of a fast core.
double weighted_ratio(const ClusterSpec& cluster, double slow_ratio) {
    return (cluster.fast_cores + cluster.slow_cores * slow_ratio) / cluster.cores();
}

std::vector<std::string> row_of(const Setting& setting,
                                const Scene& scene,
                                const Point& point,
                                const ComparedStrategy& strategy,
                                std::uint64_t seed,
                                const Workload& workload,
                                const Outcome& outcome) {
    ClusterSpec cluster = setting.options.cluster;
    cluster.fast_cores = point.fast_cores;
    cluster.slow_cores = point.slow_cores;
    const double bound = cluster.weighted_cores(workload.slow_ratio);
    const double weight = weighted_ratio(cluster, workload.slow_ratio);
    const double speedup = workload.serial_seconds / outcome.seconds;
    return {setting.name,
            scene.trace->name,
            point.experiment,
            cell(point.x),
            strategy.name(),
            cell(seed),
            cell(workload.count()),
            cell(std::uint64_t{point.depth}),
            cell(std::uint64_t{point.q}),
            cell(std::uint64_t{point.fast_cores}),
            cell(std::uint64_t{point.slow_cores}),
            cell(outcome.seconds),
            cell(workload.serial_seconds),
            cell(speedup),
            cell(bound),
            cell(speedup * weight),
            cell(bound * weight),
            cell(static_cast<double>(outcome.sent_bytes) /
                 static_cast<double>(workload.geometry_bytes)),
            cell(megabytes(outcome.sent_bytes)),
            cell(megabytes(outcome.block_bytes)),
            cell(megabytes(outcome.received_bytes)),
            cell(megabytes(outcome.memory_bytes_max)),
            cell(megabytes(outcome.memory_bytes_sum)),
            cell(outcome.master_seconds / outcome.seconds),
            cell(outcome.work_seconds / outcome.seconds / bound),
            cell(outcome.start_share),
            cell(outcome.between_share),
            cell(outcome.tail_share),
            cell(megabytes(outcome.peer_bytes)),
            cell(outcome.coordinator_us),
            cell(outcome.batches)};
}

} // namespace

Setting paper_setting() {
    Setting setting;
    setting.name = "unfitted";
    return setting;
}

Setting fitted_setting(double pipe_bytes_per_second) {
    Setting setting = paper_setting();
    setting.name = "fitted";
    setting.options.pipe_bytes_per_second = pipe_bytes_per_second;
    return setting;
}

Setting measured_setting() {
    Setting setting;
    setting.name = "measured";
    setting.costs = Costs::Measured;
    setting.may_claim = false;
    setting.seeds_max = 1;
    setting.options.cluster.worker_per_computer = true;
    setting.options.ahead = 0;
    setting.options.analysts = setting.options.cluster.fast_cores_each - 1;
    setting.options.results_period =
        std::chrono::duration<double>(timing::results_flush_period).count();
    return setting;
}

Experiments::Experiments(const ExperimentOptions& options)
    : options_(options), csv_(options.out / "runs.csv", columns) {}

template <class T>
std::vector<T> Experiments::series(std::vector<T> all) const {
    return options_.quick ? std::vector<T>{all.front(), all[all.size() / 2], all.back()} : all;
}

void Experiments::run(const Setting& setting, const Scene& scene, const Point& point) {
    best_match_seconds_ = 0;
    for (std::uint64_t seed = 1; seed <= seeds(setting); ++seed) {
        const Workload workload = make_workload(
            *scene.trace, *scene.table, {setting.costs, point.depth, point.count, seed});
        for (const ComparedStrategy& strategy : compared_strategies) {
            const auto outcome = simulate_one(setting, scene, workload, strategy, point, seed);
            if (!outcome) {
                std::fprintf(stderr,
                             "no end: %s %s %s %g %s\n",
                             setting.name.c_str(),
                             scene.trace->name.c_str(),
                             point.experiment.c_str(),
                             point.x,
                             strategy.name().c_str());
                continue;
            }
            csv_.row(row_of(setting, scene, point, strategy, seed, workload, *outcome));
            if (strategy.strategy == "best-match") {
                best_match_seconds_ += outcome->seconds / static_cast<double>(seeds(setting));
            }
        }
    }
    std::printf("%s, %s: %s %g: best-match %.4g s\n",
                setting.name.c_str(),
                scene.trace->name.c_str(),
                point.experiment.c_str(),
                point.x,
                best_match_seconds_);
    std::fflush(stdout);
}

std::optional<Outcome> Experiments::simulate_one(const Setting& setting,
                                                 const Scene& scene,
                                                 const Workload& workload,
                                                 const ComparedStrategy& strategy,
                                                 const Point& point,
                                                 std::uint64_t seed) {
    SimulationOptions options = setting.options;
    options.cluster.fast_cores = point.fast_cores;
    options.cluster.slow_cores = point.slow_cores;
    options.dispatch.strategy = strategy.strategy;
    options.dispatch.q = point.q;
    // The paper's V is a share of the master's memory, far above any batch of scenarios.
    options.dispatch.v_kb = limits::v_kb_max;
    options.dispatch.claim = setting.may_claim && strategy.claims;
    options.dispatch.seed = seed;
    options.peers = strategy.peers;
    if (strategy.sees_queue) {
        options.ahead = 0;
    }
    if (setting.costs == Costs::Measured) {
        options.dispatch_seconds = dispatch_seconds(scene, workload, point, options);
    }
    return simulate_apart(workload, options, options_.limit);
}

double Experiments::dispatch_seconds(const Scene& scene,
                                     const Workload& workload,
                                     const Point& point,
                                     const SimulationOptions& uncharged) {
    const std::tuple key(
        scene.trace->name, uncharged.dispatch.strategy, uncharged.peers, point.depth);
    const auto known = dispatch_seconds_.find(key);
    if (known != dispatch_seconds_.end()) {
        return known->second;
    }
    const auto outcome = simulate_apart(workload, uncharged, options_.limit);
    const double seconds = outcome ? 1e-6 * outcome->coordinator_us : 0;
    dispatch_seconds_.emplace(key, seconds);
    return seconds;
}

void Experiments::vary_scenarios(const Setting& setting, const Scene& scene) {
    const auto& counts = scene.table->scenarios;
    for (const std::uint64_t count : series(std::vector(counts.begin(), counts.end()))) {
        Point point;
        point.experiment = "scenarios";
        point.count = scene.trace->whole.size() * count / counts.back();
        point.x = static_cast<double>(point.count);
        point.depth = scene.depth;
        run(setting, scene, point);
    }
}

void Experiments::vary_rounds(const Setting& setting,
                              const Scene& scene,
                              const std::vector<std::uint64_t>& rounds) {
    for (const std::uint64_t times : rounds) {
        Point point;
        point.experiment = "scenarios";
        point.count = times * scene.trace->whole.size();
        point.x = static_cast<double>(point.count);
        point.depth = scene.depth;
        run(setting, scene, point);
    }
}

void Experiments::at_paper_depth(const Setting& setting, const Scene& scene) {
    if (scene.trace->at(scene.paper_depth) == nullptr) {
        return;
    }
    Point point;
    point.experiment = "paper depth";
    point.x = scene.paper_depth;
    point.depth = scene.paper_depth;
    run(setting, scene, point);
}

std::uint32_t
Experiments::vary_depth(const Setting& setting, const Scene& scene, std::uint64_t count) {
    std::vector<std::uint32_t> depths;
    for (const DepthTrace& depth : scene.trace->depths) {
        depths.push_back(depth.a.depth);
    }
    std::uint32_t best_depth = depths.front();
    double best_seconds = 0;
    for (const std::uint32_t depth : depths) {
        Point point;
        point.experiment = "depth";
        point.x = depth;
        point.count = count;
        point.depth = depth;
        run(setting, scene, point);
        if (best_seconds == 0 || best_match_seconds_ < best_seconds) {
            best_seconds = best_match_seconds_;
            best_depth = depth;
        }
    }
    return best_depth;
}

void Experiments::vary_q(const Setting& setting, const Scene& scene, std::uint64_t count) {
    for (const std::uint32_t q : series<std::uint32_t>({5, 10, 20, 40, 80})) {
        Point point;
        point.experiment = "q";
        point.x = q;
        point.count = count;
        point.depth = scene.depth;
        point.q = q;
        run(setting, scene, point);
    }
}

void Experiments::vary_cores(const Setting& setting, const Scene& scene, std::uint64_t count) {
    // Table 4.
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> clusters{
        {12, 0}, {16, 0}, {16, 6}, {20, 8}};
    const double slow_ratio = scene.table->slow_seconds.back() / scene.table->fast_seconds.back();
    for (const auto& [fast, slow] : series(clusters)) {
        Point point;
        point.experiment = "cores";
        point.count = count;
        point.depth = scene.depth;
        point.fast_cores = fast;
        point.slow_cores = slow;
        point.x = fast + slow / slow_ratio;
        run(setting, scene, point);
    }
}

void Experiments::compare_additions(const std::vector<Setting>& settings, const Scene& scene) {
    CsvFile csv(options_.out / "additions.csv",
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
                if (const auto outcome = simulate_apart(workload, options, options_.limit)) {
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
        for (std::uint64_t seed = 1; seed <= seeds(setting); ++seed) {
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

double Experiments::mean_lowest(const Setting& setting, const Scene& scene) {
    Point point;
    point.depth = scene.depth;
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= seeds(setting); ++seed) {
        const Workload workload =
            make_workload(*scene.trace, *scene.table, {setting.costs, point.depth, 0, seed});
        const auto outcome =
            simulate_one(setting, scene, workload, {"lowest", true, false}, point, seed);
        sum += outcome ? outcome->seconds : 0;
    }
    return sum / static_cast<double>(seeds(setting));
}

std::optional<double> Experiments::fit_pipe(const Scene& scene, double seconds) {
    // Bisects on a logarithmic scale, to within 1 %.
    double slow = 1e6;
    double fast = 1e9;
    if (mean_lowest(fitted_setting(fast), scene) > seconds) {
        return std::nullopt;
    }
    while (fast / slow > 1.01) {
        const double rate = std::sqrt(slow * fast);
        (mean_lowest(fitted_setting(rate), scene) > seconds ? slow : fast) = rate;
    }
    return std::sqrt(slow * fast);
}

} // namespace cd::bench
