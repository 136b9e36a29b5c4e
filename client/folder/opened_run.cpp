#include "client/folder/opened_run.hpp"

#include "client/base/interrupt.hpp"
#include "client/folder/run_folder.hpp"
#include "client/folder/run_recorder.hpp"
#include "client/import/mesh_import.hpp"
#include "client/job/submission.hpp"
#include "client/poses/label_file.hpp"
#include "client/remote/mesh_cache.hpp"
#include "client/scene/mesh_split.hpp"
#include "client/scene/prepared_scene.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/job/poses/poses_hash.hpp"
#include "common/job/scenario_file.hpp"

#include <map>

namespace cd {

namespace {

namespace fs = std::filesystem;

Error no_run(const fs::path& dir) {
    if (const auto unfinished = read_run_json(dir / ".part" / "run.json")) {
        return bad_input(dir.string() + " holds an unfinished run of " +
                         counted(unfinished.value().poses.count, "scenario") +
                         "; resume it with: " + unfinished.value().origin.command);
    }
    if (holds_only_a_summary(dir)) {
        return bad_input(dir.string() +
                         " was written by an earlier version, without run.json and records: "
                         "only its summary.json can be opened; run the job again");
    }
    return {ErrorCode::NotFound, dir.string() + " holds no run: it has no run.json"};
}

Error changed(const std::string& file) {
    return bad_input(file +
                     " has changed since the run; restore the old file, or run the job again");
}

Result<std::shared_ptr<const Mesh>> changed_lines(const ShotsSpec& shots) {
    return changed(shots.is_grid() ? "the grid of lines" : shots.file.string());
}

Error damaged(const fs::path& file, const std::string& what) {
    return {ErrorCode::Io,
            file.string() + " is damaged: " + what + "; run the job again with --fresh"};
}

/// Imports the mesh file of a body of a scene. Returns the whole mesh if that is expected, else the
/// meshes of all its parts, one of which may be. Errors: as `import_mesh` and `split_mesh`.
Result<std::vector<std::shared_ptr<const Mesh>>>
whole_or_parts(const BodySpec& body, const std::string& unit, const Sha256& expected) {
    const auto options = CD_TRY(import_options(body, unit));
    const auto imported = CD_TRY(import_mesh(body.path, options));
    if (imported.mesh->hash() == expected) {
        return std::vector{imported.mesh};
    }
    std::vector<std::shared_ptr<const Mesh>> meshes;
    const auto parts = CD_TRY(split_mesh(*imported.mesh));
    for (const PartMesh& part : parts) {
        meshes.push_back(part.mesh);
    }
    return meshes;
}

/// Imports a body's mesh file. Errors: as `import_mesh`; BadInput if the mesh has changed.
Result<std::shared_ptr<const Mesh>>
import_again(const BodySpec& body, const std::string& unit, const Sha256& expected) {
    const auto options = CD_TRY(import_options(body, unit));
    const auto imported = CD_TRY(import_mesh(body.path, options));
    if (imported.mesh->hash() != expected) {
        return changed(body.path.string());
    }
    return imported.mesh;
}

/// Returns the scenarios of a scene: those that its folder keeps, or else those of its files again.
Result<std::shared_ptr<PoseSource>> poses_of_scene(const OpenedRun& run, const JobSpec& spec) {
    if (auto kept = CD_TRY(run.kept_poses())) {
        return std::shared_ptr<PoseSource>(std::move(kept));
    }
    auto prepared = CD_TRY(prepare_scene(spec, true, &InterruptGuard::has_come));
    const Sha256 hash = CD_TRY(hash_of(*prepared.poses, &InterruptGuard::has_come));
    if (hash != run.manifest().poses.hash) {
        return changed("a file of the scene's poses or bodies");
    }
    return std::shared_ptr<PoseSource>(std::move(prepared.poses));
}

} // namespace

Result<OpenedRun> OpenedRun::open(const fs::path& dir) {
    auto manifest = read_run_json(dir / "run.json");
    if (!manifest) {
        return manifest.error().code == ErrorCode::NotFound ? no_run(dir) : manifest.error();
    }
    auto records = CD_TRY(RecordFile::open(dir / "records"));
    if (records.count() != manifest.value().outcome.answered) {
        return damaged(dir / "records",
                       "it has " + grouped(records.count()) + " records, and run.json says " +
                           grouped(manifest.value().outcome.answered));
    }
    return OpenedRun(dir, std::move(manifest.value()), std::move(records));
}

Result<JobSpec> OpenedRun::spec() const {
    auto spec = CD_TRY(parse_job(manifest_.job, dir_ / "run.json"));
    spec.output.dir.clear();
    for (auto& [key, line] : spec.lines) {
        line = 0;
    }
    if (spec.scene) {
        return spec;
    }
    for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
        const ManifestBody& body = manifest_.bodies[i];
        spec.bodies[i].declared_unit = body.is_unit_given ? "" : body.unit;
    }
    return spec;
}

Result<std::vector<std::shared_ptr<const Mesh>>> OpenedRun::meshes() const {
    std::map<Sha256, std::shared_ptr<const Mesh>> known;
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (std::size_t body = 0; body < manifest_.bodies.size(); ++body) {
        const ManifestBody& wanted = manifest_.bodies[body];
        if (!known.contains(wanted.mesh)) {
            if (const auto kept = CD_TRY(kept_mesh(wanted))) {
                known.emplace(wanted.mesh, kept);
            } else if (manifest_.scene && body + 1 == manifest_.bodies.size() &&
                       manifest_.query.question == Question::Shots) {
                known.emplace(wanted.mesh, CD_TRY(lines_again()));
            } else if (manifest_.scene) {
                const auto imported =
                    CD_TRY(whole_or_parts(spec_of(wanted, body), manifest_.unit, wanted.mesh));
                for (const auto& each : imported) {
                    known.emplace(each->hash(), each);
                }
            } else {
                known.emplace(wanted.mesh, CD_TRY(mesh_again(body, meshes)));
            }
        }
        const auto mesh = known.find(wanted.mesh);
        if (mesh == known.end()) {
            return changed(wanted.file);
        }
        meshes.push_back(mesh->second);
    }
    return meshes;
}

Result<std::shared_ptr<const Mesh>> OpenedRun::kept_mesh(const ManifestBody& wanted) const {
    auto kept =
        read_mesh_file(mesh_file_path(dir_ / "inputs" / "meshes", wanted.mesh), wanted.mesh);
    if (kept) {
        return kept;
    }
    if (kept.error().code == ErrorCode::NotFound) {
        return std::shared_ptr<const Mesh>();
    }
    return Error{kept.error().code,
                 kept.error().detail + "; remove it to import " + wanted.file +
                     " again, or run the job again with --fresh"};
}

Result<std::shared_ptr<const Mesh>>
OpenedRun::mesh_again(std::size_t body, std::span<const std::shared_ptr<const Mesh>> before) const {
    const Sha256& wanted = manifest_.bodies[body].mesh;
    const auto job = CD_TRY(spec());
    if (const auto* shots = std::get_if<ShotsSpec>(&job.poses); shots != nullptr && body == 1) {
        const auto lines = CD_TRY(lines_of(*shots, *before[0]));
        return lines->hash() == wanted ? lines : changed_lines(*shots);
    }
    return import_again(job.bodies[body], manifest_.unit, wanted);
}

Result<std::shared_ptr<const Mesh>> OpenedRun::lines_again() const {
    const auto job = CD_TRY(spec());
    const ShotsSpec* const shots = shots_of(job);
    if (shots == nullptr || !shots->box) {
        return damaged(dir_ / "run.json", "its job has no lines, or not the box that they cover");
    }
    Mesh lines = CD_TRY(shot_mesh(*shots, *shots->box));
    return lines.hash() == manifest_.bodies.back().mesh
               ? std::make_shared<const Mesh>(std::move(lines))
               : changed_lines(*shots);
}

Result<std::optional<JobScene>> OpenedRun::scene() const {
    if (!manifest_.scene) {
        return std::optional<JobScene>();
    }
    const fs::path path = dir_ / "steps";
    const std::string bytes = CD_TRY(read_file(path));
    const std::vector<JobBody> bodies(manifest_.bodies.begin(), manifest_.bodies.end());
    auto scene = scene_of(
        bodies, std::as_bytes(std::span(bytes)), manifest_.poses.count, manifest_.scene->head);
    return scene ? Result<std::optional<JobScene>>(std::move(scene.value()))
                 : damaged(path, scene.error().detail);
}

Result<std::unique_ptr<PoseSource>> OpenedRun::kept_poses() const {
    if (manifest_.poses.grid) {
        return make_grid_source(*manifest_.poses.grid);
    }
    const fs::path path = dir_ / "inputs" / "scenarios";
    std::error_code error;
    if (!fs::exists(path, error)) {
        return std::unique_ptr<PoseSource>();
    }
    auto poses = CD_TRY(open_scenario_file(path));
    if (poses->count() != manifest_.poses.count) {
        return damaged(path, "scenarios are missing in it");
    }
    return poses;
}

Result<PoseLabels> OpenedRun::kept_labels() const {
    const fs::path path = dir_ / "inputs" / "ids";
    auto labels = read_labels(path);
    if (!labels) {
        return labels.error().code == ErrorCode::NotFound ? PoseLabels{} : labels;
    }
    const ManifestPoses& poses = manifest_.poses;
    LabelColumns columns = labels.value().columns();
    columns.has_times = poses.labels.times;
    columns.has_end_times = poses.labels.end_times;
    const bool is_whole = (columns.ids != IdKind::None) == poses.labels.ids &&
                          columns.fit(labels.value(), poses.count);
    return is_whole ? std::move(labels) : damaged(path, "ids or times are missing");
}

Result<std::optional<ContactMap>> OpenedRun::kept_map() const {
    std::error_code error;
    if (!manifest_.query.maps || !fs::exists(dir_ / "maps", error)) {
        return std::optional<ContactMap>();
    }
    auto map = read_maps(dir_ / "maps");
    if (!map) {
        return Error{map.error().code, map.error().detail + "; run the job again with --fresh"};
    }
    return std::optional(std::move(map.value()));
}

bool holds_only_a_summary(const fs::path& dir) {
    std::error_code error;
    return fs::exists(dir / "summary.json", error) && !fs::exists(dir / "run.json", error) &&
           !fs::exists(dir / ".part" / "run.json", error);
}

bool is_folder(const std::string& argument) {
    std::error_code error;
    return fs::is_directory(argument, error);
}

Result<JobInputs> read_inputs(const OpenedRun& run) {
    JobInputs inputs;
    inputs.meshes = CD_TRY(run.meshes());
    inputs.poses = CD_TRY(run.kept_poses());
    if (inputs.poses) {
        inputs.labels = CD_TRY(run.kept_labels());
        inputs.scene = CD_TRY(run.scene());
    }
    for (const ManifestBody& body : run.manifest().bodies) {
        inputs.names.push_back(body.name);
    }
    inputs.ignored = run.manifest().query.ignored;
    return inputs;
}

Result<PreparedJob> prepare_again(const RunManifest& manifest,
                                  JobInputs inputs,
                                  JobSpec spec,
                                  Trees trees,
                                  TreeCache& cache,
                                  ThreadPool& pool,
                                  bool quiet) {
    const bool are_kept = inputs.poses != nullptr;
    auto job = CD_TRY(prepare_job(std::move(spec), trees, cache, pool, quiet, std::move(inputs)));
    if (!are_kept && manifest.poses.hash) {
        const Sha256 hash = CD_TRY(hash_of(*job.poses, &InterruptGuard::has_come));
        if (hash != manifest.poses.hash) {
            return changed(manifest.poses.file);
        }
    }
    return job;
}

Result<ExportContext> export_context(const OpenedRun& run) {
    const RunManifest& manifest = run.manifest();
    ExportContext context;
    context.job = manifest.name;
    context.unit = manifest.unit;
    context.describe(manifest.query);
    context.stop = &InterruptGuard::has_come;
    const auto meshes = CD_TRY(run.meshes());
    for (std::size_t i = 0; i < manifest.bodies.size(); ++i) {
        const ManifestBody& body = manifest.bodies[i];
        context.bodies.push_back({body.name,
                                  fs::path(body.file).filename().string(),
                                  meshes[i],
                                  body.rounds_to_float,
                                  body.is_fixed});
    }
    if (auto scene = CD_TRY(run.scene())) {
        context.steps = scene->steps;
        context.times = MotionTimes(scene->steps);
    } else if (context.has_motions()) {
        context.times = MotionTimes(std::make_shared<const PoseLabels>(CD_TRY(run.kept_labels())));
    }
    if (manifest.query.question == Question::Shots) {
        const auto job = CD_TRY(run.spec());
        context.bodies.back().views = views_of(job, *context.bodies[0].mesh);
        if (job.scene) {
            context.bodies.back().poses = CD_TRY(poses_of_scene(run, job));
        }
    }
    return context;
}

} // namespace cd
