// The state of one job on the master, from its acceptance until it is forgotten.
#pragma once

#include "common/job/poses/ordered_poses.hpp"
#include "master/compute/analyser.hpp"
#include "master/compute/result_check.hpp"
#include "master/dispatch/worker_pace.hpp"
#include "master/geometry/mesh_hold.hpp"
#include "master/jobs/merged_results.hpp"
#include "master/jobs/open_analyses.hpp"
#include "master/jobs/position_queue.hpp"
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

/// Learned costs per scenario, by which the master chooses between analysis and ranges.
struct JobRates {
    LearnedRate analysis; ///< Seconds of the analysis on one pool thread of the master.
    LearnedRate matching; ///< Seconds of matching and sending an analysed scenario.
    LearnedRate work;     ///< Seconds of the search on one thread of a worker.
    LearnedRate bytes;    ///< Bytes that analysis adds to a scenario on the wire.
};

/// State of a job that hands out work. Exists from the loading of its geometry until its end.
struct JobWork {
    std::shared_ptr<const JobMaterial> material;
    AnalysisInput analysis_input;
    std::vector<TreeId> trees;           ///< One for each body, in the order of the bodies.
    PositionQueue todo;                  ///< Positions to hand out.
    std::uint64_t positions_loading = 0; ///< Positions from `todo` whose poses are loading.
    std::unique_ptr<Analyser> analyser;  ///< Made when the first analysis begins.
    OpenAnalyses open;
    JobRates rates;
    /// Entry i: true if scenario i has a result, so that an analysis skips the scenario. Null: not
    /// computed yet, or no scenario had a result.
    std::shared_ptr<const std::vector<bool>> done;
    std::vector<std::uint64_t> cancelled; ///< Scenarios cancelled one by one.

    /// Number of blocks (`AnalysedBlock`) whose analysis has started and that were not taken yet.
    [[nodiscard]] std::uint64_t analyses_under_way() const {
        return analyser == nullptr ? 0 : analyser->under_way();
    }
};

/// State of a job that has not ended.
struct JobRun {
    std::shared_ptr<OrderedPoses> poses;
    std::string paused;            ///< Disk error that pauses the job; empty if none.
    std::uint64_t disputes = 0;    ///< Number of disputes that the master has not decided.
    std::unique_ptr<JobWork> work; ///< Null until the geometry is loaded.
    // Restored after a restart of the master, until `work` exists.
    std::vector<LostPositions> losses_before;
    std::vector<Dispute> disputes_before;
};

/// Costs of a job so far, which the journal keeps as part of its progress.
struct JobTally {
    std::uint64_t answered_by_master = 0;
    std::uint64_t withdrawn = 0; ///< Number of withdrawn results, from quarantined workers.
    JobStatistics statistics;
    double compute_seconds = 0;
    JobTraffic traffic;
    HelpAtEnd help;
    std::vector<std::uint32_t> depths; ///< Cut depth of each body; empty before the cut.
};

struct JobTimes {
    std::uint64_t began = 0; ///< Time of acceptance, in seconds since 1970.
    Clock::time_point started;
    double seconds_before = 0; ///< Run time before the last restart of the master, s.
    Clock::time_point ended;
};

/// A job goes through three phases: it runs but has no work yet (`run`), it hands out work
/// (`run->work`), and it has ended (`end`).
struct MasterJob {
    /// Makes a new job, which runs.
    MasterJob(JobId job,
              Submit submission,
              std::shared_ptr<ResultStore> store,
              Clock::time_point now);
    /// Restores a job after a restart of the master. The caller restores the authors of its results
    /// and its disputes.
    MasterJob(RecoveredJob&& recovered, Clock::time_point now);

    JobId id;
    Submit submit; ///< When the job ends, `drop_bulk` empties the large fields.
    JobTimes times;
    std::shared_ptr<const MeshHold> meshes; ///< Keeps the job's meshes from being removed.
    MergedResults merged;
    std::shared_ptr<ResultStore> results;
    JobMap map; ///< Used only if the query asks for maps.
    JobTally tally;
    std::uint64_t changes = 0; ///< Incremented when the status changes, apart from its times.
    std::optional<JobRun> run; ///< Empty after the end.
    std::optional<JobEnd> end; ///< Empty before the end.
    bool is_announced = false; ///< The journal has committed `end`, and clients see it.

    [[nodiscard]] bool is_running() const { return run.has_value(); }
    /// Null unless the job runs and its geometry is loaded.
    [[nodiscard]] JobWork* work() const { return run ? run->work.get() : nullptr; }
    /// The state as shown to clients.
    [[nodiscard]] JobState state() const { return is_announced ? end->state : JobState::Running; }
    /// Ends a running job, and frees the data that only a running job needs. With JobState::Done,
    /// all scenarios must have a result.
    void finish(JobState state, const std::string& failure, Clock::time_point now);
    /// Progress record for the journal.
    [[nodiscard]] JobProgress progress(Clock::time_point now) const;
    [[nodiscard]] JobStatus status(Clock::time_point now) const;
};

} // namespace cd
