// The analysis of a job's scenarios on the master: finds the distribution roots that collide
// (paper, 6.4.6).
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/query.hpp"
#include "common/job/result/result.hpp"
#include "common/job/statistics.hpp"
#include "common/job/trees_by_body.hpp"
#include "common/tree/cut.hpp"
#include "master/base/instance_id.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cd {

class Settler;

/// One analysed scenario, which either needs a worker or is finished.
struct Analysis {
    Scenario scenario;
    std::uint64_t position = 0;  ///< In the job's hand-out order; `analyse` leaves 0.
    std::vector<RootPair> pairs; ///< Colliding distribution roots, sorted.
    /// Distinct roots of A that a worker needs at once, ascending: those in `pairs`, or in the
    /// first look at a distance (`first_look`). The worker finds which others it needs.
    std::vector<RootIndex> roots_a;
    std::vector<RootIndex> roots_b; ///< The same of B.
    std::uint64_t bytes = 0; ///< Approximate bytes that the scenario adds to a batch on the wire.
    std::uint64_t predicted_ns = 0; ///< Predicted time of one worker thread (cost_model.hpp).

    /// The result if no roots collide (separate or inside), or a failure if too many do. `pairs` is
    /// then empty.
    std::optional<ScenarioResult> finished;
    JobStatistics cost; ///< Cost of the analysis, and of settling `finished`.
};

/// Inputs of a job's analysis.
struct AnalysisInput {
    BodyTrees trees;
    std::vector<std::shared_ptr<const TreeTop>> tops; ///< The upper tree of each body's cut.
    Query query;
    std::vector<double> radii = {};         ///< Of each body, in a job of motions; else empty.
    std::shared_ptr<const Settler> settler; ///< Settles scenarios; made for `trees`.
    std::shared_ptr<OrderedPoses> poses;    ///< Several threads may call `read` at once.
    /// In a simulation without trees, replaces the descent and sets `bytes`. Thread-safe.
    std::function<Analysis(const Scenario&)> sketch = nullptr;
};

/// Analyses one scenario. Pure. An error becomes a `finished` result of class Failed.
[[nodiscard]] Analysis analyse(const AnalysisInput& input, const Scenario& scenario);

/// A block of the analysis: scenarios at consecutive positions, analysed together.
struct AnalysedBlock {
    PositionRange positions;
    Losses losses = {}; ///< The losses passed to `Analyser::start`.
    std::vector<Analysis> scenarios;
    double seconds = 0;         ///< Duration of the analysis on a pool thread.
    std::optional<Error> error; ///< The poses could not be read; `scenarios` is empty.
};

/// Analyses blocks of a job's scenarios on a pool, several blocks at once.
class Analyser {
  public:
    /// Blocks are delivered in the order of their start, one at a time, on pool threads. `deliver`
    /// must neither throw nor destroy the analyser. The pool must outlive the functions posted to
    /// it.
    Analyser(Pool& pool, AnalysisInput input, std::function<void(AnalysedBlock)> deliver);
    Analyser(const Analyser&) = delete;
    Analyser& operator=(const Analyser&) = delete;
    /// Waits until `deliver` has returned. Drops all blocks that are not delivered.
    ~Analyser();

    /// Starts a block of at most `limits::analysis_block_scenarios` positions. Skips scenarios
    /// whose index `done` marks; null marks none.
    void start(const PositionRange& positions,
               const Losses& losses = {},
               std::shared_ptr<const std::vector<bool>> done = nullptr);
    /// Call for each delivered block, on the thread that calls `start`.
    void block_taken() { --under_way_; }
    /// Number of blocks that were started and not taken.
    [[nodiscard]] std::uint64_t under_way() const { return under_way_; }

  private:
    struct State;
    Pool& pool_;
    std::shared_ptr<State> state_;
    std::uint64_t under_way_ = 0;
};

} // namespace cd
