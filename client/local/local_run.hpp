// Runs a job in this process, with the code that the cluster runs.
#pragma once

#include "client/local/done_scenario.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/result.hpp"
#include "common/job/statistics.hpp"
#include "common/search/search_cost.hpp"
#include "common/tree/obb_tree.hpp"

#include <functional>
#include <optional>

namespace cd {

/// Callbacks of a run, all on the calling thread.
struct RunObserver {
    /// Receives each result in the submitted order. If it returns an error, the run ends with it.
    std::function<Status(const DoneScenario&)> result;
    /// Called a few times a second or more often.
    std::function<void(const Summary&, double seconds)> progress;
    /// True ends the run with the error Interrupted.
    std::function<bool()> stopped;
};

struct RunOutcome {
    Summary summary;
    std::optional<Sha256> digest;
    double seconds = 0;       ///< Run time, without import and building of trees.
    JobStatistics statistics; ///< Sum over this run, without `LocalRunOptions::done`.
    /// The cost of this job's searches, measured after the run at some of its poses, in a small
    /// share of the run's time. Nothing under a tolerance, or if no triangle was tested.
    std::optional<SearchCost> cost;
};

struct LocalRunOptions {
    PairStage first_stage = PairStage::Float;
    /// Results of the first scenarios from an earlier run, which are not run again.
    std::optional<ResultMerger> done;
};

/// Runs every scenario of `poses` on the pool's threads with a `ScenarioRunner`. Results and digest
/// are equal for any number of threads. Results that wait for an earlier one are bounded in number
/// and bytes. Errors: those of `poses` and of the observer; Interrupted.
[[nodiscard]] Result<RunOutcome> run_locally(const ObbTree& a,
                                             const ObbTree& b,
                                             PoseSource& poses,
                                             const Query& query,
                                             ThreadPool& pool,
                                             const RunObserver& observer,
                                             LocalRunOptions options = {});

} // namespace cd
