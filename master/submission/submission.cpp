#include "master/submission/submission.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/printable.hpp"
#include "common/job/scenario.hpp"
#include "master/dispatch/policy/strategies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace cd {

namespace {

Error bad(const std::string& text) {
    return {ErrorCode::BadInput, text};
}

Status
check_range(const std::string& name, std::uint64_t value, std::uint64_t min, std::uint64_t max) {
    if (value < min || value > max) {
        return bad(name + " is " + std::to_string(value) + " and may be " + std::to_string(min) +
                   " to " + std::to_string(max));
    }
    return Done{};
}

/// Checks the ignored parts of a job whose bodies have so many triangles.
Status check_ignored(const Query& query, std::span<const std::uint64_t> triangles) {
    if (query.ignored.size() > limits::ignored_ranges_max) {
        return Error{ErrorCode::TooLarge,
                     std::to_string(query.ignored.size()) + " pairs of ignored parts; at most " +
                         std::to_string(limits::ignored_ranges_max) + " are taken"};
    }
    for (const IgnoredRange& range : query.ignored) {
        if (!are_bodies_of_job(range.body_a, range.body_b, triangles.size())) {
            return bad("ignored parts of bodies " + std::to_string(range.body_a) + " and " +
                       std::to_string(range.body_b) + "; the job has 0 to " +
                       std::to_string(triangles.size() - 1) + ", and A comes before B");
        }
        if (range.a_begin > range.a_end || range.a_end > triangles[range.body_a] ||
            range.b_begin > range.b_end || range.b_end > triangles[range.body_b]) {
            return bad("a pair of ignored parts is outside the meshes");
        }
    }
    return Done{};
}

Status check_text(const std::string& what, const std::string& text, std::size_t bytes_max) {
    if (text.size() > bytes_max) {
        return bad(what + " is longer than " + std::to_string(bytes_max) + " bytes");
    }
    return is_printable(text) ? Status(Done{}) : Status(bad(what + " is not printable"));
}

constexpr std::size_t grid_axes = 6;
constexpr std::size_t shot_axes = 2;

/// Checks the fields that describe the job to people and do not affect its results.
Status check_origin(const Submit& submit) {
    if (submit.ignore.size() > limits::ignored_ranges_max) {
        return Error{ErrorCode::TooLarge,
                     std::to_string(submit.ignore.size()) + " lines of ignored parts; at most " +
                         std::to_string(limits::ignored_ranges_max) + " are taken"};
    }
    for (const JobBody& body : submit.bodies) {
        if (!std::ranges::all_of(body.origin, [](double x) { return std::isfinite(x); })) {
            return bad("the origin of a body's mesh is not finite");
        }
    }
    const bool are_shots = submit.poses.kind == PosesKind::Shots;
    if (submit.poses.shots.has_value() != are_shots) {
        return bad("a job tells its lines if its poses are of kind shots, and only then");
    }
    if (are_shots && submit.query.question != Question::Shots) {
        return bad("a job with lines asks for their hits, and not for anything else");
    }
    if (submit.query.question == Question::Motion && submit.grid) {
        return bad("motions are between keys, not on a grid");
    }
    const std::size_t axes = are_shots ? shot_axes : grid_axes;
    if (!submit.poses.axes.empty() && submit.poses.axes.size() != axes) {
        return bad(
            std::string(are_shots ? "lines have two axes, not " : "a grid has six axes, not ") +
            std::to_string(submit.poses.axes.size()));
    }
    return Done{};
}

/// Checks what a scene of many bodies tells besides its scenarios.
Status check_scene(const Submit& submit) {
    if (!submit.poses.scene) {
        return Done{};
    }
    if (submit.poses.kind != PosesKind::File) {
        return bad("the poses of a scene come from files");
    }
    const std::uint64_t bytes = submit.poses.scene->job.size() + submit.poses.scene->steps.size();
    if (bytes > limits::scene_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "a scene whose job file and steps take " + std::to_string(bytes) +
                         " bytes; at most " + std::to_string(limits::scene_bytes_max) +
                         " are taken: split its steps among several jobs"};
    }
    return Done{};
}

Status check_texts(const Submit& submit) {
    constexpr std::size_t text_max = limits::hello_text_bytes_max;
    for (const JobBody& body : submit.bodies) {
        for (const Status& status : {check_text("a body's name", body.name, text_max),
                                     check_text("a body's file", body.file, limits::path_bytes_max),
                                     check_text("a body's unit", body.unit, text_max),
                                     check_text("a body's up axis", body.up, text_max)}) {
            if (!status) {
                return status;
            }
        }
    }
    for (const Status& status :
         {check_text("the job's name", submit.name, text_max),
          check_text("the job's unit", submit.unit, text_max),
          check_text("the file of poses", submit.poses.file, limits::path_bytes_max),
          check_text("the order of quaternions", submit.poses.quat_order, text_max),
          check_text("the unit of the poses", submit.poses.unit, text_max)}) {
        if (!status) {
            return status;
        }
    }
    for (const IgnoreLine& line : submit.ignore) {
        for (const std::string* text : {&line.a, &line.b}) {
            if (Status good =
                    check_text("a pattern of ignored parts", *text, limits::path_bytes_max);
                !good) {
                return good;
            }
        }
    }
    return Done{};
}

/// Checks the number of bodies, and what only jobs with two bodies may have.
Status check_bodies(const Submit& submit) {
    const std::size_t bodies = submit.bodies.size();
    if (bodies < 2) {
        return bad("a job has at least two bodies, not " + std::to_string(bodies));
    }
    if (bodies > limits::bodies_max) {
        return Error{ErrorCode::TooLarge,
                     "a job of " + std::to_string(bodies) + " bodies; at most " +
                         std::to_string(limits::bodies_max) + " are taken"};
    }
    if (submit.cluster.depths.size() > bodies) {
        return bad("more distribution depths than bodies");
    }
    if (bodies > 2 && (submit.grid || submit.query.maps)) {
        return bad(submit.grid ? "a grid of poses is of two bodies" : "maps are of two bodies");
    }
    return Done{};
}

/// Returns the number of triangles of each body. Errors: NotFound for a mesh that is not stored;
/// TooLarge for too many meshes.
Result<std::vector<std::uint64_t>> triangles_of_bodies(const Submit& submit,
                                                       std::span<const MeshStatus> stored) {
    std::map<Sha256, std::uint64_t> known;
    for (const MeshStatus& mesh : stored) {
        known.emplace(mesh.mesh, mesh.triangles);
    }
    std::set<Sha256> meshes;
    std::vector<std::uint64_t> triangles;
    for (const JobBody& body : submit.bodies) {
        const auto found = known.find(body.mesh);
        if (found == known.end()) {
            return Error{ErrorCode::NotFound,
                         "mesh " + to_short_hex(body.mesh) +
                             " is not stored here; upload it before the job"};
        }
        triangles.push_back(found->second);
        meshes.insert(body.mesh);
    }
    if (meshes.size() > limits::body_meshes_max) {
        return Error{ErrorCode::TooLarge,
                     "bodies of " + std::to_string(meshes.size()) + " meshes; at most " +
                         std::to_string(limits::body_meshes_max) + " are taken"};
    }
    return triangles;
}

Status check_depths(const Submit& submit) {
    for (std::size_t body = 0; body < submit.cluster.depths.size(); ++body) {
        Status in_range = check_range("the distribution depth of body " + submit.bodies[body].name,
                                      submit.cluster.depth(body).value_or(0),
                                      0,
                                      limits::distribution_depth_max);
        if (!in_range) {
            return in_range;
        }
    }
    return Done{};
}

} // namespace

Status check_priority(std::int32_t priority) {
    if (priority < -limits::priority_max || priority > limits::priority_max) {
        return bad("the priority is " + std::to_string(priority) + " and may be " +
                   std::to_string(-limits::priority_max) + " to " +
                   std::to_string(limits::priority_max));
    }
    return Done{};
}

Status check_submission(const Submit& submit, std::span<const MeshStatus> stored) {
    if (const Status bodies = check_bodies(submit); !bodies) {
        return bodies;
    }
    if (const Status texts = check_texts(submit); !texts) {
        return texts;
    }
    if (const Status origin = check_origin(submit); !origin) {
        return origin;
    }
    if (const Status scene = check_scene(submit); !scene) {
        return scene;
    }
    if (const Status priority = check_priority(submit.priority); !priority) {
        return priority;
    }
    if (submit.grid.has_value() != (submit.poses.kind == PosesKind::Grid)) {
        return bad("a job has a grid if its poses are of kind grid, and only then");
    }
    if (submit.grid && submit.grid->size() > limits::grid_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "a grid of " + std::to_string(submit.grid->size()) + " bytes; at most " +
                         std::to_string(limits::grid_bytes_max) + " are taken"};
    }
    const Result<std::vector<std::uint64_t>> triangles = triangles_of_bodies(submit, stored);
    if (!triangles) {
        return triangles.error();
    }
    const ClusterOptions& cluster = submit.cluster;
    if (submit.scenarios > limits::client_scenarios_max) {
        return Error{ErrorCode::TooLarge,
                     "the number of scenarios is " + std::to_string(submit.scenarios) +
                         "; at most " + std::to_string(limits::client_scenarios_max) +
                         " are taken: split the job into several, one after the other"};
    }
    for (const Status& status : {
             check_depths(submit),
             check_strategy(cluster.strategy),
             check_range("q", cluster.q, 1, limits::q_max),
             check_range("v_kb", cluster.v_kb, 1, limits::v_kb_max),
             check_ignored(submit.query, triangles.value()),
         }) {
        if (!status) {
            return status;
        }
    }
    return Done{};
}

std::vector<Sha256> meshes_of(const Submit& submit) {
    std::vector<Sha256> meshes;
    for (const JobBody& body : submit.bodies) {
        meshes.push_back(body.mesh);
    }
    return meshes;
}

std::uint64_t bulk_bytes(const Submit& submit) {
    std::uint64_t bytes = (submit.grid ? submit.grid->size() : 0) +
                          submit.query.ignored.size() * sizeof(IgnoredRange);
    for (const IgnoreLine& line : submit.ignore) {
        bytes += line.a.size() + line.b.size();
    }
    return bytes + (submit.poses.scene
                        ? submit.poses.scene->job.size() + submit.poses.scene->steps.size()
                        : 0);
}

std::uint64_t bulk_bytes(const PosesPart& part) {
    std::uint64_t bytes =
        part.scenarios.size() + part.labels.integers.size() * sizeof(std::int64_t) +
        (part.labels.times.size() + part.labels.end_times.size()) * sizeof(double);
    for (const std::string& text : part.labels.texts) {
        bytes += text.size();
    }
    return bytes;
}

bool drop_bulk(Submit& submit) {
    bool is_dropped = !std::exchange(submit.query.ignored, {}).empty();
    submit.ignore = {};
    if (submit.grid && submit.grid->size() > limits::ended_grid_bytes_max) {
        submit.grid = Bytes();
        is_dropped = true;
    }
    if (submit.poses.scene) {
        submit.poses.scene->job = {};
        submit.poses.scene->steps = {};
        is_dropped = true;
    }
    return is_dropped;
}

} // namespace cd
