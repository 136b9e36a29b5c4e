#include "web/server/page_json.hpp"

#include "common/core/timing/web.hpp"
#include "web/server/motion_json.hpp"
#include "web/status/cluster_report.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace cd {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 6> grid_axes{"x", "y", "z", "roll", "pitch", "yaw"};
constexpr std::array<const char*, 2> shot_axes{"azimuth", "elevation"};

std::string compact(const Json& json) {
    return json_text(json, -1);
}

std::string_view kind_text(PageOrigin::Kind kind) {
    constexpr std::array<std::string_view, 3> names{"master", "folder", "remote"};
    return names[static_cast<std::size_t>(kind)];
}

std::string_view kind_text(PosesKind kind) {
    constexpr std::array<std::string_view, 5> names{"grid", "file", "random", "shots", "curve"};
    return names[static_cast<std::size_t>(kind)];
}

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

/// Returns a job's row with the keys of `jobs_table`.
Json row_json(const JobRow& job) {
    ClusterStatus alone;
    alone.jobs.push_back(job.status);
    Json row = table_json(jobs_table(alone)).front();
    if (!job.id.empty()) {
        row["job"] = job.id;
    }
    if (!job.state.empty()) {
        row["state"] = job.state;
    }
    return row;
}

Json classes_json(const Summary& summary) {
    return {{"done", summary.merged()},
            {"separate", summary.separate},
            {"touch", summary.touch},
            {"cross", summary.cross},
            {"inside", summary.inside},
            {"contact", summary.contact},
            {"undecided", summary.undecided},
            {"failed", summary.failed},
            {"near", summary.near},
            {"near_pairs", summary.near_pairs},
            {"surfaces_only", summary.surfaces_only},
            {"insides_skipped", summary.insides_skipped},
            {"cut", summary.cut}};
}

/// Returns what changes of a job while it runs.
Json progress_of(const JobRow& job) {
    const JobStatus& status = job.status;
    Json json = row_json(job);
    json.update(classes_json(status.summary));
    json["digest"] = status.digest ? Json(to_hex(*status.digest)) : Json();
    json["paused"] = status.paused;
    return json;
}

Json query_json(const Query& query) {
    return {{"level", to_text(query.level)},
            {"limit_pairs", query.limit_pairs},
            {"ignored", query.ignored.size()},
            {"clearance", or_null(query.clearance)}};
}

Json body_json(const BodyView& body) {
    return {{"name", body.body.name},
            {"file", body.body.file},
            {"unit", body.body.unit},
            {"sha256", to_hex(body.body.mesh)},
            {"triangles", body.triangles},
            {"parts", body.parts},
            {"closed", or_null(body.is_closed)},
            {"bytes", body.bytes},
            {"precision", body.precision == Precision::Float ? "float" : "double"},
            {"size", {body.size.x(), body.size.y(), body.size.z()}},
            {"low", {body.low.x(), body.low.y(), body.low.z()}},
            {"fixed", body.body.is_fixed}};
}

Json axes_json(const PosesView& poses) {
    const std::span<const char* const> names =
        poses.kind == PosesKind::Shots ? std::span<const char* const>(shot_axes) : grid_axes;
    Json axes = Json::array();
    for (std::size_t i = 0; i < poses.axes.size() && i < names.size(); ++i) {
        const GridAxis& axis = poses.axes[i];
        axes.push_back({{"name", names[i]},
                        {"first", axis.first},
                        {"last", axis.last},
                        {"count", axis.count}});
    }
    return axes;
}

Json poses_json(const PosesView& poses) {
    Json json{{"kind", kind_text(poses.kind)},
              {"count", poses.count},
              {"file", poses.file},
              {"axes", axes_json(poses)},
              {"penetration", Json()},
              {"seed", Json()},
              {"has_ids", poses.has_ids},
              {"has_times", poses.has_times},
              {"of_both_bodies", poses.of_both_bodies}};
    if (poses.random) {
        json["penetration"] = {poses.random->penetration_min, poses.random->penetration_max};
        json["seed"] = std::to_string(poses.random->seed); // May exceed 2^53.
    }
    return json;
}

Json run_json(const RunView& run) {
    return {{"where", run.where},
            {"simd", run.simd},
            {"command", run.command},
            {"program", run.program},
            {"commit", run.commit},
            {"started", run.started},
            {"ended", run.ended},
            {"formats", run.formats},
            {"folder", run.folder}};
}

Json group_json(const GroupView& group) {
    return {{"a", group.part_a},
            {"b", group.part_b},
            {"scenarios", group.scenarios},
            {"share", group.share},
            {"pairs", group.pairs},
            {"worst", group.worst},
            {"worst_pairs", group.worst_pairs},
            {"class", to_text(group.worst_class)},
            {"near", group.near},
            {"worst_near", group.worst_near}};
}

/// Adds what only jobs that ask another question than contacts have.
void add_question(Json& json, const Query& query) {
    if (query.question == Question::Distance) {
        json["question"] = "distance";
        json["up_to"] = or_null(query.up_to);
    } else if (query.question == Question::Shots) {
        json["question"] = "shots";
        json["first_hits"] = query.first_hits;
    } else if (query.motion) {
        json["question"] = "motion";
        json["resolution"] = query.motion->resolution;
        json["until"] = until_text(query.motion->until);
    }
}

/// Adds the distance and the nearest triangles of A and B, if the record answers for them.
void add_distance(Json& json, const ScenarioView& scenario) {
    if (!scenario.result || scenario.result->question != Question::Distance) {
        return;
    }
    const std::optional<NearestWitness>& nearest = scenario.result->nearest;
    json["distance"] = nearest ? Json(nearest->distance) : Json();
    json["witness"] = nearest ? Json{nearest->a, nearest->b} : Json();
}

/// Adds what is proven of a motion, if the record is of one.
void add_motion(Json& json, const ScenarioView& scenario) {
    if (!scenario.result || !scenario.result->motion || !scenario.keys) {
        return;
    }
    const auto& [from, to] = *scenario.keys;
    const auto is_key = [](const Pose& pose) { return pose.kind() == Pose::Kind::Quaternion; };
    if (is_key(from.a) && is_key(from.b) && is_key(to.a) && is_key(to.b)) {
        json["motion"] = motion_json(*scenario.result, *scenario.keys);
    }
}

/// Adds to which step and which bodies a scenario of a scene belongs.
void add_place(Json& json, const ScenarioView& scenario) {
    if (scenario.scene) {
        json["step"] = scenario.scene->step;
        json["bodies"] = {scenario.scene->body_a, scenario.scene->body_b};
    }
}

void add_result(Json& json, const ScenarioView& scenario) {
    const ScenarioResult none;
    const ScenarioResult& result = scenario.result ? *scenario.result : none;
    const std::uint64_t pairs = result.pair_count + result.near_count;
    const bool is_bounded =
        result.kind == ScenarioClass::Undecided && std::isfinite(result.distance_bound);
    json.update(Json{{"class", scenario.result ? Json(to_text(result.kind)) : Json()},
                     {"count", result.pair_count},
                     {"near_count", result.near_count},
                     {"listed", scenario.listed},
                     {"cut", result.level >= Level::Pairs && scenario.listed < pairs},
                     {"surfaces_only", result.surfaces_only},
                     {"insides_skipped", result.insides_skipped},
                     {"distance_bound", is_bounded ? Json(result.distance_bound) : Json()},
                     {"failure", result.failure}});
}

/// Returns the least distance of a near pair; nothing if there is none, or perhaps a lesser one
/// that is not listed.
std::optional<double> least_distance(const ScenarioView& scenario) {
    if (scenario.drawn == nullptr || scenario.drawn->is_cut() ||
        scenario.drawn->near_distances.empty()) {
        return std::nullopt;
    }
    return *std::ranges::min_element(scenario.drawn->near_distances);
}

} // namespace

std::string origin_json(const PageOrigin& origin) {
    return compact({{"kind", kind_text(origin.kind)},
                    {"program", origin.program},
                    {"name", origin.name},
                    {"tls", origin.is_tls},
                    {"job", origin.job.empty() ? Json() : Json(origin.job)}});
}

std::string cluster_json(const ClusterView& cluster) {
    return status_json(cluster.before, cluster.now);
}

std::string history_json(std::span<const HistorySample> samples) {
    Json rows = Json::array();
    for (const HistorySample& each : samples) {
        rows.push_back(
            {each.unix_seconds, each.scenarios, each.sent, each.received, each.from_peers});
    }
    return compact({{"period_seconds", 1},
                    {"columns",
                     {"time",
                      "scenarios_per_second",
                      "sent_per_second",
                      "received_per_second",
                      "peer_per_second"}},
                    {"rows", std::move(rows)}});
}

std::string jobs_json(std::span<const JobRow> jobs) {
    Json rows = Json::array();
    for (const JobRow& job : jobs) {
        rows.push_back(row_json(job));
    }
    return compact({{"jobs", std::move(rows)}});
}

std::string progress_json(const JobRow& job) {
    return compact(progress_of(job));
}

std::string job_view_json(const JobView& job) {
    Json json = progress_of(job.row);
    json.update(query_json(job.query));
    add_question(json, job.query);
    json.update(run_json(job.run));
    json["unit"] = job.unit;
    json["maps"] = job.map.exists;
    json["map_pairs"] = job.map.first_pairs;
    json["bodies"] = Json::array();
    for (const BodyView& body : job.bodies) {
        json["bodies"].push_back(body_json(body));
    }
    json["poses"] = poses_json(job.poses);
    if (job.steps) {
        json["steps"] = *job.steps;
    }
    json["groups"] = Json();
    json["groups_total"] = job.groups ? job.groups->total : 0;
    if (job.groups) {
        json["groups"] = Json::array();
        for (const GroupView& group : job.groups->rows) {
            json["groups"].push_back(group_json(group));
        }
    }
    return compact(json);
}

std::string scenario_json(std::uint64_t number, const ScenarioView& scenario) {
    Json json{{"index", number}};
    add_result(json, scenario);
    json["id"] = scenario.id.empty() ? Json() : Json(scenario.id);
    json["time"] = or_null(scenario.time);
    add_place(json, scenario);
    json["pose_a"] = pose_rows(scenario.poses.a);
    json["pose_b"] = pose_rows(scenario.poses.b);
    json["verified"] = or_null(scenario.verified);
    json["verify_note"] = scenario.verify_note;
    json["draw_note"] = scenario.draw_note;
    json["exact_pairs"] = scenario.drawn != nullptr ? scenario.drawn->pairs.size() : 0;
    json["least_distance"] = or_null(least_distance(scenario));
    add_distance(json, scenario);
    add_motion(json, scenario);
    return compact(json);
}

std::string part_names_json(std::span<const std::string> names) {
    Json json = Json::array();
    for (const std::string& name : names) {
        json.push_back(name);
    }
    return compact(json);
}

std::string next_json(const NextFound& next) {
    return compact({{"index", or_null(next.scenario)}, {"searched_to", or_null(next.searched_to)}});
}

std::string error_json(const std::string& text) {
    return compact({{"error", text}});
}

} // namespace cd
