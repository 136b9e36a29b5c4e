#include "bench/cluster/recorder.hpp"

#include "bench/cluster/cpu_clock.hpp"
#include "common/core/disk_file.hpp"
#include "common/job/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/search_cost.hpp"
#include "master/blocks_file.hpp"
#include "master/cost_model.hpp"
#include "master/submitter.hpp"
#include "proto/codec.hpp"
#include "proto/frame.hpp"
#include "worker/executor.hpp"
#include "worker/subtree_cache.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>

namespace cd::bench {

namespace {

/// A row a scenario, a column a pass.
class PassTimes {
  public:
    PassTimes(std::size_t scenarios, unsigned passes)
        : passes_(passes), seconds_(scenarios * passes) {}

    void set(std::size_t scenario, unsigned pass, double seconds) {
        seconds_[scenario * passes_ + pass] = seconds;
    }
    [[nodiscard]] double median(std::size_t scenario) const {
        const auto begin = seconds_.begin() + static_cast<std::ptrdiff_t>(scenario * passes_);
        std::vector<double> sorted(begin, begin + passes_);
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }

  private:
    unsigned passes_;
    std::vector<double> seconds_;
};

/// A body cut at a depth, with all its subtrees.
struct CutBody {
    TreeTop top;
    std::vector<std::shared_ptr<const Subtree>> subtrees; ///< As a worker has them.
    std::vector<Subtree> binary;                          ///< In the paper's form.
    CutTrace trace;
};

std::uint64_t top_message_bytes(const TreeTop& top) {
    return frame_header_bytes +
           encode_message(AddTree{TreeId{1}, SubtreeForm::Wide, top.nodes}).size();
}

/// Opens the block as a worker does, and measures that.
Result<std::shared_ptr<const Subtree>> open_timed(const SubtreeBlock& block, RootTrace& root) {
    const double start = cpu_seconds();
    auto subtree = open_block(block);
    root.open_seconds = cpu_seconds() - start;
    if (subtree) {
        root.memory_bytes = subtree.value()->memory_bytes();
    }
    return subtree;
}

Result<CutBody>
cut_body(const ObbTree& tree, std::uint32_t depth, const std::filesystem::path& path) {
    ThreadPool pool(1);
    const Status written = write_blocks_file(path, tree, depth, SubtreeForm::Wide, pool);
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
    body.trace.top_bytes = top_message_bytes(body.top);
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

/// The paper's form of the search.
double binary_seconds(const CutBody& a,
                      const CutBody& b,
                      const std::vector<RootPair>& roots,
                      const Scenario& scenario) {
    const double start = cpu_seconds();
    std::vector<SubtreePair> pairs;
    pairs.reserve(roots.size());
    for (const RootPair& pair : roots) {
        pairs.push_back({a.binary[pair.a].view(), b.binary[pair.b].view()});
    }
    static_cast<void>(run_on_subtrees(pairs, scenario, {}));
    return cpu_seconds() - start;
}

AnalysisInput analysis_input(const CutBody& a, const CutBody& b) {
    AnalysisInput input;
    input.top_a = std::make_shared<const TreeTop>(a.top);
    input.top_b = std::make_shared<const TreeTop>(b.top);
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

/// All scenarios of one depth of A's cut.
class DepthRecorder {
  public:
    DepthRecorder(const CutBody& a,
                  const CutBody& b,
                  const std::vector<Scenario>& scenarios,
                  unsigned passes)
        : a_(a), b_(b), scenarios_(scenarios), passes_(passes), traces_(scenarios.size()) {}

    std::vector<ScenarioTrace> record() {
        analyse_all();
        search_binary();
        search_wide();
        return std::move(traces_);
    }

  private:
    void analyse_all() {
        const AnalysisInput input = analysis_input(a_, b_);
        analyses_.resize(scenarios_.size());
        PassTimes times(scenarios_.size(), passes_);
        for (unsigned pass = 0; pass < passes_; ++pass) {
            for (std::size_t i = 0; i < scenarios_.size(); ++i) {
                const double start = cpu_seconds();
                analyses_[i] = analyse(input, scenarios_[i]);
                times.set(i, pass, cpu_seconds() - start);
            }
        }
        for (std::size_t i = 0; i < scenarios_.size(); ++i) {
            const Analysis& analysis = analyses_[i];
            ScenarioTrace& trace = traces_[i];
            trace.analysis_seconds = times.median(i);
            trace.analysis_box_tests = analysis.cost.search.box_tests;
            trace.root_pairs = static_cast<std::uint32_t>(analysis.pairs.size());
            trace.meeting_size = meeting_size(a_.top, b_.top, analysis.pairs);
            trace.batch_bytes = analysis.bytes;
            trace.roots_a = analysis.roots_a;
            trace.roots_b = analysis.roots_b;
        }
    }

    void search_binary() {
        PassTimes times(scenarios_.size(), passes_);
        for (unsigned pass = 0; pass < passes_; ++pass) {
            for (std::size_t i = 0; i < scenarios_.size(); ++i) {
                times.set(i, pass, binary_seconds(a_, b_, analyses_[i].pairs, scenarios_[i]));
            }
        }
        for (std::size_t i = 0; i < scenarios_.size(); ++i) {
            traces_[i].binary_seconds = times.median(i);
        }
    }

    void search_wide() {
        PassTimes times(scenarios_.size(), passes_);
        for (unsigned pass = 0; pass < passes_; ++pass) {
            for (std::size_t i = 0; i < scenarios_.size(); ++i) {
                const ReadyScenario ready = ready_scenario(a_, b_, analyses_[i], {});
                const double start = cpu_seconds();
                const auto finished = execute(ready, {});
                times.set(i, pass, cpu_seconds() - start);
                traces_[i].result_bytes = pack_records(finished->records).size();
            }
        }
        for (std::size_t i = 0; i < scenarios_.size(); ++i) {
            traces_[i].work_seconds = times.median(i);
        }
    }

    const CutBody& a_;
    const CutBody& b_;
    const std::vector<Scenario>& scenarios_;
    unsigned passes_;
    std::vector<ScenarioTrace> traces_;
    std::vector<Analysis> analyses_;
};

/// The search in one process; with wide trees also the record.
std::vector<WholeTrace> record_whole(const ObbTree& a,
                                     const ObbTree& b,
                                     const std::vector<Scenario>& scenarios,
                                     unsigned passes,
                                     bool is_wide) {
    PassTimes times(scenarios.size(), passes);
    std::vector<WholeTrace> traces(scenarios.size());
    for (unsigned pass = 0; pass < passes; ++pass) {
        for (std::size_t i = 0; i < scenarios.size(); ++i) {
            const double start = cpu_seconds();
            const SubtreePair pair{a.view(), b.view()};
            const ScenarioRun run = run_on_subtrees({&pair, 1}, scenarios[i], {});
            if (is_wide) {
                static_cast<void>(encode_result(run.result));
            }
            times.set(i, pass, cpu_seconds() - start);
            traces[i].box_tests = run.statistics.box_tests;
            traces[i].triangle_tests = run.statistics.triangle_tests;
        }
    }
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        traces[i].seconds = times.median(i);
    }
    return traces;
}

void record_whole(const ObbTree& a,
                  const ObbTree& b,
                  const std::vector<Scenario>& scenarios,
                  unsigned passes,
                  Trace& trace) {
    const auto binary = record_whole(a, b, scenarios, passes, false);
    ObbTree wide_a = a;
    ObbTree wide_b = b;
    wide_a.prepare_search();
    wide_b.prepare_search();
    const auto wide = record_whole(wide_a, wide_b, scenarios, passes, true);
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        trace.whole.push_back({wide[i].seconds,
                               binary[i].seconds,
                               binary[i].box_tests,
                               binary[i].triangle_tests,
                               wide[i].box_tests,
                               wide[i].triangle_tests});
    }
    std::vector<PosePair> poses;
    for (const Scenario& scenario : scenarios) {
        poses.push_back(scenario.poses);
    }
    SearchCostOptions options;
    options.time_max = std::chrono::seconds(1);
    if (const auto cost = measure_search_cost(wide_a.view(), wide_b.view(), poses, options)) {
        trace.box_test_ns = cost->box_test_ns;
        trace.triangle_test_ns = cost->triangle_test_ns;
    }
}

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
    record_whole(*a, *b, scenarios, options.passes, trace);
    const auto cut_b = cut_body(*b, options.depth_b, options.scratch / "b.blocks");
    for (const std::uint32_t depth : options.depths_a) {
        const auto cut_a = cut_body(*a, depth, options.scratch / "a.blocks");
        for (const auto* cut : {&cut_a, &cut_b}) {
            if (!*cut) {
                return cut->error();
            }
        }
        trace.b = cut_b.value().trace;
        DepthRecorder recorder(cut_a.value(), cut_b.value(), scenarios, options.passes);
        trace.depths.push_back({cut_a.value().trace, recorder.record()});
        print_depth(trace, trace.depths.back());
    }
    return trace;
}

} // namespace cd::bench
