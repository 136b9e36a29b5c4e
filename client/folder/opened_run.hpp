// A results folder that is read again.
#pragma once

#include "client/folder/run_manifest.hpp"
#include "client/job_file.hpp"
#include "client/prepared_job.hpp"
#include "common/core/result.hpp"
#include "common/job/contact_map.hpp"
#include "common/job/record_file.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace cd {

/// A run that is whole in its folder: what it was asked, and its records.
class OpenedRun {
  public:
    /// Errors: NotFound where there is no run; BadInput and Io naming the file, also for a folder
    /// of an earlier version, and for a run that has not ended.
    [[nodiscard]] static Result<OpenedRun> open(const std::filesystem::path& dir);

    [[nodiscard]] const std::filesystem::path& dir() const { return dir_; }
    [[nodiscard]] const RunManifest& manifest() const { return manifest_; }
    [[nodiscard]] const RecordFile& records() const { return records_; }
    [[nodiscard]] RecordFile& records() { return records_; }

    /// The job as its job file would give it, without an output folder. Errors: BadInput where
    /// run.json has a job that no job file can say.
    [[nodiscard]] Result<JobSpec> spec() const;
    /// The mesh of a body as it was tested: the one that is kept, or else that of the file which
    /// run.json names. Errors: NotFound, Io; BadInput where the file has changed since.
    [[nodiscard]] Result<std::shared_ptr<const Mesh>> mesh(std::size_t body) const;
    /// The poses that are kept; null where none are. Errors: Io.
    [[nodiscard]] Result<std::unique_ptr<PoseSource>> kept_poses() const;
    /// How the pose file named the scenarios; empty where it did not, and where that is not kept.
    /// Errors: Io.
    [[nodiscard]] Result<PoseLabels> kept_labels() const;
    /// The contact map of a job with maps. Errors: Io.
    [[nodiscard]] Result<std::optional<ContactMap>> kept_map() const;

  private:
    OpenedRun(std::filesystem::path dir, RunManifest manifest, RecordFile records)
        : dir_(std::move(dir)), manifest_(std::move(manifest)), records_(std::move(records)) {}

    std::filesystem::path dir_;
    RunManifest manifest_;
    RecordFile records_;
};

/// Whether a folder was written by an earlier version, without run.json and records.
[[nodiscard]] bool holds_only_a_summary(const std::filesystem::path& dir);

/// Whether an argument that may be a job's id is a folder instead.
[[nodiscard]] bool is_folder(const std::string& argument);

/// What the run was asked of: its meshes, the poses where they are kept, and what is ignored. Does
/// not need the folder's files any more. Errors: those of `OpenedRun`.
[[nodiscard]] Result<JobInputs> read_inputs(const OpenedRun& run);

/// The job, ready to be run again: `spec` is that of the run, perhaps changed. Errors: those of
/// `prepare_job`; BadInput naming a pose file that has changed; Interrupted.
[[nodiscard]] Result<PreparedJob> prepare_again(const RunManifest& manifest,
                                                JobInputs inputs,
                                                JobSpec spec,
                                                Trees trees,
                                                TreeCache& cache,
                                                ThreadPool& pool,
                                                bool quiet = true);

/// What exports of the run say beside its results. Errors: those of `OpenedRun::mesh`.
[[nodiscard]] Result<ExportContext> export_context(const OpenedRun& run);

} // namespace cd
