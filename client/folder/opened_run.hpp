// Opens results folders for reading.
#pragma once

#include "client/folder/run_manifest.hpp"
#include "client/job/prepared_job.hpp"
#include "client/spec/job_file.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/record_file.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// A finished run in a results folder: its manifest and its records.
class OpenedRun {
  public:
    /// Opens a folder. Errors: NotFound for a folder without a run; BadInput and Io naming the
    /// file, also for a folder of an earlier version and for an unfinished run.
    [[nodiscard]] static Result<OpenedRun> open(const std::filesystem::path& dir);

    [[nodiscard]] const std::filesystem::path& dir() const { return dir_; }
    [[nodiscard]] const RunManifest& manifest() const { return manifest_; }
    [[nodiscard]] const RecordFile& records() const { return records_; }
    [[nodiscard]] RecordFile& records() { return records_; }

    /// Returns the job as if read from its job file, without an output folder. Errors: BadInput if
    /// run.json holds a job that no job file can express.
    [[nodiscard]] Result<JobSpec> spec() const;
    /// Returns the mesh of each body as it was tested: the copy in the folder, or else the file
    /// that run.json names, or a part of it. Bodies of one mesh share it, and all parts of a file
    /// come from one import. Errors: NotFound, Io; BadInput if a file has changed since the run.
    [[nodiscard]] Result<std::vector<std::shared_ptr<const Mesh>>> meshes() const;
    /// Opens the poses that the folder keeps; null if it keeps none. Errors: Io.
    [[nodiscard]] Result<std::unique_ptr<PoseSource>> kept_poses() const;
    /// Reads the scenario labels that the folder keeps; empty if it keeps none. Errors: Io.
    [[nodiscard]] Result<PoseLabels> kept_labels() const;
    /// Reads what the run's job has besides its meshes and poses if it is a scene; nothing for two
    /// bodies. Errors: Io.
    [[nodiscard]] Result<std::optional<JobScene>> scene() const;
    /// Reads the contact map in the folder; nothing if it has none. Errors: Io.
    [[nodiscard]] Result<std::optional<ContactMap>> kept_map() const;

  private:
    OpenedRun(std::filesystem::path dir, RunManifest manifest, RecordFile records)
        : dir_(std::move(dir)), manifest_(std::move(manifest)), records_(std::move(records)) {}

    /// Reads the copy of a mesh in the folder; null if there is none. Errors: Io.
    [[nodiscard]] Result<std::shared_ptr<const Mesh>> kept_mesh(const ManifestBody& wanted) const;
    /// Makes the mesh of one of two bodies again; `before` has those of the bodies before it.
    /// Errors: as `meshes`.
    [[nodiscard]] Result<std::shared_ptr<const Mesh>>
    mesh_again(std::size_t body, std::span<const std::shared_ptr<const Mesh>> before) const;

    /// Makes the lines of a scene again. Errors: as `meshes`; Io.
    [[nodiscard]] Result<std::shared_ptr<const Mesh>> lines_again() const;

    std::filesystem::path dir_;
    RunManifest manifest_;
    RecordFile records_;
};

/// True for a folder that an earlier version wrote, with summary.json but without run.json.
[[nodiscard]] bool holds_only_a_summary(const std::filesystem::path& dir);

/// True if an argument is a folder; otherwise it is taken for the id of a job.
[[nodiscard]] bool is_folder(const std::string& argument);

/// Reads the inputs of a run: meshes, poses if the folder has them, and ignored triangles. They
/// stay valid when the folder is overwritten. Errors: as the getters of `OpenedRun`.
[[nodiscard]] Result<JobInputs> read_inputs(const OpenedRun& run);

/// Prepares the job of a run to be run again. `spec` is the run's, possibly modified. Errors: as
/// `prepare_job`; BadInput naming a pose file that has changed; Interrupted.
[[nodiscard]] Result<PreparedJob> prepare_again(const RunManifest& manifest,
                                                JobInputs inputs,
                                                JobSpec spec,
                                                Trees trees,
                                                TreeCache& cache,
                                                ThreadPool& pool,
                                                bool quiet = true);

/// Returns the names, meshes and query for exports of a run. Errors: as `OpenedRun::meshes`.
[[nodiscard]] Result<ExportContext> export_context(const OpenedRun& run);

} // namespace cd
