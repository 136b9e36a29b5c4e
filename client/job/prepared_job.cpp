#include "client/job/prepared_job.hpp"

#include "client/base/interrupt.hpp"
#include "client/base/slow_note.hpp"
#include "client/base/units.hpp"
#include "client/import/mesh_import.hpp"
#include "client/job/clearance_warning.hpp"
#include "client/job/job_path.hpp"
#include "client/poses/pose_file.hpp"
#include "client/scene/prepared_scene.hpp"
#include "client/scene/scene_check.hpp"
#include "client/spec/query_spec.hpp"
#include "client/trees/body_trees.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/words.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/topology.hpp"
#include "common/job/poses/made_poses.hpp"

#include <filesystem>
#include <utility>

namespace cd {

namespace {

std::string name_of(const BodySpec& body) {
    return body.name.empty() ? body.path.filename().string() : body.name;
}

/// Returns a declared unit's name, or its length in metres; empty if the file declares none.
std::string declared_unit(const DeclaredFrame& declared) {
    for (const std::string_view name : unit_names()) {
        if (unit_factor_of_metres(declared.metres, name) == 1.0) {
            return std::string(name);
        }
    }
    return declared.metres > 0 ? exact_text(declared.metres) + " m" : "";
}

/// How each body's mesh file was interpreted, for messages.
using BodyNotes = std::array<std::vector<std::string>, 2>;

/// Imports the meshes of two bodies, unless the job has them. The lines of [shots] are body B.
Result<BodyNotes> import_bodies(PreparedJob& job, bool quiet) {
    BodyNotes notes;
    for (const BodySpec& body : job.spec.bodies) {
        job.names.push_back(name_of(body));
    }
    for (std::size_t i = job.meshes.size(); i < 2; ++i) {
        const BodySpec& body = job.spec.bodies[i];
        const BodySpec& first = job.spec.bodies[0];
        if (const auto* shots = std::get_if<ShotsSpec>(&job.spec.poses); i == 1 && shots) {
            job.meshes.push_back(CD_TRY(lines_of(*shots, *job.meshes[0])));
            continue;
        }
        if (i == 1 && body.path == first.path && body.unit == first.unit && body.up == first.up &&
            body.rounds_to_float == first.rounds_to_float && body.origin == first.origin) {
            job.meshes.push_back(job.meshes[0]);
            notes[1] = notes[0];
            job.spec.bodies[1].declared_unit = first.declared_unit;
            continue;
        }
        const auto options = CD_TRY(import_options(job.spec, i));
        const SlowNote note("reading " + body.path.filename().string() + "...", quiet);
        auto imported = CD_TRY(import_mesh(body.path, options));
        notes[i] = import_notes(imported, body.unit, options.is_y_up);
        job.spec.bodies[i].declared_unit =
            body.unit.empty() ? declared_unit(imported.declared) : "";
        for (const std::string& warning : imported.warnings) {
            job.warnings.push_back("warning: " + warning);
        }
        job.meshes.push_back(std::move(imported.mesh));
    }
    return notes;
}

TreeUse tree_use(const PreparedJob& job, Trees trees) {
    TreeUse use;
    if (trees == Trees::Always) {
        const auto* const random = std::get_if<RandomPoses>(&job.spec.poses);
        const std::uint64_t scenarios = job.poses ? job.poses->count() : random->count;
        use.makes_points = scenarios >= limits::run_points_scenarios_min;
        use.settles = true;
    }
    return use;
}

void get_trees(PreparedJob& job, Trees trees, TreeCache& cache, ThreadPool& pool) {
    job.trees = make_body_trees(job.meshes, tree_use(job, trees), cache, pool);
    for (std::string& warning : cache.take_warnings()) {
        job.warnings.push_back(std::move(warning));
    }
}

/// Names the columns that count as 0: "; y, z, roll, pitch are 0"; empty if there are none.
std::string zeros_text(const std::vector<std::string>& zeros) {
    std::string text;
    for (const std::string& name : zeros) {
        text += (text.empty() ? "; " : ", ") + name;
    }
    return text.empty() ? text : text + (zeros.size() == 1 ? " is 0" : " are 0");
}

/// Says where the poses come from, for the header of a run.
std::string poses_text(const PosesSpec& spec, const std::vector<std::string>& zeros) {
    if (const auto* file = std::get_if<PoseFileSpec>(&spec)) {
        return (file->path == "-" ? "from standard input" : file->path.filename().string()) +
               zeros_text(zeros);
    }
    if (const auto* random = std::get_if<RandomPoses>(&spec)) {
        return "random, seed " + std::to_string(random->seed) + ", penetration " +
               exact_text(random->penetration_min) + " to " + exact_text(random->penetration_max);
    }
    if (const auto* shots = std::get_if<ShotsSpec>(&spec)) {
        return views_text(*shots);
    }
    if (const auto* curve = std::get_if<CurveSpec>(&spec)) {
        return "keys along the curve \"" + curve->text.substr(0, curve->text.find(' ')) + "\"";
    }
    const Grid& grid = std::get<GridSpec>(spec).grid;
    constexpr std::array<const char*, 3> positions{"x", "y", "z"};
    constexpr std::array<const char*, 3> angles{"roll", "pitch", "yaw"};
    std::string text = "grid";
    const auto add = [&](const char* name, std::uint64_t count) {
        if (count > 1) {
            text += std::string(text == "grid" ? " " : ", ") + name + " " + grouped(count);
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        add(positions[i], grid.position[i].count);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        add(angles[i], grid.rotation[i].size());
    }
    return text;
}

/// Makes the poses of a bundle of lines.
Status make_shots(PreparedJob& job, const ShotsSpec& spec) {
    const Aabb box = bounding_box(job.meshes[0]->vertices());
    const std::vector<BundlePose> poses = CD_TRY(shot_poses(spec, box));
    std::vector<Scenario> scenarios(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses.b = poses[i].pose;
    }
    job.poses = make_list_source(std::move(scenarios));
    job.labels = shot_labels(spec, poses);
    return Done{};
}

Status make_poses(PreparedJob& job, ThreadPool& pool, bool quiet) {
    if (const auto* spec = std::get_if<GridSpec>(&job.spec.poses)) {
        job.grid = spec->grid;
        job.poses = make_grid_source(spec->grid);
        return Done{};
    }
    if (const auto* random = std::get_if<RandomPoses>(&job.spec.poses)) {
        job.poses = make_computed_source(random->count,
                                         random_scenarios(*random, *job.trees[0], *job.trees[1]),
                                         pool.size(),
                                         &InterruptGuard::has_come);
        return Done{};
    }
    if (const auto* shots = std::get_if<ShotsSpec>(&job.spec.poses)) {
        return make_shots(job, *shots);
    }
    if (const auto* curve = std::get_if<CurveSpec>(&job.spec.poses)) {
        return make_keys(job, *curve);
    }
    const auto& spec = std::get<PoseFileSpec>(job.spec.poses);
    const SlowNote note(spec.path == "-" ? std::string("reading poses from standard input...")
                                         : "reading " + spec.path.filename().string() + "...",
                        quiet);
    auto file = CD_TRY(open_pose_file(spec));
    job.poses = std::move(file.source);
    job.zeros = std::move(file.zeros);
    job.labels = std::move(file.labels);
    for (const std::string& warning : file.warnings) {
        job.warnings.push_back("warning: " + warning);
    }
    return make_row_keys(job, file.rates);
}

void describe(PreparedJob& job, const BodyNotes& notes) {
    std::array<BodyLine, 2> lines;
    for (std::size_t i = 0; i < 2; ++i) {
        lines[i] = describe_body(job.names[i], job.spec.unit, *job.meshes[i]);
        lines[i].notes = notes[i];
        if (i == 1 && job.meshes[1] == job.meshes[0]) {
            lines[1].closed = lines[0].closed;
        } else {
            lines[i].closed = job.trees.empty() ? analyse_topology(*job.meshes[i]).is_closed()
                                                : job.trees[i]->topology().is_closed();
        }
    }
    const bool are_shots = job.query.question == Question::Shots;
    if (auto warning = unit_warning(lines[0], lines[1]); warning && !are_shots) {
        job.warnings.push_back(*warning);
    }
    job.header =
        header_text(lines[0], lines[1], job.poses->count(), poses_text(job.spec.poses, job.zeros));
}

/// Warns if a job asks for shared points and for no file that has them.
void check_points(PreparedJob& job) {
    const OutputSpec& output = job.spec.output;
    if (job.query.level == Level::Contacts && !output.dir.empty() &&
        output.formats == std::vector<std::string>{"csv"}) {
        job.warnings.emplace_back("note: csv has scenarios and groups; for pairs and shared points "
                                  "add csv-pairs or npz to the formats");
    }
}

/// Prepares a job with [bodies].
Result<PreparedJob>
prepare_bodies(PreparedJob job, Trees trees, TreeCache& cache, ThreadPool& pool, bool quiet) {
    auto scene = CD_TRY(prepare_scene(job.spec, quiet, &InterruptGuard::has_come));
    for (const NamedBody& body : scene.scene.bodies) {
        job.names.push_back(body.name);
        job.meshes.push_back(scene.scene.meshes[body.mesh]);
    }
    for (const std::string& warning : scene.warnings) {
        job.warnings.push_back("warning: " + warning);
    }
    for (const std::string& note : scene.facts.notes) {
        job.warnings.push_back("note: " + note);
    }
    if (const auto moved = scene.facts.moved) {
        job.warnings.push_back("note: " + keys_text(*moved, job.spec.unit));
    }
    job.query = scene.query;
    job.query.ignored = scene.ignored;
    job.zeros = scene.facts.zeros;
    job.header = check_text(job.spec, scene);
    std::vector<BodySpec> files;
    for (const NamedBody& body : scene.scene.bodies) {
        files.push_back(job.spec.scene->bodies[body.entry].mesh);
    }
    if (scene.lines) {
        BodySpec lines;
        lines.path = scene.lines->spec.file;
        files.push_back(std::move(lines));
        job.names.emplace_back(lines_name);
        job.meshes.push_back(scene.lines->mesh);
        job.spec.scene->shots = scene.lines->spec;
    }
    job.scene = JobScene{std::move(files), scene.are_fixed, scene.steps, scene.head};
    job.poses = std::move(scene.poses);
    if (trees == Trees::Always) {
        const SlowNote note(
            "building trees of " + counted(scene.scene.bodies.size(), "instance") + "...", quiet);
        get_trees(job, trees, cache, pool);
    }
    check_points(job);
    if (auto warning = clearance_warning(job)) {
        job.warnings.push_back(std::move(*warning));
    }
    return job;
}

/// Prepares a job with [bodies] whose inputs are in memory.
PreparedJob
take_bodies(PreparedJob job, Trees trees, TreeCache& cache, ThreadPool& pool, JobInputs given) {
    job.names = std::move(given.names);
    job.meshes = std::move(given.meshes);
    job.query = covering(job.spec.query, job.spec.chord);
    job.query.ignored = std::move(given.ignored).value_or(std::vector<IgnoredRange>());
    job.scene = std::move(given.scene);
    job.poses = std::move(given.poses);
    job.header = counted(job.names.size(), "instance") + ", " +
                 counted(job.scene->steps->steps(), "step") + ", " +
                 counted(job.poses->count(), "scenario") + "\n";
    if (trees == Trees::Always) {
        get_trees(job, trees, cache, pool);
    }
    check_points(job);
    return job;
}

} // namespace

Result<PreparedJob> prepare_job(
    JobSpec spec, Trees trees, TreeCache& cache, ThreadPool& pool, bool quiet, JobInputs given) {
    PreparedJob job;
    job.spec = std::move(spec);
    if (job.spec.scene) {
        return given.scene ? take_bodies(std::move(job), trees, cache, pool, std::move(given))
                           : prepare_bodies(std::move(job), trees, cache, pool, quiet);
    }
    job.meshes = std::move(given.meshes);
    const auto notes = CD_TRY(import_bodies(job, quiet));
    auto ignored =
        CD_TRY(given.ignored ? Result(std::move(*given.ignored))
                             : resolve_ignored(job.spec, *job.meshes[0], *job.meshes[1]));
    job.query = covering(job.spec.query, job.spec.chord);
    job.query.ignored = std::move(ignored);
    // Only random poses need trees.
    const bool makes_poses = !given.poses && std::holds_alternative<RandomPoses>(job.spec.poses);
    if (given.poses) {
        job.grid = given.poses->grid() ? std::optional(*given.poses->grid()) : std::nullopt;
        job.poses = std::move(given.poses);
        job.labels = std::move(given.labels);
    } else if (!makes_poses) {
        CD_TRY(make_poses(job, pool, quiet));
        CD_TRY(make_path(job));
    }
    if (trees == Trees::Always || makes_poses) {
        const SlowNote note("building trees of " + job.names[0] + " and " + job.names[1] + "...",
                            quiet);
        get_trees(job, trees, cache, pool);
    }
    if (makes_poses) {
        CD_TRY(make_poses(job, pool, quiet));
    }
    describe(job, notes);
    check_points(job);
    if (auto warning = clearance_warning(job)) {
        job.warnings.push_back(std::move(*warning));
    }
    return job;
}

Result<std::shared_ptr<const Mesh>> lines_of(const ShotsSpec& spec, const Mesh& a) {
    Mesh lines = CD_TRY(shot_mesh(spec, bounding_box(a.vertices())));
    return std::make_shared<const Mesh>(std::move(lines));
}

std::shared_ptr<const ShotViews> views_of(const JobSpec& spec, const Mesh& a) {
    const ShotsSpec* const shots = shots_of(spec);
    return shots == nullptr ? nullptr
                            : std::make_shared<const ShotViews>(
                                  *shots, shots->box.value_or(bounding_box(a.vertices())));
}

Result<ImportOptions> import_options(const JobSpec& spec, std::size_t body) {
    return import_options(spec.bodies[body], spec.unit);
}

const BodySpec& body_spec(const PreparedJob& job, std::size_t body) {
    return job.scene ? job.scene->files[body] : job.spec.bodies[body];
}

std::optional<SceneHead> scene_head(const PreparedJob& job) {
    return job.scene ? std::optional(job.scene->head) : std::nullopt;
}

ResultMerger merger_of(const PreparedJob& job) {
    return ResultMerger(job.poses->count(), scene_head(job));
}

std::string absolute_path(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path whole =
        path == "-" ? path : std::filesystem::absolute(path, error).lexically_normal();
    return (error ? path : whole).string();
}

void make_paths_absolute(JobSpec& spec) {
    for (BodySpec* body : meshes_of(spec)) {
        body->path =
            body->path.empty() ? body->path : std::filesystem::path(absolute_path(body->path));
    }
    if (const ShotsSpec* const shots = shots_of(spec); shots != nullptr && !shots->is_grid()) {
        const std::filesystem::path file = absolute_path(shots->file);
        (spec.scene ? *spec.scene->shots : std::get<ShotsSpec>(spec.poses)).file = file;
    }
    if (auto* file = std::get_if<PoseFileSpec>(&spec.poses);
        file != nullptr && !file->path.empty()) {
        file->path = absolute_path(file->path);
    }
    if (!spec.scene) {
        return;
    }
    for (SceneBodySpec& body : spec.scene->bodies) {
        if (body.poses) {
            body.poses->path = absolute_path(body.poses->path);
        }
    }
    if (spec.scene->poses) {
        spec.scene->poses->file.path = absolute_path(spec.scene->poses->file.path);
    }
    if (spec.scene->fcd) {
        spec.scene->fcd->path = absolute_path(spec.scene->fcd->path);
    }
}

void make_paths_absolute(PreparedJob& job) {
    make_paths_absolute(job.spec);
    if (job.scene) {
        for (BodySpec& file : job.scene->files) {
            file.path =
                file.path.empty() ? file.path : std::filesystem::path(absolute_path(file.path));
        }
    }
}

ExportContext export_context(const PreparedJob& job) {
    ExportContext context;
    context.job = job.spec.name;
    context.unit = job.spec.unit;
    context.describe(job.query);
    context.exact_points = job.spec.output.exact_points;
    context.stop = &InterruptGuard::has_come;
    const std::size_t last = job.meshes.size() - 1;
    for (std::size_t i = 0; i < job.meshes.size(); ++i) {
        const BodySpec& body = body_spec(job, i);
        context.bodies.push_back({job.scene ? job.names[i] : export_name(job.spec, i),
                                  body.path.filename().string(),
                                  job.meshes[i],
                                  body.rounds_to_float,
                                  job.scene && job.scene->are_fixed[i],
                                  i == last ? views_of(job.spec, *job.meshes[0]) : nullptr});
    }
    context.steps = job.scene ? job.scene->steps : nullptr;
    if (job.scene && job.query.question == Question::Shots) {
        context.bodies.back().poses = {std::shared_ptr<PoseSource>(), job.poses.get()};
    }
    if (job.query.motion) {
        context.times = job.scene ? MotionTimes(job.scene->steps)
                                  : MotionTimes(std::make_shared<const PoseLabels>(job.labels));
    }
    return context;
}

std::array<std::string, 2> body_file_names(const PreparedJob& job) {
    const std::vector<ExportBody> bodies = export_context(job).bodies;
    return {body_file_name(bodies, 0), body_file_name(bodies, 1)};
}

} // namespace cd
