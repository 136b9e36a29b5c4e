// Writes a run into a results folder, from its begin or resumption to its final files.
#pragma once

#include "client/export/result_sink.hpp"
#include "client/folder/pose_recorder.hpp"
#include "client/folder/run_folder.hpp"
#include "client/folder/run_manifest.hpp"
#include "client/folder/run_recorder.hpp"
#include "client/job/prepared_job.hpp"
#include "client/report/report.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/result.hpp"
#include "common/core/timing/client.hpp"
#include "common/job/result/merge.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace cd {

struct FolderRunOptions {
    FolderOptions folder;
    bool keep_inputs = true; ///< Copy meshes and poses into the folder, if they fit.
    std::uint64_t inputs_bytes_max = limits::run_inputs_bytes_max;
    bool maps_from_master = false; ///< The master, not this process, sums contact maps.
    ManifestPlace where;
    std::string command; ///< Command line of the run.
    std::string started; ///< The run's start as `iso_time`; empty: now.
    std::string ended;   ///< The run's end as `iso_time`; empty: when `finish` is called.
    std::optional<ManifestReuse> reused; ///< The earlier run from which results are taken.
};

/// Writes each result of a run to the folder as it arrives, and all exports at the end.
class FolderRun {
  public:
    /// Opens the job's output folder, and wraps `job.poses` so that poses are recorded as they are
    /// read. Errors: as `RunFolder::open`; from reading poses; Interrupted.
    [[nodiscard]] static Result<FolderRun> begin(PreparedJob& job, FolderRunOptions options);

    /// True if the folder already has all results of the job; then only `folder` may be called.
    [[nodiscard]] bool is_complete() const { return folder_.state() == RunFolder::State::All; }
    [[nodiscard]] RunFolder& folder() { return folder_; }

    /// Sets the master's id of the job and its number of workers in the manifest.
    void set_job(const std::string& id, std::uint64_t workers) {
        manifest_.where.job = id;
        manifest_.where.workers = workers;
    }

    /// Sets the number of results that the run takes from an earlier run.
    void set_reused(std::uint64_t scenarios) { manifest_.outcome.reused->scenarios = scenarios; }

    /// Reads the results of scenarios 0 to n - 1, which an interrupted run has left. Errors: Io;
    /// Interrupted.
    [[nodiscard]] Result<ResultMerger> done() const;

    /// Adds the next result. Errors: Io.
    [[nodiscard]] Status add(const DoneScenario& done) { return recorder_->add(done); }
    /// Adds the next results, as `add` does one.
    [[nodiscard]] Status add(const DoneBlock& done) { return recorder_->add(done); }
    /// Writes buffered results to the disk if `timing::record_flush_period` has passed. Errors: Io.
    [[nodiscard]] Status keep_if_due() { return recorder_->flush_if_due(); }
    /// Writes buffered results to the disk. Errors: Io.
    [[nodiscard]] Status keep() { return recorder_->flush(); }
    /// Returns the number of scenarios whose results are on the disk.
    [[nodiscard]] std::uint64_t kept() const { return recorder_->kept(); }

    /// Writes exports, the summary and run.json, and the results in the format `output` to stdout.
    /// Completes the report from the records. `fetched_map` is a map that the master summed.
    /// Errors: Io; from reading poses; Interrupted.
    [[nodiscard]] Status finish(RunReport& report,
                                const std::string& output,
                                const std::optional<ContactMap>& fetched_map);
    /// Removes unfinished files, unless `finish` succeeded: for a run that cannot be resumed.
    void drop_unfinished();

  private:
    FolderRun(RunFolder folder, RunManifest manifest, const PreparedJob& job)
        : folder_(std::move(folder)), manifest_(std::move(manifest)), job_(&job) {}

    [[nodiscard]] Status open_files(PreparedJob& job);
    [[nodiscard]] Status finish_inputs();
    [[nodiscard]] Status keep_inputs() const;
    [[nodiscard]] Result<std::optional<ContactMap>>
    finish_maps(const std::optional<ContactMap>& fetched) const;

    RunFolder folder_;
    RunManifest manifest_;
    const PreparedJob* job_;
    bool wants_inputs_ = true;
    bool keeps_inputs_ = true; ///< Becomes false when inputs are larger than allowed.
    std::uint64_t inputs_bytes_max_ = 0;
    bool maps_from_master_ = false;
    bool is_finished_ = false;
    PoseRecorder* poses_ = nullptr; ///< Owned by `job_`; null for a grid.
    std::optional<RunRecorder> recorder_;
};

/// Returns the manifest of a prepared job, without results. It lacks the hash of random poses,
/// which are generated during the run. Errors: from reading poses; Interrupted.
[[nodiscard]] Result<RunManifest> manifest_of(const PreparedJob& job);

/// Returns about how many bytes a job's meshes and labels take in its results folder.
[[nodiscard]] std::uint64_t bytes_beside_poses(const PreparedJob& job);
/// Returns a lower bound in bytes for a folder's inputs: `bytes_beside_poses` and the poses.
[[nodiscard]] std::uint64_t input_bytes(const PreparedJob& job);

/// Returns the command line of this process.
[[nodiscard]] std::string own_command_line();

} // namespace cd
