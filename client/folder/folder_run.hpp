// A run into a results folder, from the decision where to begin to the files that stay.
#pragma once

#include "client/export/result_sink.hpp"
#include "client/folder/pose_recorder.hpp"
#include "client/folder/run_folder.hpp"
#include "client/folder/run_manifest.hpp"
#include "client/folder/run_recorder.hpp"
#include "client/prepared_job.hpp"
#include "client/report.hpp"
#include "common/core/limits_client.hpp"
#include "common/core/result.hpp"
#include "common/job/merge.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cd {

struct FolderRunOptions {
    FolderOptions folder;
    bool keep_inputs = true;                                       ///< Where they take at most
    std::uint64_t inputs_bytes_max = limits::run_inputs_bytes_max; ///< so many bytes.
    bool maps_from_master = false; ///< They are not summed of the results' pairs.
    ManifestPlace where;
    std::string command; ///< The command line.
    std::string started; ///< `iso_time`; empty: now, or when the part that is gone on from began.
    std::string ended;   ///< Empty: when it is finished.
};

/// Keeps each result as it comes, and makes all exports of the records at the end.
class FolderRun {
  public:
    /// Takes the job's output folder. From here on `job.poses` are kept as they are read. Errors:
    /// those of `RunFolder::open` and of reading poses; Interrupted.
    [[nodiscard]] static Result<FolderRun> begin(PreparedJob& job, FolderRunOptions options);

    /// The folder holds all of this job already; then nothing may be called but `folder`.
    [[nodiscard]] bool is_complete() const { return folder_.state() == RunFolder::State::All; }
    [[nodiscard]] RunFolder& folder() { return folder_; }

    /// Names the job of a master, and how many workers that has.
    void set_job(const std::string& id, std::uint64_t workers) {
        manifest_.where.job = id;
        manifest_.where.workers = workers;
    }

    /// What an earlier run has done of the first scenarios. Errors: Io; Interrupted.
    [[nodiscard]] Result<ResultMerger> done() const;

    /// The next result. Errors: Io.
    [[nodiscard]] Status add(const DoneScenario& done) { return recorder_->add(done); }
    /// Keeps what has come where it is time. Errors: Io.
    [[nodiscard]] Status keep_if_due() { return recorder_->flush_if_due(); }
    /// Keeps what has come. Errors: Io.
    [[nodiscard]] Status keep() { return recorder_->flush(); }
    /// Scenarios that a run after this one would not do again.
    [[nodiscard]] std::uint64_t kept() const { return recorder_->kept(); }

    /// Writes the exports, `output` on stdout, the summary and run.json, and completes the report
    /// with what only the records tell. `fetched_map` is the map that a master summed. Errors: Io;
    /// those of reading poses; Interrupted.
    [[nodiscard]] Status finish(RunReport& report,
                                const std::string& output,
                                const std::optional<ContactMap>& fetched_map);
    /// For a run that no later one goes on from: leaves nothing of it where `finish` did not
    /// succeed.
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
    bool keeps_inputs_ = true; ///< As far as is known.
    std::uint64_t inputs_bytes_max_ = 0;
    bool maps_from_master_ = false;
    bool is_finished_ = false;
    PoseRecorder* poses_ = nullptr; ///< The job owns it; null for a grid.
    std::optional<RunRecorder> recorder_;
};

/// What run.json says of a prepared job; the hash of random poses is left out, since they are made
/// while the run goes on. Errors: those of reading poses; Interrupted.
[[nodiscard]] Result<RunManifest> manifest_of(const PreparedJob& job);

/// What a folder's meshes take, and how its scenarios are called, about.
[[nodiscard]] std::uint64_t bytes_beside_poses(const PreparedJob& job);
/// The same with the poses, which is at least what a folder's inputs take.
[[nodiscard]] std::uint64_t input_bytes(const PreparedJob& job);

/// Whoever opens the job again may stand in another folder.
void make_paths_absolute(JobSpec& spec);

/// The command line of this process.
[[nodiscard]] std::string own_command_line();

} // namespace cd
