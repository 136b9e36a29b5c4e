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
#include "master/base/worker_process.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cd {

class Settler;

/// What the analysis of a job reads. The tops are those of the trees' cuts.
struct AnalysisInput {
    std::shared_ptr<const ObbTree> a;
    std::shared_ptr<const ObbTree> b;
    std::shared_ptr<const TreeTop> top_a;
    std::shared_ptr<const TreeTop> top_b;
    Query query;
    std::shared_ptr<const Settler> settler; ///< Of these trees.
    std::shared_ptr<PoseSource> poses;      ///< Its `read` must bear several threads at once.
    /// By index: scenarios that have results before the analysis begins; they are passed over,
    /// unless they are started as in doubt. Null: none.
    std::shared_ptr<const std::vector<bool>> done;
};

/// One scenario after the analysis: either with work for a worker, or finished.
struct Analysis {
    Scenario scenario;
    std::uint64_t place = 0;        ///< In the job's order; of a block's.
    std::vector<RootPair> pairs;    ///< The colliding distribution roots, sorted.
    std::vector<RootIndex> roots_a; ///< The distinct ones of each side, ascending.
    std::vector<RootIndex> roots_b;
    std::uint64_t bytes = 0;        ///< What the scenario adds to a batch on the wire, about.
    std::uint64_t predicted_ns = 0; ///< Of one thread, for the colliding pairs (cost_model.hpp).

    /// Where no roots collide: separate, or inside; or failed, where they are too many. `pairs` is
    /// then empty.
    std::optional<ScenarioResult> finished;
    JobStatistics cost; ///< Of the analysis, and of settling `finished`.
};

/// The analysis of one scenario. Pure. A failure of it is a `finished` result that names it.
[[nodiscard]] Analysis analyse(const AnalysisInput& input, const Scenario& scenario);

/// The scenarios at some places of a job. With an error (of reading the poses) there are none.
struct AnalysedBlock {
    PlaceRange places;
    Losses losses = {}; ///< As they were said when the block was started.
    std::vector<Analysis> scenarios;
    double seconds = 0; ///< Of a thread.
    std::optional<Error> error;
};

/// Analyses a job in blocks on a pool, several at once, no more of them than the owner asked for.
class Submitter {
  public:
    /// The places are those of `input.poses`. Blocks are delivered in the order in which they were
    /// started, one at a time, on threads of the pool. `deliver` must neither throw nor destroy the
    /// submitter. The pool must outlive the work posted to it.
    Submitter(ThreadPool& pool, AnalysisInput input, std::function<void(AnalysedBlock)> deliver);
    Submitter(const Submitter&) = delete;
    Submitter& operator=(const Submitter&) = delete;
    /// When this returns, `deliver` is not running and will not be called again. Blocks not yet
    /// started are dropped.
    ~Submitter();

    /// Starts a block of at most `limits::analysis_block_scenarios` places. After the end:
    /// nothing.
    void start(const PlaceRange& places, const Losses& losses = {});

    /// Blocks started and not yet delivered.
    [[nodiscard]] std::uint64_t under_way() const;

  private:
    struct State;
    ThreadPool& pool_;
    std::shared_ptr<State> state_;
};

} // namespace cd
