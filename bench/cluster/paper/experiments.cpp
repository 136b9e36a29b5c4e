#include "bench/cluster/paper/experiments.hpp"

#include "bench/cluster/paper/pipe_fit.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/timing/master.hpp"
#include "common/core/timing/worker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace cd::bench {

namespace {

constexpr double fitted_analysis_seconds = 0.003;

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
    const double weight = cluster.weighted_ratio(workload.slow_ratio);
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

Setting client_first_setting(double pipe_bytes_per_second) {
    Setting setting = fitted_setting(pipe_bytes_per_second);
    setting.name = "client-first";
    setting.analysis_seconds = fitted_analysis_seconds;
    setting.is_client_first = true;
    setting.seeds_max = 2;
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
    setting.options.results_period = timing::results_wait_seconds_min;
    return setting;
}

Experiments::Experiments(const ExperimentOptions& options)
    : options_(options), csv_(options.out / "runs.csv", columns) {}

template <class T>
std::vector<T> Experiments::series(std::vector<T> all) const {
    return options_.quick ? std::vector<T>{all.front(), all[all.size() / 2], all.back()} : all;
}

std::vector<ComparedStrategy> Setting::strategies() const {
    if (is_client_first) {
        return {client_first_strategies.begin(), client_first_strategies.end()};
    }
    return {compared_strategies.begin(), compared_strategies.end()};
}

SimulationOptions Setting::options_for(const ComparedStrategy& strategy,
                                       const Point& point,
                                       std::uint64_t seed) const {
    SimulationOptions filled = options;
    filled.cluster.fast_cores = point.fast_cores;
    filled.cluster.slow_cores = point.slow_cores;
    filled.dispatch.strategy = strategy.strategy;
    filled.dispatch.q = point.q;
    // The paper's V is a share of the master's memory, far above any batch of scenarios.
    filled.dispatch.v_kb = limits::v_kb_max;
    filled.dispatch.claim = may_claim && strategy.claims;
    filled.dispatch.seed = seed;
    filled.variation = strategy.variation;
    filled.peers = strategy.peers;
    if (strategy.sees_queue) {
        filled.ahead = 0;
    }
    return filled;
}

void Experiments::run(const Setting& setting, const Scene& scene, const Point& point) {
    best_seconds_ = 0;
    for (std::uint64_t seed = 1; seed <= options_.seeds_of(setting); ++seed) {
        const Workload workload = make_workload(
            *scene.trace,
            *scene.table,
            {setting.costs, point.depth, point.count, seed, setting.analysis_seconds});
        for (const ComparedStrategy& strategy : setting.strategies()) {
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
            if (strategy.name() == setting.best()) {
                best_seconds_ += outcome->seconds / static_cast<double>(options_.seeds_of(setting));
            }
        }
    }
    std::printf("%s, %s: %s %g: %s %.4g s\n",
                setting.name.c_str(),
                scene.trace->name.c_str(),
                point.experiment.c_str(),
                point.x,
                setting.best(),
                best_seconds_);
    std::fflush(stdout);
}

std::optional<Outcome> Experiments::simulate_one(const Setting& setting,
                                                 const Scene& scene,
                                                 const Workload& workload,
                                                 const ComparedStrategy& strategy,
                                                 const Point& point,
                                                 std::uint64_t seed) {
    SimulationOptions options = setting.options_for(strategy, point, seed);
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
        if (best_seconds == 0 || best_seconds_ < best_seconds) {
            best_seconds = best_seconds_;
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

std::optional<double> Experiments::mean_lowest(const Setting& setting, const Scene& scene) {
    Point point;
    point.depth = scene.depth;
    double sum = 0;
    std::uint64_t ended = 0;
    for (std::uint64_t seed = 1; seed <= options_.seeds_of(setting); ++seed) {
        const Workload workload =
            make_workload(*scene.trace,
                          *scene.table,
                          {setting.costs, point.depth, 0, seed, setting.analysis_seconds});
        const auto outcome = simulate_one(setting, scene, workload, setting.lowest(), point, seed);
        sum += outcome ? outcome->seconds : 0;
        ended += outcome ? 1 : 0;
    }
    return ended > 0 ? std::optional(sum / static_cast<double>(ended)) : std::nullopt;
}

std::optional<double>
Experiments::fit_pipe(Setting (*setting_of)(double), const Scene& scene, double seconds) {
    const auto seconds_at = [&](double rate) {
        const auto taken = mean_lowest(setting_of(rate), scene);
        std::printf("pipe of %.1f MB/s: %.0f s\n", 1e-6 * rate, taken.value_or(0));
        std::fflush(stdout);
        return taken;
    };
    // Bisection only finds the region of the rate. It cannot find the rate itself, because the
    // simulated time varies by up to a sixth between rates that differ by a few percent.
    double slow = 1e6;
    double fast = 1e9;
    if (seconds_at(fast).value_or(seconds) >= seconds) {
        return std::nullopt;
    }
    while (fast / slow > 1.2) {
        const double rate = std::sqrt(slow * fast);
        (seconds_at(rate).value_or(seconds) > seconds ? slow : fast) = rate;
    }
    std::vector<TimeAtRate> times;
    for (double factor = 0.5; factor < 2.1; factor *= std::pow(2, 0.25)) {
        const double rate = factor * std::sqrt(slow * fast);
        if (const auto taken = seconds_at(rate)) {
            times.push_back({rate, *taken});
        }
    }
    return rate_on_line(times, seconds);
}

} // namespace cd::bench
