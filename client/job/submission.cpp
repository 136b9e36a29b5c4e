#include "client/job/submission.hpp"

#include "client/base/units.hpp"
#include "client/job/job_text.hpp"
#include "common/core/errors.hpp"
#include "common/core/printable.hpp"

#include <cmath>
#include <utility>

namespace cd {

namespace {

void set_origin(const ShotsSpec& spec, PosesOrigin& origin) {
    ShotsOrigin shots;
    if (spec.is_grid()) {
        shots.spacing = spec.grid.spacing;
        shots.tile = spec.grid.tile;
        shots.offset = spec.grid.offset;
        shots.jitter_seed = spec.grid.jitter_seed;
        origin.axes = {spec.azimuth_deg, spec.elevation_deg};
    } else {
        origin.file = escaped(spec.file.string());
        shots.are_rays = spec.form == LineForm::Rays;
    }
    origin.shots = shots;
}

void set_origin(const JobSpec& spec, PosesOrigin& origin) {
    if (spec.max_step || spec.chord) {
        origin.path = PathOrigin{spec.max_step, spec.chord, spec.query.clearance};
    }
}

PosesOrigin origin_of(const PosesSpec& spec) {
    PosesOrigin origin;
    if (const auto* grid = std::get_if<GridSpec>(&spec)) {
        origin.kind = PosesKind::Grid;
        origin.unit = grid->unit;
        origin.axes = grid->axes;
    } else if (const auto* random = std::get_if<RandomPoses>(&spec)) {
        origin.kind = PosesKind::Random;
        origin.random = *random;
    } else if (const auto* shots = std::get_if<ShotsSpec>(&spec)) {
        origin.kind = PosesKind::Shots;
        set_origin(*shots, origin);
    } else if (const auto* curve = std::get_if<CurveSpec>(&spec)) {
        origin.kind = PosesKind::Curve;
        origin.file = curve->text;
        origin.unit = curve->unit;
    } else {
        const auto& file = std::get<PoseFileSpec>(spec);
        origin.file = escaped(file.path.string());
        origin.quat_order = file.quat_order;
        origin.of_both_bodies = file.of_both_bodies;
        origin.rigid_tolerance = file.rigid_tolerance;
        origin.unit = file.unit;
    }
    return origin;
}

} // namespace

BodySpec spec_of(const JobBody& body, std::size_t number) {
    BodySpec spec;
    spec.path = body.file;
    // Only the two bodies of [a] and [b] have names by default.
    const JobSpec unnamed;
    const bool is_default =
        number < unnamed.bodies.size() && body.name == export_name(unnamed, number);
    spec.name = is_default ? "" : body.name;
    (body.is_unit_given ? spec.unit : spec.declared_unit) = body.unit;
    spec.up = body.up;
    spec.rounds_to_float = body.rounds_to_float;
    spec.origin = body.origin;
    return spec;
}

namespace {

Result<PosesSpec> shots_of(const PosesOrigin& origin) {
    const bool is_grid = origin.file.empty();
    if (!origin.shots || (is_grid && origin.axes.size() != 2)) {
        return Error{ErrorCode::BadFrame, "the job has lines without their directions"};
    }
    const ShotsOrigin& shots = *origin.shots;
    ShotsSpec spec;
    spec.file = origin.file;
    spec.form = shots.are_rays ? LineForm::Rays : LineForm::Ends;
    if (is_grid) {
        spec.grid = {shots.spacing, shots.tile, shots.offset, shots.jitter_seed};
        spec.azimuth_deg = origin.axes[0];
        spec.elevation_deg = origin.axes[1];
        CD_TRY(check_grid(spec.grid));
    }
    return PosesSpec(std::move(spec));
}

Result<PosesSpec> poses_of(const Submit& submit) {
    const PosesOrigin& origin = submit.poses;
    if (submit.grid) {
        auto grid = decode_grid(*submit.grid);
        return grid ? Result<PosesSpec>(GridSpec{std::move(grid.value()), origin.axes, origin.unit})
                    : grid.error();
    }
    if (origin.random) {
        return PosesSpec(*origin.random);
    }
    if (origin.kind == PosesKind::Shots) {
        return shots_of(origin);
    }
    if (origin.kind == PosesKind::Curve) {
        auto curve = CD_TRY(parse_curve(origin.file, origin.unit, submit.unit));
        return PosesSpec(std::move(curve));
    }
    PoseFileSpec file{
        origin.file, origin.quat_order, origin.of_both_bodies, origin.rigid_tolerance};
    file.unit = origin.unit;
    file.length_factor =
        unit_factor(origin.unit.empty() ? submit.unit : origin.unit, submit.unit).value_or(1);
    return PosesSpec(std::move(file));
}

bool is_length(const std::optional<double>& length) {
    return !length || (*length > 0 && std::isfinite(*length));
}

/// Sets what a job says of the path between its poses.
Status set_path(const PathOrigin& path, JobSpec& spec) {
    if (!is_length(path.max_step) || !is_length(path.chord)) {
        return Error{ErrorCode::BadFrame, "the job has a path with a length that is not above 0"};
    }
    spec.max_step = path.max_step;
    spec.chord = path.chord;
    spec.query.clearance = path.clearance;
    return Done{};
}

} // namespace

JobBody body_of(const PreparedJob& job, std::size_t body) {
    const BodySpec& given = body_spec(job, body);
    JobBody told;
    told.mesh = job.meshes[body]->hash();
    told.name = job.scene ? job.names[body] : export_name(job.spec, body);
    told.file = given.path.string();
    told.is_unit_given = !given.unit.empty();
    told.unit = told.is_unit_given            ? given.unit
                : given.declared_unit.empty() ? job.spec.unit
                                              : given.declared_unit;
    told.up = given.up;
    told.rounds_to_float = given.rounds_to_float;
    told.origin = given.origin;
    told.is_fixed = job.scene && job.scene->are_fixed[body];
    return told;
}

Submit submission_of(const PreparedJob& job) {
    Submit submit;
    submit.name = escaped(job.spec.name);
    submit.unit = job.spec.unit;
    for (std::size_t body = 0; body < job.meshes.size(); ++body) {
        submit.bodies.push_back(body_of(job, body));
        submit.bodies.back().name = escaped(submit.bodies.back().name);
        submit.bodies.back().file = escaped(submit.bodies.back().file);
    }
    submit.query = job.query;
    submit.cluster = job.spec.cluster;
    submit.poses = origin_of(job.spec.poses);
    set_origin(job.spec, submit.poses);
    submit.scenarios = job.poses->count();
    if (job.grid) {
        submit.grid = encode_grid(*job.grid);
    }
    for (const IgnoreRule& rule : job.spec.ignore) {
        submit.ignore.push_back({escaped(rule.a), escaped(rule.b)});
    }
    if (job.scene) {
        submit.poses.scene =
            SceneOrigin{job.scene->head.hash, job_text(job.spec), pack_steps(*job.scene->steps)};
    }
    return submit;
}

Result<JobScene> scene_of(std::span<const JobBody> bodies,
                          std::span<const std::byte> steps,
                          std::uint64_t scenarios,
                          const Sha256& head) {
    JobScene scene;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        scene.files.push_back(spec_of(bodies[i], i));
        scene.are_fixed.push_back(bodies[i].is_fixed);
    }
    scene.steps = CD_TRY(unpack_steps(steps, scenarios));
    scene.head = {head};
    return scene;
}

Result<JobSpec> spec_of(const Submit& submit) {
    if (submit.poses.scene) {
        auto scene = CD_TRY(parse_job(submit.poses.scene->job, "the job's description"));
        scene.output = {};
        return scene;
    }
    JobSpec spec;
    if (submit.bodies.size() != spec.bodies.size()) {
        return Error{ErrorCode::BadFrame, "the job has other than two bodies"};
    }
    spec.name = submit.name;
    spec.unit = submit.unit;
    for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
        spec.bodies[i] = spec_of(submit.bodies[i], i);
    }
    auto poses = CD_TRY(poses_of(submit));
    spec.poses = std::move(poses);
    spec.query = submit.query;
    spec.query.ignored.clear();
    if (submit.poses.path) {
        CD_TRY(set_path(*submit.poses.path, spec));
    }
    for (const IgnoreLine& line : submit.ignore) {
        spec.ignore.push_back({line.a, line.b});
    }
    spec.cluster = submit.cluster;
    return spec;
}

} // namespace cd
