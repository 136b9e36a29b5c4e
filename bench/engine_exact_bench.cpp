// Measures the cost of ties. Times the decision of hard pairs by category, each pair with its own
// poses, and of the candidates of scenes full of ties: gears, and boxes stacked on lattices,
// unmoved, moved by decimals and turned by 3-4-5.
//
//   engine_exact_bench [--pairs 300] [--rounds 9] [--stages] [--only gears]
//
// Prints a Markdown row per set: pairs; ns per pair as in a query, with the poses' tests made anew
// in each round; ns per pair with tests made before. With --stages follow the times (tests made
// before) from stage Double on, from Lattice, DoubleDouble, WideInteger and Arbitrary; the pairs
// settled by each stage when all may; and the sums of the classes, which must be equal in all
// columns. All times are medians of the rounds.
#include "bench/accuracy/suites/sources.hpp"
#include "bench/accuracy/timing.hpp"
#include "common/pair/triangle_pair.hpp"
#include "tests/corpus/pairs.hpp"
#include "tests/corpus/scenes.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cd::bench {

namespace {

struct Options {
    std::uint64_t pairs = 300;
    std::size_t rounds = 9;
    std::size_t scenes_max = 1000;
    bool stages = false;
    std::string only;

    [[nodiscard]] bool wants(const std::string& name) const {
        return name.find(only) != std::string::npos;
    }
};

/// Total time and pairs of several sets.
struct Sum {
    double nanoseconds = 0;
    double pairs = 0;

    [[nodiscard]] double mean() const { return pairs == 0 ? 0 : nanoseconds / pairs; }
};

constexpr std::array later_stages{PairStage::Double,
                                  PairStage::Lattice,
                                  PairStage::DoubleDouble,
                                  PairStage::WideInteger,
                                  PairStage::Arbitrary};

std::uint64_t sum_of(std::span<const PairClass> kinds) {
    std::uint64_t sum = 0;
    for (const PairClass kind : kinds) {
        sum += static_cast<std::uint64_t>(kind);
    }
    return sum;
}

/// One way to decide a batch.
class Contestant {
  public:
    Contestant(const PairBatch& batch, PairStage first, bool makes_tests)
        : batch_(&batch), first_(first), makes_tests_(makes_tests) {}

    void run() {
        class_sum_ = 0;
        const std::span<const PairGroup> groups = batch_->groups();
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (makes_tests_) {
                TrianglePairTest test(groups[i].poses, first_);
                decide(groups[i], test);
                continue;
            }
            if (tests_.size() <= i) {
                tests_.emplace_back(groups[i].poses, first_);
            }
            decide(groups[i], tests_[i]);
        }
    }

    [[nodiscard]] std::uint64_t class_sum() const { return class_sum_; }

  private:
    void decide(const PairGroup& group, TrianglePairTest& test) {
        class_sum_ += sum_of(test.classify(group.a, group.b, group.candidates));
    }

    const PairBatch* batch_;
    PairStage first_;
    bool makes_tests_;
    std::vector<TrianglePairTest> tests_;
    std::uint64_t class_sum_ = 0;
};

PairStatistics statistics_of(const PairBatch& batch) {
    PairStatistics statistics;
    for (const PairGroup& group : batch.groups()) {
        TrianglePairTest test(group.poses);
        static_cast<void>(test.classify(group.a, group.b, group.candidates));
        statistics += test.statistics();
    }
    return statistics;
}

/// Prints one row; returns its time in a query.
Sum print_row(const std::string& name, const PairBatch& batch, const Options& options) {
    std::vector<Contestant> contestants;
    contestants.emplace_back(batch, PairStage::Float, true);
    contestants.emplace_back(batch, PairStage::Float, false);
    if (options.stages) {
        for (const PairStage first : later_stages) {
            contestants.emplace_back(batch, first, false);
        }
    }
    const std::vector<double> medians = interleaved_medians(
        options.rounds, contestants.size(), [&](std::size_t i) { contestants[i].run(); });
    std::printf("| %s | %zu |", name.c_str(), batch.size());
    const auto pairs = static_cast<double>(batch.size());
    std::set<std::uint64_t> sums;
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        std::printf(" %.0f |", 1e9 * medians[i] / pairs);
        sums.insert(contestants[i].class_sum());
    }
    const PairStatistics statistics = statistics_of(batch);
    for (const std::uint64_t settled : statistics.settled) {
        std::printf(" %llu |", static_cast<unsigned long long>(settled));
    }
    for (const std::uint64_t sum : sums) {
        std::printf(" %llu", static_cast<unsigned long long>(sum));
    }
    std::puts(" |");
    return {1e9 * medians[0], pairs};
}

void print_head(const Options& options) {
    std::string head = "| set | pairs | whole, ns | poses made before |";
    std::string rule = "|---|---|---|---|";
    const auto add = [&](const std::string& cell) {
        head += " " + cell + " |";
        rule += "---|";
    };
    if (options.stages) {
        for (const PairStage stage : later_stages) {
            add("from " + std::string(to_text(stage)));
        }
    }
    for (std::size_t i = 0; i < pair_stage_count; ++i) {
        add("in " + std::string(to_text(static_cast<PairStage>(i))));
    }
    add("sums");
    std::printf("%s\n%s\n", head.c_str(), rule.c_str());
}

int run(const Options& options) {
    print_head(options);
    Sum corpus;
    for (const std::string& category : tests::pair_categories()) {
        if (!options.wants(category)) {
            continue;
        }
        const Sum row = print_row(category, corpus_batch(category, 0, options.pairs), options);
        corpus.nanoseconds += row.mean();
        corpus.pairs += 1;
    }
    Sum scenes;
    for (const Scene& scene : hard_scenes(options.scenes_max)) {
        const bool has_ties =
            scene.name.starts_with("stacked boxes") || scene.name.starts_with("gears");
        if (!has_ties || !options.wants(scene.name)) {
            continue;
        }
        const SceneCandidates candidates(scene);
        const Sum row = print_row(scene.name, candidates.batch(), options);
        scenes.nanoseconds += row.nanoseconds;
        scenes.pairs += row.pairs;
    }
    std::printf("\nmean of all categories, the poses' tests made anew: %.0f ns\n", corpus.mean());
    std::printf("mean of a candidate of stacked boxes and gears: %.0f ns\n", scenes.mean());
    return 0;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    CLI::App app{"What a tie between two triangles costs"};
    app.add_option("--pairs", options.pairs, "of each category");
    app.add_option("--rounds", options.rounds, "the median of which counts");
    app.add_option("--scenes", options.scenes_max, "looked at, at most");
    app.add_option("--only", options.only, "what has this in its name");
    app.add_flag("--stages", options.stages, "also from each later stage on");
    CLI11_PARSE(app, argc, argv);
    return cd::bench::run(options);
}
