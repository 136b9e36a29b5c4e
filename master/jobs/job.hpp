// One job of the master, from its acceptance until it is forgotten.
#pragma once

#include "common/job/poses/pose_source.hpp"
#include "master/compute/analyser.hpp"
#include "master/compute/result_check.hpp"
#include "master/dispatch/worker_pace.hpp"
#include "master/geometry/mesh_hold.hpp"
#include "master/jobs/given_places.hpp"
#include "master/jobs/merged_results.hpp"
#include "master/jobs/open_analyses.hpp"
#include "master/jobs/place_queue.hpp"
#include "master/journal/job_map.hpp"
#include "master/journal/journal.hpp"
#include "master/journal/ledger.hpp"
#include "master/journal/result_store.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/traffic.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cd {

using Clock = std::chrono::steady_clock;

/// Learned seconds per scenario, by which the master chooses between analysis and ranges.
struct JobRates {
    LearnedRate analysis;
    LearnedRate matching; ///< To match and send one analysed scenario.
    LearnedRate work;     ///< Of a worker's thread.
};

/// A job that hands out work: from when its geometry is loaded until it ends.
struct JobWork {
    std::shared_ptr<const JobMaterial> material;
    AnalysisInput analysis_input;
    std::vector<TreeId> trees; ///< Of the bodies, in their order.
    std::shared_ptr<OrderedPoses> order;
    PlaceQueue todo;                    ///< Positions to hand out.
    std::uint64_t places_loading = 0;   ///< Taken from `todo`, poses still loading.
    PlacesAtDispatcher given;           ///< At the dispatcher.
    std::unique_ptr<Analyser> analyser; ///< Made when the first analysis begins.
    OpenAnalyses open;
    JobRates rates;
    /// By index: scenarios with a result, which an analysis skips. Null: not made yet, or stale.
    std::shared_ptr<const std::vector<bool>> done;
    std::vector<std::uint64_t> cancelled; ///< Scenarios cancelled one by one.

    /// Blocks that the analyser has started and not delivered.
    [[nodiscard]] std::uint64_t analyses_under_way() const {
        return analyser == nullptr ? 0 : analyser->under_way();
    }
};

/// A job that has not ended.
struct JobRun {
    std::shared_ptr<PoseSource> poses;
    std::string paused;            ///< Disk error that pauses the job; empty if none.
    std::uint64_t disputes = 0;    ///< Number of results to be judged.
    std::unique_ptr<JobWork> work; ///< Null until the geometry is loaded.
    // From before a restart of the master, until `work` is there.
    std::vector<LostPlaces> losses_before;
    std::vector<Dispute> disputes_before;
};

/// What a job has cost so far; part of its progress in the journal.
struct JobTally {
    std::uint64_t answered_by_master = 0;
    std::uint64_t withdrawn = 0; ///< Results of quarantined workers that were withdrawn.
    JobStatistics statistics;
    double compute_seconds = 0;
    JobTraffic traffic;
    HelpAtEnd help;
    std::vector<std::uint32_t> depths; ///< Cut depth of each body; empty before the cut.
};

struct JobTimes {
    std::uint64_t began = 0; ///< Seconds since 1970.
    Clock::time_point started;
    double seconds_before = 0; ///< Run time before the last restart of the master.
    Clock::time_point ended;
};

/// One job. Its phases: it runs without work, then with it (`run`), then it has ended (`end`).
struct MasterJob {
    /// A job that runs.
    MasterJob(JobId job,
              Submit submission,
              std::shared_ptr<ResultStore> store,
              Clock::time_point now);
    /// Restores a job from before a restart of the master. Leaves its results and disputes, which
    /// the caller restores.
    MasterJob(RecoveredJob&& recovered, Clock::time_point now);

    JobId id;
    Submit submit; ///< Without its bulk after the end (`drop_bulk`).
    JobTimes times;
    std::shared_ptr<const MeshHold> meshes; ///< Prevents removal of the meshes.
    MergedResults merged;
    std::shared_ptr<ResultStore> results;
    JobMap map; ///< Used only if the query asks for maps.
    JobTally tally;
    std::uint64_t changes = 0; ///< Incremented when the status changes, except for its times.
    std::optional<JobRun> run; ///< Empty after the end.
    std::optional<JobEnd> end; ///< Clients see it once the journal has committed it.
    bool is_announced = false; ///< Clients see `end`.

    [[nodiscard]] bool is_running() const { return run.has_value(); }
    /// Null unless the job runs and its geometry is loaded.
    [[nodiscard]] JobWork* work() const { return run ? run->work.get() : nullptr; }
    /// The state as shown to clients.
    [[nodiscard]] JobState state() const { return is_announced ? end->state : JobState::Running; }
    /// Ends a running job, and frees what only a running job needs. JobState::Done computes the
    /// digest.
    void finish(JobState state, const std::string& failure, Clock::time_point now);
    /// Progress record for the journal.
    [[nodiscard]] JobProgress progress(Clock::time_point now) const;
    [[nodiscard]] JobStatus status(Clock::time_point now) const;
};

} // namespace cd
