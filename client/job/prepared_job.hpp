// A job whose inputs have been read and checked; `run` and `submit` start from it.
#pragma once

#include "client/export/result_writer.hpp"
#include "client/import/imported_mesh.hpp"
#include "client/report/report.hpp"
#include "client/spec/job_file.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "common/job/result/merge.hpp"
#include "common/scene/step_index.hpp"
#include "common/tree/obb_tree.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// What a job with [bodies] has besides its meshes and scenarios.
struct JobScene {
    std::vector<BodySpec> files; ///< The mesh file of each body.
    std::vector<bool> are_fixed; ///< For each body, whether it has one pose at all steps.
    std::shared_ptr<const StepIndex> steps;
    SceneHead head;
};

struct PreparedJob {
    JobSpec spec;
    std::vector<std::string> names;                    ///< Names of the bodies in messages.
    std::vector<std::shared_ptr<const Mesh>> meshes;   ///< By body; equal for one file.
    std::vector<std::shared_ptr<const ObbTree>> trees; ///< By body; empty if none are needed.
    Query query;
    std::optional<Grid> grid; ///< Set if the poses are a grid; submitted in place of poses.
    std::unique_ptr<PoseSource> poses;
    /// The bodies, rules and steps of a job with [bodies].
    std::optional<JobScene> scene;
    PoseLabels labels;                 ///< Ids and times of all poses, if their file has them.
    std::vector<std::string> zeros;    ///< Columns missing in the pose file, which count as 0.
    std::vector<std::string> warnings; ///< Warnings of one line each.
    std::string header;                ///< Lines about bodies and poses (`header_text`).
};

/// When `prepare_job` gets trees. A run in this process always needs trees. A cluster builds its
/// own, so for a job on a master they are needed only to generate random poses.
enum class Trees : std::uint8_t { Always, ForPosesOnly };

/// Inputs in memory, which replace the files that the job names.
struct JobInputs {
    std::vector<std::shared_ptr<const Mesh>> meshes{};  ///< By body; empty: files are imported.
    std::unique_ptr<PoseSource> poses;                  ///< If null, poses are opened or generated.
    PoseLabels labels{};                                ///< Labels of `poses`.
    std::vector<std::string> names{};                   ///< Of a scene's bodies.
    std::optional<JobScene> scene{};                    ///< Of a scene whose `poses` are given.
    std::optional<std::vector<IgnoredRange>> ignored{}; ///< If nothing, the job's rules apply.
};

/// Imports the meshes, resolves ignored triangles, opens or generates the poses, and gets the trees
/// in the forms that the job needs. A job with [bodies] is prepared from its files alone, as by
/// `prepare_scene`, unless `given` has meshes, poses and scene. The result is bit-identical for any
/// number of threads and any cache content. Unless `quiet`, a line on stderr names each step longer
/// than half a second. Errors: BadInput, NotFound and Io, each naming the file.
[[nodiscard]] Result<PreparedJob> prepare_job(JobSpec spec,
                                              Trees trees,
                                              TreeCache& cache,
                                              ThreadPool& pool,
                                              bool quiet = true,
                                              JobInputs given = {});

/// Returns with what the job's digest starts; nothing unless it is a scene.
[[nodiscard]] std::optional<SceneHead> scene_head(const PreparedJob& job);

/// Returns a merger for the results of all scenarios of the job.
[[nodiscard]] ResultMerger merger_of(const PreparedJob& job);

/// Returns a path as an absolute one; "-" stays.
[[nodiscard]] std::string absolute_path(const std::filesystem::path& path);

/// Makes the paths of a job absolute, so that it can be opened from another folder.
void make_paths_absolute(JobSpec& spec);
void make_paths_absolute(PreparedJob& job);

/// Returns the mesh of the lines of [shots], which is body B, for the mesh of A. Errors: as
/// `shot_mesh`.
[[nodiscard]] Result<std::shared_ptr<const Mesh>> lines_of(const ShotsSpec& spec, const Mesh& a);

/// Returns the directions of the lines of [shots], which cover the box of the job or, if it has
/// none, the mesh of A; null for a job without lines.
[[nodiscard]] std::shared_ptr<const ShotViews> views_of(const JobSpec& spec, const Mesh& a);

/// Returns the options to import a body's file. Errors: BadInput for an unknown unit.
[[nodiscard]] Result<ImportOptions> import_options(const JobSpec& spec, std::size_t body);

/// Returns how a body's mesh file is read.
[[nodiscard]] const BodySpec& body_spec(const PreparedJob& job, std::size_t body);

/// Returns what exports say of a job. Of a scene with lines it refers to the job's poses, which
/// outlive it.
[[nodiscard]] ExportContext export_context(const PreparedJob& job);
/// Returns the names of the bodies' files, without endings (`body_file_name`).
[[nodiscard]] std::array<std::string, 2> body_file_names(const PreparedJob& job);

/// Returns the ranges of triangles that the job's rules ignore. Errors: BadInput with the rule, its
/// line and the existing names, for a pattern that matches no part or names another body.
[[nodiscard]] Result<std::vector<IgnoredRange>>
resolve_ignored(const JobSpec& spec, const Mesh& a, const Mesh& b);

} // namespace cd
