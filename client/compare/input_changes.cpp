#include "client/compare/input_changes.hpp"

#include "client/spec/job_file.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace cd {

namespace {

/// Returns how many of `names` are not in `others`, both as multisets.
std::uint64_t count_missing(std::vector<std::string> names, std::vector<std::string> others) {
    std::ranges::sort(names);
    std::ranges::sort(others);
    std::vector<std::string> missing;
    std::ranges::set_difference(names, others, std::back_inserter(missing));
    return missing.size();
}

BodyChange
change_between(std::string name, const ComparedBody& earlier, const ComparedBody& later) {
    return {std::move(name),
            earlier.mesh != later.mesh,
            later.parts.size(),
            count_missing(later.parts, earlier.parts),
            count_missing(earlier.parts, later.parts)};
}

ComparedBody compared(const ManifestBody& body) {
    return {body.mesh, body.parts};
}

ComparedBody compared(const Mesh& mesh) {
    ComparedBody body{mesh.hash(), {}};
    for (const Part& part : mesh.parts()) {
        body.parts.push_back(part.name);
    }
    return body;
}

/// Says what is asked of motions: "until contact with resolution 0.01".
std::string motion_text(const std::optional<MotionQuery>& motion) {
    return motion ? "until " + std::string(to_text(motion->until)) + " with resolution " +
                        exact_text(motion->resolution)
                  : "none";
}

std::vector<std::string> query_changes(const Query& earlier, const Query& later, QueryUse use) {
    std::vector<std::string> changes;
    const auto add = [&](const char* name, const std::string& was, const std::string& is) {
        if (was != is) {
            changes.push_back(std::string(name) + " " + is + ", was " + was);
        }
    };
    add("level", std::string(asked_level(earlier)), std::string(asked_level(later)));
    const auto length_text = [](const std::optional<double>& length) {
        return length ? exact_text(*length) : "none";
    };
    add("clearance", length_text(earlier.clearance), length_text(later.clearance));
    add("up_to", length_text(earlier.up_to), length_text(later.up_to));
    add("first", earlier.first_hits ? "true" : "false", later.first_hits ? "true" : "false");
    add("motion", motion_text(earlier.motion), motion_text(later.motion));
    add("limit_pairs", std::to_string(earlier.limit_pairs), std::to_string(later.limit_pairs));
    if (earlier.ignored != later.ignored) {
        changes.emplace_back("other triangles ignored");
    }
    if (use == QueryUse::Diff) {
        add("maps", earlier.maps ? "true" : "false", later.maps ? "true" : "false");
    }
    return changes;
}

/// Returns "A" or "B", or in a scene the body's name.
std::string name_of(bool is_scene, std::size_t body, const std::string& name) {
    return is_scene ? name : std::string{static_cast<char>('A' + body)};
}

/// Returns "B changed (7 parts, 2 new, 1 gone)" for each changed body; empty if none has changed.
std::string bodies_text(const std::vector<BodyChange>& bodies) {
    std::string text;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const BodyChange& body = bodies[i];
        if (!body.is_changed) {
            continue;
        }
        text += (text.empty() ? "" : ", ") + body.name + " changed (" + counted(body.parts, "part");
        text += body.parts_new == 0 ? "" : ", " + grouped(body.parts_new) + " new";
        text += body.parts_gone == 0 ? "" : ", " + grouped(body.parts_gone) + " gone";
        text += ")";
    }
    return text;
}

/// Returns "query changed (level pairs, was count; ...)".
std::string query_text(const std::vector<std::string>& changes) {
    std::string text;
    for (const std::string& change : changes) {
        text += (text.empty() ? "" : "; ") + change;
    }
    return "query changed (" + text + ")";
}

} // namespace

InputChanges changes_between(const RunManifest& earlier, const RunManifest& later) {
    InputChanges changes;
    for (std::size_t i = 0; i < later.bodies.size(); ++i) {
        changes.bodies.push_back(
            change_between(name_of(later.scene.has_value(), i, later.bodies[i].name),
                           compared(earlier.bodies[i]),
                           compared(later.bodies[i])));
    }
    changes.are_poses_equal = earlier.poses.count == later.poses.count && earlier.poses.hash &&
                              earlier.poses.hash == later.poses.hash;
    changes.query = query_changes(earlier.query, later.query, QueryUse::Diff);
    if (earlier.outcome.tolerance != later.outcome.tolerance) {
        changes.query.push_back("tolerance " + exact_text(later.outcome.tolerance) + ", was " +
                                exact_text(earlier.outcome.tolerance));
    }
    return changes;
}

namespace {

/// Checks that the lines of two scenes stand alike: their results are compared by the numbers of
/// bundles. Errors: BadInput.
Status check_lines(const RunManifest& earlier, const RunManifest& later) {
    if (!later.scene || later.query.question != Question::Shots ||
        earlier.query.question != Question::Shots) {
        return Done{};
    }
    const auto was = CD_TRY(parse_job(earlier.job, "run.json"));
    const auto is = CD_TRY(parse_job(later.job, "run.json"));
    const ShotsSpec* const before = shots_of(was);
    const ShotsSpec* const after = shots_of(is);
    if (before != nullptr && after != nullptr && !stand_alike(*before, *after)) {
        return bad_input("the runs cannot be compared: their lines stand at other places; give "
                         "both jobs the same directions, spacing, tile and box in [shots]");
    }
    return Done{};
}

} // namespace

Status check_comparable(const RunManifest& earlier, const RunManifest& later) {
    if (earlier.bodies.size() != later.bodies.size() ||
        earlier.scene.has_value() != later.scene.has_value()) {
        return bad_input("the runs cannot be compared: one has " +
                         std::to_string(earlier.bodies.size()) + " bodies, the other " +
                         std::to_string(later.bodies.size()));
    }
    for (std::size_t i = 0; later.scene && i < later.bodies.size(); ++i) {
        if (earlier.bodies[i].name != later.bodies[i].name) {
            return bad_input("the runs cannot be compared: body " + std::to_string(i) + " was " +
                             earlier.bodies[i].name + " and is " + later.bodies[i].name);
        }
    }
    return check_lines(earlier, later);
}

std::string changes_text(const InputChanges& changes) {
    const std::string bodies = bodies_text(changes.bodies);
    return (bodies.empty() ? "bodies equal" : bodies) + ", poses " +
           (changes.are_poses_equal ? "equal" : "changed") + ", " +
           (changes.query.empty() ? "query equal" : query_text(changes.query));
}

Status check_reusable(const RunManifest& earlier, const PreparedJob& job) {
    CD_TRY(check_exact(earlier));
    if (earlier.bodies.size() != job.meshes.size() ||
        earlier.scene.has_value() != job.scene.has_value()) {
        return bad_input("nothing can be reused: " + counted(job.meshes.size(), "instance") +
                         ", was " + counted(earlier.bodies.size(), "instance"));
    }
    std::vector<BodyChange> bodies;
    for (std::size_t i = 0; i < job.meshes.size(); ++i) {
        bodies.push_back(change_between(name_of(job.scene.has_value(), i, job.names[i]),
                                        compared(earlier.bodies[i]),
                                        compared(*job.meshes[i])));
    }
    const auto query = query_changes(earlier.query, job.query, QueryUse::Reuse);
    std::string text = bodies_text(bodies);
    if (!query.empty()) {
        text += (text.empty() ? "" : ", ") + query_text(query);
    }
    return text.empty() ? Status(Done{}) : bad_input("nothing can be reused: " + text);
}

} // namespace cd
