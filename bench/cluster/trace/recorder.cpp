#include "bench/cluster/trace/recorder.hpp"

#include "bench/cluster/cpu_clock.hpp"
#include "bench/cluster/trace/result_costs.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/settle.hpp"
#include "common/search/search_cost.hpp"
#include "common/tree/wire/top_block.hpp"
#include "master/compute/analyser.hpp"
#include "master/dispatch/cost_model.hpp"
#include "master/geometry/blocks_file.hpp"
#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/executor.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

namespace cd::bench {

namespace {

template <class Work>
double seconds_of(const Work& work) {
    const double start = cpu_seconds();
    work();
    return cpu_seconds() - start;
}

/// A step of each scenario that reports its own seconds: a row per scenario, a column per pass.
class TimedStep {
  public:
    TimedStep(std::size_t scenarios, unsigned passes, std::function<double(std::size_t)> step)
        : passes_(passes), step_(std::move(step)), seconds_(scenarios * passes) {}

    void run(std::size_t scenario, unsigned pass) {
        seconds_[scenario * passes_ + pass] = step_(scenario);
    }
    [[nodiscard]] double median(std::size_t scenario) const {
        const auto begin = seconds_.begin() + static_cast<std::ptrdiff_t>(scenario * passes_);
        std::vector<double> sorted(begin, begin + passes_);
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }

  private:
    unsigned passes_;
    std::function<double(std::size_t)> step_;
    std::vector<double> seconds_;
};

/// Runs all steps on some scenarios, then on the next ones: the machine's speed drifts, and the
/// steps are compared with each other.
void run_in_turns(std::span<TimedStep* const> steps, std::size_t scenarios, unsigned passes) {
    constexpr std::size_t together = 128;
    for (std::size_t begin = 0; begin < scenarios; begin += together) {
        const std::size_t end = std::min(begin + together, scenarios);
        for (unsigned pass = 0; pass < passes; ++pass) {
            for (TimedStep* step : steps) {
                for (std::size_t i = begin; i < end; ++i) {
                    step->run(i, pass);
                }
            }
        }
    }
}

/// A body cut at a depth, with all its subtrees.
struct CutBody {
    TreeTop top;
    std::vector<std::shared_ptr<const Subtree>> subtrees; ///< In the worker's form.
    std::vector<Subtree> binary;                          ///< In the paper's form.
    CutTrace trace;
};

/// Opens the block as a worker does, and measures the time.
Result<std::shared_ptr<const Subtree>> open_timed(const SubtreeBlock& block, RootTrace& root) {
    const double start = cpu_seconds();
    const auto opened = open_block(block);
    root.open_seconds = cpu_seconds() - start;
    if (!opened) {
        return opened.error();
    }
    auto subtree = std::get<std::shared_ptr<const Subtree>>(opened.value());
    root.memory_bytes = subtree->memory_bytes();
    return subtree;
}

Result<CutBody>
cut_body(const ObbTree& tree, std::uint32_t depth, const std::filesystem::path& path) {
    ThreadPool pool(1);
    const Status written = write_blocks_file(path, tree, depth, SubtreeForm::Wide, &pool);
    if (!written) {
        return written.error();
    }
    const auto blocks = open_blocks_file(path, tree, depth, SubtreeForm::Wide);
    if (!blocks) {
        return blocks.error();
    }
    CutBody body;
    body.top = cut_tree(tree, depth);
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        body.binary.push_back(extract_subtree(tree, node));
    }
    body.trace.depth = depth;
    body.trace.top_bytes = compress(encode_top(body.top), compression_level_geometry).size();
    for (RootIndex root = 0; root < body.top.root_count(); ++root) {
        const BlockPlace& place = blocks.value().places[root];
        auto compressed = read_block(blocks.value(), root);
        if (!compressed) {
            return compressed.error();
        }
        RootTrace trace{body.top.triangles_under(root), place.bytes, place.compressed_bytes, 0, 0};
        auto subtree = open_timed({root, place.hash, std::move(compressed.value())}, trace);
        if (!subtree) {
            return subtree.error();
        }
        body.trace.roots.push_back(trace);
        body.subtrees.push_back(std::move(subtree.value()));
    }
    return body;
}

std::vector<std::shared_ptr<const Subtree>> subtrees_of(const CutBody& body,
                                                        const std::vector<RootIndex>& roots) {
    std::vector<std::shared_ptr<const Subtree>> subtrees;
    subtrees.reserve(roots.size());
    for (const RootIndex root : roots) {
        subtrees.push_back(body.subtrees[root]);
    }
    return subtrees;
}

/// Searches in the paper's form of tree.
double search_binary(const CutBody& a,
                     const CutBody& b,
                     const std::vector<RootPair>& roots,
                     const Scenario& scenario) {
    return seconds_of([&] {
        std::vector<SubtreePair> pairs;
        pairs.reserve(roots.size());
        for (const RootPair& pair : roots) {
            pairs.push_back({a.binary[pair.a].view(), b.binary[pair.b].view()});
        }
        static_cast<void>(run_on_subtrees(pairs, scenario, {}));
    });
}

AnalysisInput analysis_input(const CutBody& a, const CutBody& b) {
    AnalysisInput input;
    input.tops = {std::make_shared<const TreeTop>(a.top), std::make_shared<const TreeTop>(b.top)};
    return input;
}

ReadyScenario
ready_scenario(const CutBody& a, const CutBody& b, const Analysis& analysis, const Query& query) {
    ReadyScenario ready;
    ready.scenario = analysis.scenario;
    ready.query = std::make_shared<const Query>(query);
    ready.pairs = analysis.pairs;
    ready.roots_a = analysis.roots_a;
    ready.roots_b = analysis.roots_b;
    ready.subtrees_a = subtrees_of(a, analysis.roots_a);
    ready.subtrees_b = subtrees_of(b, analysis.roots_b);
    return ready;
}

/// Records all scenarios at one depth of A's cut.
class DepthRecorder {
  public:
    /// All arguments must outlive this.
    DepthRecorder(const CutBody& a,
                  const CutBody& b,
                  const std::vector<Scenario>& scenarios,
                  unsigned passes)
        : a_(a),
          b_(b),
          scenarios_(scenarios),
          input_(analysis_input(a, b)),
          analyses_(scenarios.size()),
          records_(scenarios.size()),
          analysis_(scenarios.size(), passes, [this](std::size_t i) { return analyse_one(i); }),
          binary_(scenarios.size(),
                  passes,
                  [this](std::size_t i) {
                      return search_binary(a_, b_, analyses_[i].pairs, scenarios_[i]);
                  }),
          wide_(scenarios.size(), passes, [this](std::size_t i) { return search_wide(i); }) {}
    DepthRecorder(const DepthRecorder&) = delete;
    DepthRecorder& operator=(const DepthRecorder&) = delete;

    void add_steps(std::vector<TimedStep*>& steps) {
        steps.insert(steps.end(), {&analysis_, &binary_, &wide_});
    }

    [[nodiscard]] DepthTrace trace() const {
        DepthTrace depth{a_.trace, std::vector<ScenarioTrace>(scenarios_.size())};
        for (std::size_t i = 0; i < scenarios_.size(); ++i) {
            const Analysis& analysis = analyses_[i];
            ScenarioTrace& trace = depth.scenarios[i];
            trace.analysis_seconds = analysis_.median(i);
            trace.analysis_box_tests = analysis.cost.search.box_tests;
            trace.root_pairs = static_cast<std::uint32_t>(analysis.pairs.size());
            trace.meeting_size = meeting_size(a_.top, b_.top, analysis.pairs);
            trace.work_seconds = wide_.median(i);
            trace.binary_seconds = binary_.median(i);
            trace.batch_bytes = analysis.bytes;
            trace.result_bytes = pack_records(records_[i]).size();
            trace.roots_a = analysis.roots_a;
            trace.roots_b = analysis.roots_b;
        }
        return depth;
    }

    [[nodiscard]] std::span<const Analysis> analyses() const { return analyses_; }
    /// Records in a worker's form.
    [[nodiscard]] std::span<const Bytes> records() const { return records_; }

  private:
    double analyse_one(std::size_t i) {
        return seconds_of([&] { analyses_[i] = analyse(input_, scenarios_[i]); });
    }

    double search_wide(std::size_t i) {
        const ReadyScenario ready = ready_scenario(a_, b_, analyses_[i], {});
        const double start = cpu_seconds();
        const auto finished = execute(ready, {});
        const double seconds = cpu_seconds() - start;
        records_[i] = finished->records;
        return seconds;
    }

    const CutBody& a_;
    const CutBody& b_;
    const std::vector<Scenario>& scenarios_;
    AnalysisInput input_;
    std::vector<Analysis> analyses_;
    std::vector<Bytes> records_;
    TimedStep analysis_;
    TimedStep binary_;
    TimedStep wide_;
};

/// Records the search in one process; with wide trees also the record.
class WholeRecorder {
  public:
    /// All arguments must outlive this.
    WholeRecorder(const ObbTree& a,
                  const ObbTree& b,
                  const std::vector<Scenario>& scenarios,
                  unsigned passes)
        : a_(a),
          b_(b),
          wide_a_(a),
          wide_b_(b),
          scenarios_(scenarios),
          traces_(scenarios.size()),
          binary_(scenarios.size(), passes, [this](std::size_t i) { return search_binary(i); }),
          wide_(scenarios.size(), passes, [this](std::size_t i) { return search_wide(i); }) {
        wide_a_.prepare_search();
        wide_b_.prepare_search();
    }
    WholeRecorder(const WholeRecorder&) = delete;
    WholeRecorder& operator=(const WholeRecorder&) = delete;

    void add_steps(std::vector<TimedStep*>& steps) {
        steps.insert(steps.end(), {&binary_, &wide_});
    }

    void fill(Trace& trace) const {
        trace.whole = traces_;
        for (std::size_t i = 0; i < traces_.size(); ++i) {
            trace.whole[i].binary_seconds = binary_.median(i);
            trace.whole[i].seconds = wide_.median(i);
        }
        std::vector<PosePair> poses;
        for (const Scenario& scenario : scenarios_) {
            poses.push_back(scenario.poses);
        }
        SearchCostOptions options;
        options.time_max = std::chrono::seconds(1);
        if (const auto cost = measure_search_cost(wide_a_.view(), wide_b_.view(), poses, options)) {
            trace.box_test_ns = cost->box_test_ns;
            trace.triangle_test_ns = cost->triangle_test_ns;
        }
    }

  private:
    double search_binary(std::size_t i) {
        const SubtreePair pair{a_.view(), b_.view()};
        ScenarioRun run;
        const double seconds = seconds_of([&] {
            run = run_on_subtrees({&pair, 1}, scenarios_[i], {});
        });
        traces_[i].box_tests = run.statistics.box_tests;
        traces_[i].triangle_tests = run.statistics.triangle_tests;
        return seconds;
    }

    double search_wide(std::size_t i) {
        const SubtreePair pair{wide_a_.view(), wide_b_.view()};
        ScenarioRun run;
        const double seconds = seconds_of([&] {
            run = run_on_subtrees({&pair, 1}, scenarios_[i], {});
            static_cast<void>(encode_result(run.result));
        });
        traces_[i].wide_box_tests = run.statistics.box_tests;
        traces_[i].wide_triangle_tests = run.statistics.triangle_tests;
        return seconds;
    }

    const ObbTree& a_;
    const ObbTree& b_;
    ObbTree wide_a_;
    ObbTree wide_b_;
    const std::vector<Scenario>& scenarios_;
    std::vector<WholeTrace> traces_;
    TimedStep binary_;
    TimedStep wide_;
};

void print_depth(const Trace& trace, const DepthTrace& depth) {
    const auto mean_us = [&](auto member) {
        const double sum = std::accumulate(
            depth.scenarios.begin(), depth.scenarios.end(), 0.0, [&](double all, const auto& one) {
                return all + one.*member;
            });
        return 1e6 * sum / static_cast<double>(depth.scenarios.size());
    };
    std::printf(
        "%s, depth %u: %zu roots, analysis %.1f us, work %.1f us, in binary trees %.1f us\n",
        trace.name.c_str(),
        depth.a.depth,
        depth.a.roots.size(),
        mean_us(&ScenarioTrace::analysis_seconds),
        mean_us(&ScenarioTrace::work_seconds),
        mean_us(&ScenarioTrace::binary_seconds));
    std::fflush(stdout);
}

} // namespace

Result<Trace> record_trace(const std::shared_ptr<const ObbTree>& a,
                           const std::shared_ptr<const ObbTree>& b,
                           const std::vector<Scenario>& scenarios,
                           const RecordOptions& options) {
    Trace trace;
    trace.name = options.name;
    trace.triangles_a = a->mesh().triangles().size();
    trace.triangles_b = b->mesh().triangles().size();
    const auto cut_b = cut_body(*b, options.depth_b, options.scratch / "b.blocks");
    if (!cut_b) {
        return cut_b.error();
    }
    trace.b = cut_b.value().trace;
    WholeRecorder whole(*a, *b, scenarios, options.passes);
    std::deque<CutBody> cuts_a;
    std::deque<DepthRecorder> depths;
    std::vector<TimedStep*> steps;
    whole.add_steps(steps);
    for (const std::uint32_t depth : options.depths_a) {
        auto cut_a = cut_body(*a, depth, options.scratch / "a.blocks");
        if (!cut_a) {
            return cut_a.error();
        }
        cuts_a.push_back(std::move(cut_a.value()));
        depths.emplace_back(cuts_a.back(), cut_b.value(), scenarios, options.passes)
            .add_steps(steps);
    }
    run_in_turns(steps, scenarios.size(), options.passes);
    whole.fill(trace);
    const auto results = measure_result_costs(
        std::make_shared<const JobMaterial>(JobMaterial{
            {a, b}, {}, std::make_shared<const Settler>(*a, *b, std::vector<IgnoredRange>())}),
        depths.front().analyses(),
        depths.front().records(),
        options.scratch / "journal",
        options.passes);
    if (!results) {
        return results.error();
    }
    trace.results = results.value();
    std::printf("%s, results: packing %.1f us, intake %.1f us, journal %.1f us\n",
                trace.name.c_str(),
                1e6 * trace.results.packing_seconds,
                1e6 * trace.results.intake_seconds,
                1e6 * trace.results.journal_seconds);
    for (const DepthRecorder& depth : depths) {
        trace.depths.push_back(depth.trace());
        print_depth(trace, trace.depths.back());
    }
    return trace;
}

} // namespace cd::bench
