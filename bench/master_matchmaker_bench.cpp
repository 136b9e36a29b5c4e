// Measures one decision of the master: the dispatcher that cdmaster uses takes an analysed scenario
// and picks its worker. By default the two trees have 10,000 roots, 256 workers hold half of them,
// and a scenario touches 500 roots.
//
// Each decision is timed alone, in this thread's time and wall time. Counters show the median and
// the 99th percentile of both, in microseconds, and a checksum over which worker got which
// scenario, which exposes a faster wrong answer.
#include "bench/timed_work.hpp"
#include "master/dispatch/dispatcher.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>
#include <vector>

namespace cd::bench {
namespace {

constexpr JobId job{1};
constexpr std::uint32_t roots_per_tree = 5000;

std::vector<RootIndex> some_roots(std::mt19937_64& random, std::size_t count) {
    // A run of neighbours and some strays, as in a real scenario.
    const auto begin = static_cast<RootIndex>(random() % roots_per_tree);
    std::vector<RootIndex> roots;
    for (std::size_t i = 0; i < count; ++i) {
        const auto stray = static_cast<RootIndex>(random() % roots_per_tree);
        const auto next = static_cast<RootIndex>((begin + i) % roots_per_tree);
        roots.push_back(i % 5 == 0 ? stray : next);
    }
    std::ranges::sort(roots);
    const auto rest = std::ranges::unique(roots);
    roots.erase(rest.begin(), rest.end());
    return roots;
}

/// A dispatcher in the middle of a job, whose workers hold half of all roots.
class Midway {
  public:
    Midway(std::string_view strategy, std::uint64_t workers, std::size_t roots_touched)
        : roots_touched_(roots_touched) {
        ClusterOptions options;
        options.strategy = strategy;
        options.q = 1u << 16; // Buffers never fill, so that a decision sends no batch.
        options.v_kb = 1u << 22;
        (void)dispatcher_.job_opened(job, options, {tree(1), tree(2)});
        for (std::uint64_t id = 1; id <= workers; ++id) {
            (void)dispatcher_.worker_joined(WorkerId{id}, {"w", 8});
            (void)dispatcher_.scenario_analysed(job, scenario(roots_per_tree));
        }
        std::vector<RootIndex> all_roots(roots_per_tree);
        std::iota(all_roots.begin(), all_roots.end(), 0);
        // Workers that joined late were chosen for blocks that nobody held; each now drops another
        // half.
        for (std::uint64_t id = 1; id <= workers; ++id) {
            for (const TreeId tree : {TreeId{1}, TreeId{2}}) {
                std::vector<RootIndex> gone;
                for (RootIndex root = 0; root < roots_per_tree; ++root) {
                    if (random_() % 2 == 0) {
                        gone.push_back(root);
                    }
                }
                (void)dispatcher_.roots_evicted(WorkerId{id}, tree, gone);
                dispatcher_.roots_arrived(WorkerId{id}, tree, all_roots);
            }
        }
    }

    AnalysedScenario scenario() { return scenario(roots_touched_ / 2); }
    void decide(AnalysedScenario analysed) {
        benchmark::DoNotOptimize(dispatcher_.scenario_analysed(job, std::move(analysed)));
    }
    /// Returns a checksum of each worker's scenarios.
    [[nodiscard]] double checksum() {
        Checksum sum;
        for (const Action& action : dispatcher_.input_paused()) {
            const auto& unit = std::get<SendUnit>(action);
            sum.add(unit.worker.value);
            sum.add_all(unit.positions.list());
        }
        return sum.value();
    }

  private:
    DispatchTree tree(std::uint64_t id) {
        DispatchTree tree{TreeId{id}, {}};
        for (std::uint32_t root = 0; root < roots_per_tree; ++root) {
            tree.root_triangles.push_back(1 + static_cast<std::uint32_t>(random_() % 250));
        }
        return tree;
    }
    AnalysedScenario scenario(std::size_t roots) {
        AnalysedScenario analysed;
        analysed.position = next_++;
        if (roots == roots_per_tree) {
            for (RootIndex root = 0; root < roots_per_tree; ++root) {
                analysed.roots_a.push_back(root);
            }
            analysed.roots_b = analysed.roots_a;
        } else {
            analysed.roots_a = some_roots(random_, roots);
            analysed.roots_b = some_roots(random_, roots);
        }
        return analysed;
    }

    std::mt19937_64 random_{7};
    std::size_t roots_touched_;
    std::uint64_t next_ = 0;
    Dispatcher dispatcher_;
};

double percentile(std::vector<double>& values, double share) {
    const auto place = values.begin() +
                       static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return 1e6 * *place;
}

void decide(benchmark::State& state, std::string_view strategy) {
    constexpr std::size_t decisions = 2000; // Each round uses these decisions.
    constexpr double unknown = 1e9;
    std::vector<double> own(decisions, unknown);
    std::vector<double> wall(decisions, unknown);
    double checksum = 0;
    for (auto _ : state) {
        Midway midway(strategy,
                      static_cast<std::uint64_t>(state.range(0)),
                      static_cast<std::size_t>(state.range(1)));
        double seconds = 0;
        for (std::size_t i = 0; i < decisions; ++i) {
            AnalysedScenario analysed = midway.scenario();
            const auto wall_begin = std::chrono::steady_clock::now();
            const double begin = processor_seconds();
            midway.decide(std::move(analysed));
            const double passed = processor_seconds() - begin;
            const std::chrono::duration<double> wall_passed =
                std::chrono::steady_clock::now() - wall_begin;
            own[i] = std::min(own[i], passed);
            wall[i] = std::min(wall[i], wall_passed.count());
            seconds += passed;
        }
        state.SetIterationTime(seconds / decisions);
        checksum = midway.checksum();
    }
    state.counters["p50_us"] = percentile(own, 0.5);
    state.counters["p99_us"] = percentile(own, 0.99);
    state.counters["wall_p50_us"] = percentile(wall, 0.5);
    state.counters["wall_p99_us"] = percentile(wall, 0.99);
    state.counters["checksum"] = checksum;
}

void settings(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"workers", "roots"})
        ->Args({16, 100})
        ->Args({256, 100})
        ->Args({256, 500})
        ->Args({2048, 500})
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond)
        ->Iterations(5);
}

BENCHMARK_CAPTURE(decide, best_match, "best-match")->Apply(settings);
BENCHMARK_CAPTURE(decide, best_match_load, "best-match-load")->Apply(settings);
BENCHMARK_CAPTURE(decide, lowest, "lowest")->Apply(settings);
BENCHMARK_CAPTURE(decide, random, "random")->Apply(settings);
BENCHMARK_CAPTURE(decide, earliest_finish, "earliest-finish")->Apply(settings);

} // namespace
} // namespace cd::bench

BENCHMARK_MAIN();
