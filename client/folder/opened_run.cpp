#include "client/folder/opened_run.hpp"

#include "client/folder/run_folder.hpp"
#include "client/folder/run_recorder.hpp"
#include "client/import/mesh_import.hpp"
#include "client/interrupt.hpp"
#include "client/units.hpp"
#include "client/words.hpp"
#include "common/job/poses_hash.hpp"
#include "common/job/scenario_file.hpp"

#include <array>
#include <fstream>
#include <sstream>

namespace cd {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> body_keys{"a", "b"};

Error no_run(const fs::path& dir) {
    if (const auto unfinished = read_run_json(dir / ".part" / "run.json")) {
        return {ErrorCode::BadInput,
                dir.string() + " holds an unfinished run of " +
                    counted(unfinished.value().poses.count, "scenario") +
                    "; the command that began it goes on with it: " + unfinished.value().command};
    }
    if (holds_only_a_summary(dir)) {
        return {ErrorCode::BadInput,
                dir.string() + " was written by an earlier version, without run.json and records: "
                               "only its summary.json can be opened; run the job again"};
    }
    return {ErrorCode::NotFound, dir.string() + " holds no run: it has no run.json"};
}

fs::path mesh_path(const fs::path& dir, const Sha256& mesh) {
    return dir / "inputs" / "meshes" / (to_hex(mesh) + ".mesh");
}

Result<std::shared_ptr<const Mesh>> read_kept_mesh(const fs::path& path, const Sha256& expected) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) {
        return Error{ErrorCode::Io, path.string() + ": cannot be read, or is empty"};
    }
    const std::string bytes = text.str();
    auto mesh = Mesh::from_canonical_bytes(std::as_bytes(std::span(bytes)));
    if (!mesh || mesh.value().hash() != expected) {
        return Error{ErrorCode::Io, path.string() + " is damaged: it has another SHA-256"};
    }
    return std::make_shared<const Mesh>(std::move(mesh.value()));
}

Error changed(const std::string& file) {
    return {ErrorCode::BadInput,
            file + " has changed since the run: it is not what was tested; put the old file back, "
                   "or run the job anew"};
}

Result<std::shared_ptr<const Mesh>> import_again(const ManifestBody& body,
                                                 const std::string& unit) {
    const auto factor = unit_factor(body.unit, unit);
    if (!factor) {
        return Error{ErrorCode::BadInput, "run.json: unit \"" + body.unit + "\" is not known"};
    }
    ImportOptions options{*factor};
    options.is_stopped = &InterruptGuard::has_come;
    auto imported = import_mesh(body.file, options);
    if (!imported) {
        return imported.error();
    }
    if (imported.value().mesh->hash() != body.mesh) {
        return changed(body.file);
    }
    return imported.value().mesh;
}

PosesSpec poses_spec_of(const ManifestPoses& poses) {
    if (poses.grid) {
        return *poses.grid;
    }
    if (poses.random) {
        return *poses.random;
    }
    return PoseFileSpec{poses.file,
                        poses.quat_order,
                        poses.of_both_bodies,
                        poses.rigid_tolerance,
                        poses.length_factor};
}

} // namespace

Result<OpenedRun> OpenedRun::open(const fs::path& dir) {
    auto manifest = read_run_json(dir / "run.json");
    if (!manifest) {
        return manifest.error().code == ErrorCode::NotFound ? no_run(dir) : manifest.error();
    }
    auto records = RecordFile::open(dir / "records");
    if (!records) {
        return records.error();
    }
    if (records.value().count() != manifest.value().answered) {
        return Error{ErrorCode::Io,
                     (dir / "records").string() + " is damaged: it has " +
                         grouped(records.value().count()) + " records, and run.json says " +
                         grouped(manifest.value().answered)};
    }
    return OpenedRun(dir, std::move(manifest.value()), std::move(records.value()));
}

Result<std::shared_ptr<const Mesh>> OpenedRun::mesh(std::size_t body) const {
    const ManifestBody& wanted = manifest_.bodies[body];
    const fs::path kept = mesh_path(dir_, wanted.mesh);
    std::error_code error;
    return fs::exists(kept, error) ? read_kept_mesh(kept, wanted.mesh)
                                   : import_again(wanted, manifest_.unit);
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
    auto poses = open_scenario_file(path);
    if (poses && poses.value()->count() != manifest_.poses.count) {
        return Error{ErrorCode::Io, path.string() + " is damaged: scenarios are missing in it"};
    }
    return poses;
}

Result<std::optional<ContactMap>> OpenedRun::kept_map() const {
    std::error_code error;
    if (!manifest_.query.maps || !fs::exists(dir_ / "maps", error)) {
        return std::optional<ContactMap>();
    }
    auto map = read_maps(dir_ / "maps");
    return map ? Result<std::optional<ContactMap>>(std::move(map.value())) : map.error();
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

JobSpec spec_of(const RunManifest& manifest) {
    JobSpec spec;
    spec.name = manifest.name;
    spec.unit = manifest.unit;
    for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
        const ManifestBody& body = manifest.bodies[i];
        spec.bodies[i] = {body.file, body.unit, body.name == body_keys[i] ? "" : body.name};
    }
    spec.poses = poses_spec_of(manifest.poses);
    spec.level = manifest.query.level;
    spec.tolerance = manifest.query.tolerance;
    spec.limit_pairs = manifest.query.limit_pairs;
    spec.maps = manifest.query.maps;
    return spec;
}

Result<JobInputs> read_inputs(const OpenedRun& run) {
    JobInputs inputs;
    for (std::size_t body = 0; body < inputs.meshes.size(); ++body) {
        const auto& bodies = run.manifest().bodies;
        if (body == 1 && bodies[1].mesh == bodies[0].mesh) {
            inputs.meshes[1] = inputs.meshes[0];
            continue;
        }
        auto mesh = run.mesh(body);
        if (!mesh) {
            return mesh.error();
        }
        inputs.meshes[body] = std::move(mesh.value());
    }
    auto poses = run.kept_poses();
    if (!poses) {
        return poses.error();
    }
    inputs.poses = std::move(poses.value());
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
    auto job = prepare_job(std::move(spec), trees, cache, pool, quiet, std::move(inputs));
    if (!job || are_kept || !manifest.poses.hash) {
        return job;
    }
    const auto hash = hash_of(*job.value().poses, &InterruptGuard::has_come);
    if (!hash) {
        return hash.error();
    }
    return hash.value() == manifest.poses.hash ? std::move(job) : changed(manifest.poses.file);
}

Result<ExportContext> export_context(const OpenedRun& run) {
    const RunManifest& manifest = run.manifest();
    ExportContext context;
    context.job = manifest.name;
    context.unit = manifest.unit;
    context.level = manifest.query.level;
    context.tolerance = manifest.query.tolerance;
    context.stop = &InterruptGuard::has_come;
    for (std::size_t i = 0; i < manifest.bodies.size(); ++i) {
        auto mesh = run.mesh(i);
        if (!mesh) {
            return mesh.error();
        }
        const ManifestBody& body = manifest.bodies[i];
        context.bodies.push_back(
            {body.name, fs::path(body.file).filename().string(), std::move(mesh.value())});
    }
    return context;
}

} // namespace cd
