// The pre-analysis of a job's scenarios: which distribution roots collide (paper, 6.4.6).
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "common/job/result/result.hpp"
#include "common/job/statistics.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/obb_tree.hpp"
#include "master/base/instance_id.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cd {

class Settler;

/// Inputs of a job's analysis. The upper trees are those of the trees' cuts.
struct AnalysisInput {
    std::shared_ptr<const ObbTree> a;
    std::shared_ptr<const ObbTree> b;
    std::shared_ptr<const TreeTop> top_a;
    std::shared_ptr<const TreeTop> top_b;
    Query query;
    std::shared_ptr<const Settler> settler; ///< Settler for these two trees.
    std::shared_ptr<PoseSource> poses;      ///< `read` must be safe on several threads at once.
};

/// One analysed scenario: either it has work for a worker, or it is finished.
struct Analysis {
    Scenario scenario;
    std::uint64_t place = 0;        ///< Position in the job's order; for a block, its first.
    std::vector<RootPair> pairs;    ///< Colliding distribution roots, sorted.
    std::vector<RootIndex> roots_a; ///< Distinct roots of each side, ascending.
    std::vector<RootIndex> roots_b;
    std::uint64_t bytes = 0; ///< Approximate bytes that the scenario adds to a batch on the wire.
    std::uint64_t predicted_ns = 0; ///< One thread's time for the colliding pairs (cost_model.hpp).

    /// The result if no roots collide (separate or inside), or a failure if too many do. `pairs` is
    /// then empty.
    std::optional<ScenarioResult> finished;
    JobStatistics cost; ///< Cost of the analysis, and of settling `finished`.
};

/// Analyses one scenario. Pure. A failure becomes a `finished` result that names it.
[[nodiscard]] Analysis analyse(const AnalysisInput& input, const Scenario& scenario);

/// Scenarios at consecutive positions of a job; empty after an error in reading the poses.
struct AnalysedBlock {
    PlaceRange places;
    Losses losses = {}; ///< As passed when the block was started.
    std::vector<Analysis> scenarios;
    double seconds = 0; ///< Thread time.
    std::optional<Error> error;
};

/// Analyses a job in blocks on a pool, several at once, but no more than the owner started.
class Analyser {
  public:
    /// Positions are those of `input.poses`. Blocks are delivered in the order of their start, one
    /// at a time, on pool threads. `deliver` must neither throw nor destroy the analyser. The pool
    /// must outlive the functions posted to it.
    Analyser(ThreadPool& pool, AnalysisInput input, std::function<void(AnalysedBlock)> deliver);
    Analyser(const Analyser&) = delete;
    Analyser& operator=(const Analyser&) = delete;
    /// Waits for a running `deliver`; none is called afterwards. Drops blocks not yet started.
    ~Analyser();

    /// Starts a block of at most `limits::analysis_block_scenarios` positions. Skips scenarios that
    /// `done` marks by index; null marks none. Does nothing once the analyser is being destroyed.
    void start(const PlaceRange& places,
               const Losses& losses = {},
               std::shared_ptr<const std::vector<bool>> done = nullptr);

    /// Number of blocks started and not yet delivered.
    [[nodiscard]] std::uint64_t under_way() const;

  private:
    struct State;
    ThreadPool& pool_;
    std::shared_ptr<State> state_;
};

} // namespace cd
