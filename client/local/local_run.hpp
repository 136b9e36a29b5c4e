// Runs a job in this process, with the code that the cluster runs.
#pragma once

#include "client/local/done_block.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/result.hpp"
#include "common/job/statistics.hpp"
#include "common/job/trees_by_body.hpp"
#include "common/search/search_cost.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace cd {

/// Callbacks of a run, all called on the thread that called `run_locally`.
struct RunObserver {
    /// Takes the results, in the submitted order. An error that it returns ends the run.
    std::function<Status(const DoneBlock&)> results;
    /// Takes the summary so far, a few times a second or more often.
    std::function<void(const Summary&, double seconds)> progress;
    /// If it returns true, the run ends with the error Interrupted.
    std::function<bool()> stopped;
};

struct RunOutcome {
    Summary summary;
    std::optional<Sha256> digest;
    double seconds = 0;       ///< Run time, without import and building of trees.
    JobStatistics statistics; ///< Sum over the scenarios of this run, without `done`.
    /// The cost of this job's searches, measured at some of its poses after the run, in a small
    /// share of the run's time: of the bodies of its first scenario. Nothing if no triangle was
    /// tested.
    std::optional<SearchCost> cost;
};

struct LocalRunOptions {
    PairStage first_stage = PairStage::Float;
    /// Results of an earlier run for the first scenarios, which are not run again.
    std::optional<ResultMerger> done;
    std::optional<SceneHead> scene = {}; ///< For the digest of a scene, unless `done` has it.
    /// Index of the first scenario of `poses`, which are a part of a longer sequence: the outcome
    /// counts this part alone.
    std::uint64_t first_index = 0;
};

/// Runs every scenario of `poses` on the pool's threads with a `ScenarioRunner`. Results and digest
/// are equal for any number of threads. Results that wait for a lower index are bounded in number
/// and bytes. Errors: from reading `poses`; the observer's; Interrupted.
[[nodiscard]] Result<RunOutcome> run_locally(const TreesByBody& trees,
                                             PoseSource& poses,
                                             const Query& query,
                                             ThreadPool& pool,
                                             const RunObserver& observer,
                                             LocalRunOptions options = {});

} // namespace cd
