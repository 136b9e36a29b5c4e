// Measures searches in two wide trees and counts their tests, under real or random poses, on each
// SIMD target.
//
//   engine_wide_bench MESH_A MESH_B [--unit-a 1] [--poses FILE | --random 50] [--benchmark_...]
//
// FILE holds a pose of B in A's frame per line: the rotation by rows, then the translation.
// `descent` finds the candidates and decides none; `any`, `count` and `pairs` are whole searches,
// without sorting. Hot rows repeat each pose before the next, with its data in the caches; cold
// rows search all poses in turn. `each` is the mean time of a pose; `box_tests`, `visits` (pairs of
// nodes; `descent` only), `candidates` and `contacts` are its mean counts. The program fails unless
// the checksum of the results is equal for all targets, hot and cold. `any to pairs` runs the two
// levels alternately, each pose in turn. It prints the medians over the poses of their medians over
// the rounds, and their ratio: without contact, `any` costs no more than `pairs`.
#include "bench/accuracy/timing.hpp"
#include "bench/posed_trees.hpp"
#include "bench/timed_work.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/search/wide_search.hpp"
#include "common/tree/wide/candidates_at_once.hpp"
#include "common/tree/wide/wide_descent.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd::bench {

namespace {

/// Contacts found under one pose, and their cost.
struct Found {
    std::vector<std::pair<std::uint32_t, std::uint32_t>>* pairs = nullptr; ///< Filled if not null.
    std::uint64_t contacts = 0;
    std::uint64_t box_tests = 0;
    std::uint64_t candidates = 0;
    std::uint64_t visits = 0; ///< Pairs of nodes; for a descent only.
};

template <class Pairs>
void keep(const Pairs& pairs, Found& found) {
    if (found.pairs != nullptr) {
        for (const auto& pair : pairs) {
            found.pairs->emplace_back(pair.a, pair.b);
        }
    }
}

/// Finds all candidates of a pose.
void descend(const PosedTrees& trees, const PosePair& poses, Found& found) {
    WideDescent descent(relative_pose(poses));
    descent.start(trees.a.view().wide, trees.b.view().wide);
    while (!descent.is_done()) {
        const auto some = descent.next(candidates_at_once);
        found.candidates += some.size();
        keep(some, found);
    }
    found.box_tests = descent.box_tests();
    found.visits = descent.visits();
}

void search(const PosedTrees& trees, const PosePair& poses, const char* level, Found& found) {
    const std::string_view wanted = level;
    // Reused from pose to pose, as a user does.
    static WideSearch keeping(poses);
    static WideSearch counting(poses, {}, {.keep_pairs = false});
    ContactSearch& search = wanted == "pairs" ? keeping : counting;
    search.restart(poses);
    if (wanted == "any") {
        found.contacts = search.any(trees.a.view(), trees.b.view()) ? 1 : 0;
    } else {
        search.collect(trees.a.view(), trees.b.view());
        found.contacts = search.contacts().count();
    }
    keep(search.contacts().pairs(), found);
    const QueryStatistics statistics = search.report().statistics;
    found.box_tests = statistics.box_tests;
    found.candidates = statistics.triangle_tests;
}

/// One kind of work on all targets.
struct Work {
    const char* name; ///< "descent", or a level.
    bool is_hot;
};

/// First checksum of each name; all later ones must equal it.
using Checksums = std::map<std::string, double>;

void work_on(const PosedTrees& trees, const PosePair& poses, const Work& work, Found& found) {
    if (std::string_view(work.name) == "descent") {
        descend(trees, poses, found);
    } else {
        search(trees, poses, work.name, found);
    }
}

constexpr int repeats_when_hot = 4;

/// Returns this thread's seconds for all poses, once each.
double seconds_of_poses(const PosedTrees& trees, const Work& work) {
    double spent = 0;
    Found found;
    for (const PosePair& poses : trees.poses) {
        if (work.is_hot) {
            work_on(trees, poses, work, found);
        }
        const int repeats = work.is_hot ? repeats_when_hot : 1;
        const double start = processor_seconds();
        for (int i = 0; i < repeats; ++i) {
            work_on(trees, poses, work, found);
            benchmark::DoNotOptimize(found.contacts);
        }
        spent += (processor_seconds() - start) / repeats;
    }
    return spent;
}

/// Reports the counts of a pose, and the checksum, which all rows named `same_as` share.
void report(benchmark::State& state,
            const PosedTrees& trees,
            const Work& work,
            const std::string& same_as,
            Checksums& checksums) {
    Checksum checksum;
    Found sum;
    for (const PosePair& poses : trees.poses) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        Found found{&pairs};
        work_on(trees, poses, work, found);
        std::sort(pairs.begin(), pairs.end()); // Pairs come in any order.
        checksum.add(found.contacts);
        for (const auto& [a, b] : pairs) {
            checksum.add(a);
            checksum.add(b);
        }
        sum.contacts += found.contacts;
        sum.box_tests += found.box_tests;
        sum.candidates += found.candidates;
        sum.visits += found.visits;
    }
    using benchmark::Counter;
    const auto poses = static_cast<double>(trees.poses.size());
    state.counters["each"] = Counter(poses, Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["box_tests"] = static_cast<double>(sum.box_tests) / poses;
    if (sum.visits != 0) {
        state.counters["visits"] = static_cast<double>(sum.visits) / poses;
    }
    state.counters["candidates"] = static_cast<double>(sum.candidates) / poses;
    state.counters["contacts"] = static_cast<double>(sum.contacts) / poses;
    state.counters["checksum"] = checksum.value();
    const auto [first, is_first] = checksums.emplace(same_as, checksum.value());
    if (!is_first && first->second != checksum.value()) {
        checksums["differs"] = 1;
        state.SkipWithError("the checksum differs");
    }
}

void run(benchmark::State& state,
         const PosedTrees& trees,
         const Work& work,
         SimdTarget target,
         Checksums& checksums) {
    static_cast<void>(force_simd_target(to_text(target)));
    for (auto _ : state) {
        state.SetIterationTime(seconds_of_poses(trees, work));
    }
    const bool depends_on_target = std::string_view(work.name) == "descent";
    const std::string same_as = work.name + (depends_on_target ? std::string(to_text(target)) : "");
    report(state, trees, work, same_as, checksums);
    static_cast<void>(force_simd_target("auto"));
}

/// Microseconds of each pose at one level, round by round.
class PoseTimes {
  public:
    PoseTimes(const PosedTrees& trees, const char* level)
        : trees_(trees), level_(level), times_(trees.poses.size()) {}

    void add_round() {
        for (std::size_t i = 0; i < times_.size(); ++i) {
            Found found;
            const auto start = std::chrono::steady_clock::now();
            search(trees_, trees_.poses[i], level_, found);
            const std::chrono::duration<double, std::micro> spent =
                std::chrono::steady_clock::now() - start;
            benchmark::DoNotOptimize(found.contacts);
            times_[i].push_back(spent.count());
        }
    }
    [[nodiscard]] double median_pose() const {
        std::vector<double> medians;
        std::ranges::transform(times_, std::back_inserter(medians), median);
        return median(std::move(medians));
    }

  private:
    const PosedTrees& trees_;
    const char* level_;
    std::vector<std::vector<double>> times_;
};

void compare_any_to_pairs(benchmark::State& state, const PosedTrees& trees) {
    PoseTimes any(trees, "any");
    PoseTimes pairs(trees, "pairs");
    for (auto _ : state) {
        any.add_round();
        pairs.add_round();
    }
    state.counters["any_us"] = any.median_pose();
    state.counters["pairs_us"] = pairs.median_pose();
    state.counters["ratio"] = any.median_pose() / pairs.median_pose();
}

void register_all(const PosedTrees& trees, Checksums& checksums) {
    benchmark::RegisterBenchmark("any to pairs", [&](auto& state) {
        compare_any_to_pairs(state, trees);
    })->Unit(benchmark::kMicrosecond);
    for (const SimdTarget target : available_simd_targets()) {
        for (const char* name : {"descent", "any", "count", "pairs"}) {
            for (const bool is_hot : {true, false}) {
                const std::string full = std::string(name) + (is_hot ? " hot/" : " cold/") +
                                         std::string(to_text(target));
                benchmark::RegisterBenchmark(
                    full.c_str(),
                    [&, name, is_hot, target](auto& state) {
                        run(state, trees, {name, is_hot}, target, checksums);
                    })
                    ->UseManualTime()
                    ->Unit(benchmark::kMicrosecond);
            }
        }
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    cd::bench::PosedTreesOptions options;
    CLI::App app("Times the search in the wide trees of two bodies");
    options.add_to(app);
    CLI11_PARSE(app, argc, argv);
    const auto trees = cd::bench::load(options);
    if (!trees) {
        return 2;
    }
    if (trees->a.view().wide.nodes.empty() || trees->b.view().wide.nodes.empty()) {
        std::fprintf(stderr, "a body has no wide tree\n");
        return 2;
    }
    cd::bench::Checksums checksums;
    cd::bench::register_all(*trees, checksums);
    benchmark::RunSpecifiedBenchmarks();
    return checksums.contains("differs") ? 1 : 0;
}
