#include "master/submission/submission.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/printable.hpp"
#include "master/dispatch/policy/strategies.hpp"

#include <algorithm>
#include <array>

namespace cd {

namespace {

Error bad(const std::string& text) {
    return {ErrorCode::BadInput, text};
}

Status check_range(const char* name, std::uint64_t value, std::uint64_t min, std::uint64_t max) {
    if (value < min || value > max) {
        return bad(std::string(name) + " is " + std::to_string(value) + " and may be " +
                   std::to_string(min) + " to " + std::to_string(max));
    }
    return Done{};
}

Status check_ignored(const Query& query, std::uint64_t triangles_a, std::uint64_t triangles_b) {
    if (query.ignored.size() > limits::ignored_ranges_max) {
        return Error{ErrorCode::TooLarge,
                     std::to_string(query.ignored.size()) + " pairs of ignored parts; at most " +
                         std::to_string(limits::ignored_ranges_max) + " are taken"};
    }
    for (const IgnoredRange& range : query.ignored) {
        if (range.body_a != 0 || range.body_b != 1) {
            return bad("ignored parts of bodies " + std::to_string(range.body_a) + " and " +
                       std::to_string(range.body_b) + "; the job has 0 and 1");
        }
        if (range.a_begin > range.a_end || range.a_end > triangles_a ||
            range.b_begin > range.b_end || range.b_end > triangles_b) {
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
    const bool are_shots = submit.poses.kind == PosesKind::Shots;
    if (submit.poses.shots.has_value() != are_shots) {
        return bad("a job tells its lines if its poses are of kind shots, and only then");
    }
    if (are_shots && submit.query.question != Question::Shots) {
        return bad("a job with lines asks for their hits, and not for anything else");
    }
    const std::size_t axes = are_shots ? shot_axes : grid_axes;
    if (!submit.poses.axes.empty() && submit.poses.axes.size() != axes) {
        return bad(
            std::string(are_shots ? "lines have two axes, not " : "a grid has six axes, not ") +
            std::to_string(submit.poses.axes.size()));
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

} // namespace

Status check_submission(const Submit& submit, std::span<const MeshStatus> stored) {
    if (submit.bodies.size() != 2) {
        return bad("a job has two bodies, not " + std::to_string(submit.bodies.size()));
    }
    if (const Status texts = check_texts(submit); !texts) {
        return texts;
    }
    if (const Status origin = check_origin(submit); !origin) {
        return origin;
    }
    if (submit.priority != 0) {
        return bad("the priority is " + std::to_string(submit.priority) +
                   "; this master takes 0 alone");
    }
    if (submit.grid.has_value() != (submit.poses.kind == PosesKind::Grid)) {
        return bad("a job has a grid if its poses are of kind grid, and only then");
    }
    if (submit.grid && submit.grid->size() > limits::grid_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "a grid of " + std::to_string(submit.grid->size()) + " bytes; at most " +
                         std::to_string(limits::grid_bytes_max) + " are taken"};
    }
    std::array<std::uint64_t, 2> triangles{};
    for (std::size_t body = 0; body < 2; ++body) {
        const auto mesh = std::find_if(stored.begin(), stored.end(), [&](const MeshStatus& status) {
            return status.mesh == submit.bodies[body].mesh;
        });
        if (mesh == stored.end()) {
            return Error{ErrorCode::NotFound,
                         "mesh " + to_short_hex(submit.bodies[body].mesh) +
                             " is not stored here; upload it before the job"};
        }
        triangles[body] = mesh->triangles;
    }
    const ClusterOptions& cluster = submit.cluster;
    const auto depth_max = limits::distribution_depth_max;
    if (submit.scenarios > limits::client_scenarios_max) {
        return Error{ErrorCode::TooLarge,
                     "the number of scenarios is " + std::to_string(submit.scenarios) +
                         "; at most " + std::to_string(limits::client_scenarios_max) +
                         " are taken: split the job into several, one after the other"};
    }
    for (const Status& status : {
             check_range("the distribution depth of A", cluster.depth(0).value_or(0), 0, depth_max),
             check_range("the distribution depth of B", cluster.depth(1).value_or(0), 0, depth_max),
             check_strategy(cluster.strategy),
             check_range("q", cluster.q, 1, limits::q_max),
             check_range("v_kb", cluster.v_kb, 1, limits::v_kb_max),
             check_ignored(submit.query, triangles[0], triangles[1]),
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
    return bytes;
}

std::uint64_t bulk_bytes(const PosesPart& part) {
    std::uint64_t bytes = part.scenarios.size() +
                          part.labels.integers.size() * sizeof(std::int64_t) +
                          part.labels.times.size() * sizeof(double);
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
    return is_dropped;
}

} // namespace cd
