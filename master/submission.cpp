#include "master/submission.hpp"

#include "common/core/limits.hpp"
#include "common/core/limits_clients.hpp"
#include "common/core/printable.hpp"
#include "common/job/tolerance.hpp"

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
        if (range.a_begin > range.a_end || range.a_end > triangles_a ||
            range.b_begin > range.b_end || range.b_end > triangles_b) {
            return bad("a pair of ignored parts is outside the meshes");
        }
    }
    return Done{};
}

} // namespace

Status check_submission(const Submit& submit, std::span<const MeshStatus> stored) {
    if (submit.bodies.size() != 2) {
        return bad("a job has two bodies, not " + std::to_string(submit.bodies.size()));
    }
    if (submit.name.size() > limits::hello_text_bytes_max) {
        return bad("the job's name is longer than " + std::to_string(limits::hello_text_bytes_max) +
                   " bytes");
    }
    if (!is_printable(submit.name)) {
        return bad("the job's name is not printable");
    }
    if (submit.grid && submit.grid->size() > limits::grid_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "a grid of " + std::to_string(submit.grid->size()) + " bytes; at most " +
                         std::to_string(limits::grid_bytes_max) + " are taken"};
    }
    std::array<std::uint64_t, 2> triangles{};
    for (std::size_t body = 0; body < 2; ++body) {
        const auto mesh = std::find_if(stored.begin(), stored.end(), [&](const MeshStatus& status) {
            return status.mesh == submit.bodies[body];
        });
        if (mesh == stored.end()) {
            return Error{ErrorCode::NotFound,
                         "mesh " + to_short_hex(submit.bodies[body]) +
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
             check_range("the distribution depth of A", cluster.depth_a.value_or(0), 0, depth_max),
             check_range("the distribution depth of B", cluster.depth_b.value_or(0), 0, depth_max),
             check_range("q", cluster.q, 1, limits::q_max),
             check_range("v_kb", cluster.v_kb, 1, limits::v_kb_max),
             check_tolerance(submit.query.tolerance),
             check_ignored(submit.query, triangles[0], triangles[1]),
         }) {
        if (!status) {
            return status;
        }
    }
    return Done{};
}

std::uint64_t bulk_bytes(const Submit& submit) {
    return (submit.grid ? submit.grid->size() : 0) +
           submit.query.ignored.size() * sizeof(IgnoredRange);
}

bool drop_bulk(Submit& submit) {
    bool is_dropped = !std::exchange(submit.query.ignored, {}).empty();
    if (submit.grid && submit.grid->size() > limits::ended_grid_bytes_max) {
        submit.grid = Bytes();
        is_dropped = true;
    }
    return is_dropped;
}

} // namespace cd
