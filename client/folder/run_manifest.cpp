#include "client/folder/run_manifest.hpp"

#include "client/spec/job_file.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <set>

namespace cd {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t format_version = 3;
/// Returns the version of the canonical records (common/job/result/result.hpp). A program that does
/// not know a clearance or a distance refuses a folder with version 3.
std::uint64_t record_version(const Query& query, bool is_scene) {
    return is_scene || query.clearance || query.question != Question::Contacts ? 3 : 2;
}
/// The names of questions; that of contacts is not written.
constexpr std::string_view distance_name = "distance";
constexpr std::string_view motion_name = "motion";
constexpr std::string_view shots_name = "shots";
constexpr std::array<std::string_view, 5> kind_names{"grid", "file", "random", "shots", "curve"};

std::string_view to_text(PosesKind kind) {
    return kind_names[static_cast<std::size_t>(kind)];
}

template <class T>
Json json_or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

Json hash_json(const std::optional<Sha256>& hash) {
    return hash ? Json(to_hex(*hash)) : Json();
}

Json grid_json(const Grid& grid) {
    Json positions = Json::array();
    for (const GridAxis& axis : grid.position) {
        positions.push_back({{"first", axis.first}, {"last", axis.last}, {"count", axis.count}});
    }
    Json rotations = Json::array();
    for (const std::vector<Quaternion>& rotation : grid.rotation) {
        Json turns = Json::array();
        for (const Quaternion& q : rotation) {
            turns.push_back(Json::array({q.w, q.x, q.y, q.z}));
        }
        rotations.push_back(std::move(turns));
    }
    return {{"position", std::move(positions)}, {"rotation_wxyz", std::move(rotations)}};
}

Json poses_json(const ManifestPoses& poses) {
    Json json{{"kind", to_text(poses.kind)},
              {"count", poses.count},
              {"sha256", hash_json(poses.hash)},
              {"ids", poses.labels.ids},
              {"times", poses.labels.times}};
    if (poses.labels.end_times) {
        json["end_times"] = true;
    }
    if (poses.grid) {
        json["grid"] = grid_json(*poses.grid);
    }
    if (poses.random) {
        json["seed"] = poses.random->seed;
        json["penetration"] = {poses.random->penetration_min, poses.random->penetration_max};
    }
    if (poses.kind == PosesKind::File) {
        json["file"] = poses.file;
        json["quat_order"] = poses.quat_order;
        json["both"] = poses.of_both_bodies;
        json["rigid_tolerance"] = json_or_null(poses.rigid_tolerance);
        json["unit"] = poses.unit;
    }
    return json;
}

Json query_json(const Query& query) {
    Json ignored = Json::array();
    for (const IgnoredRange& range : query.ignored) {
        ignored.push_back({{"bodies", {range.body_a, range.body_b}},
                           {"triangles",
                            Json::array({Json::array({range.a_begin, range.a_end}),
                                         Json::array({range.b_begin, range.b_end})})}});
    }
    Json json{{"level", to_text(query.level)},
              {"limit_pairs", query.limit_pairs},
              {"maps", query.maps},
              {"ignored", std::move(ignored)}};
    if (query.clearance) {
        json["clearance"] = *query.clearance;
    }
    if (query.question == Question::Distance) {
        json["question"] = distance_name;
    }
    if (query.motion) {
        json["question"] = motion_name;
        json["resolution"] = query.motion->resolution;
        json["until"] = to_text(query.motion->until);
    }
    if (query.question == Question::Shots) {
        json["question"] = shots_name;
        json["first_hits"] = query.first_hits;
    }
    if (query.up_to) {
        json["up_to"] = *query.up_to;
    }
    return json;
}

Json where_json(const ManifestPlace& where) {
    if (where.master.empty()) {
        return {{"threads", where.threads}, {"simd", where.simd}};
    }
    return {{"master", where.master}, {"workers", where.workers}, {"job", where.job}};
}

/// Lists the parts of each mesh once, with its first body.
Json bodies_json(const std::vector<ManifestBody>& bodies) {
    Json json = Json::array();
    std::set<Sha256> known;
    for (const ManifestBody& body : bodies) {
        Json one({{"name", body.name},
                  {"file", body.file},
                  {"unit", body.unit},
                  {"unit_given", body.is_unit_given},
                  {"up", body.up},
                  {"precision", body.rounds_to_float ? "float" : "auto"},
                  {"sha256", to_hex(body.mesh)},
                  {"parts", Json::array()}});
        if (known.insert(body.mesh).second) {
            one["parts"] = body.parts;
        }
        if (body.is_fixed) {
            one["fixed"] = true;
        }
        if (body.origin != std::array<double, 3>{}) {
            one["origin"] = body.origin;
        }
        json.push_back(std::move(one));
    }
    return json;
}

Json reuse_json(const ManifestReuse& reused) {
    return {
        {"run", reused.run}, {"digest", hash_json(reused.digest)}, {"scenarios", reused.scenarios}};
}

Json files_json(const std::vector<ManifestFile>& files) {
    Json json = Json::array();
    for (const ManifestFile& file : files) {
        json.push_back({{"name", file.name}, {"bytes", file.bytes}});
    }
    return json;
}

// ---- Reading: `parse_manifest` catches the exceptions of `at` -----------------------------------

template <class T>
T value_of(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end()) {
        throw Refusal{bad_input("\"" + std::string(key) + "\" is missing")};
    }
    return found->get<T>();
}

template <class T>
T value_or(const Json& json, const char* key, T other) {
    const auto found = json.find(key);
    return found == json.end() || found->is_null() ? other : found->get<T>();
}

double number_of(const Json& json) {
    const auto value = json.get<double>();
    if (!std::isfinite(value)) {
        throw Refusal{bad_input("a number is not finite")};
    }
    return value;
}

std::optional<Sha256> read_hash(const Json& json, const char* key) {
    const auto text = value_or<std::string>(json, key, "");
    const auto hash = sha256_from_hex(text);
    if (!text.empty() && !hash) {
        throw Refusal{bad_input("\"" + std::string(key) + "\" is no SHA-256")};
    }
    return hash;
}

std::vector<ManifestBody> read_bodies(const Json& json) {
    std::vector<ManifestBody> bodies;
    std::map<Sha256, std::vector<std::string>> parts;
    for (const Json& each : json.at("bodies")) {
        ManifestBody body;
        body.name = value_of<std::string>(each, "name");
        body.file = value_of<std::string>(each, "file");
        body.unit = value_of<std::string>(each, "unit");
        body.is_unit_given = value_or(each, "unit_given", false);
        body.up = value_or<std::string>(each, "up", "");
        body.rounds_to_float = value_or<std::string>(each, "precision", "") == "float";
        const auto mesh = read_hash(each, "sha256");
        if (!mesh) {
            throw Refusal{bad_input("body \"" + body.name + "\" has no SHA-256")};
        }
        body.mesh = *mesh;
        body.is_fixed = value_or(each, "fixed", false);
        body.origin = value_or(each, "origin", std::array<double, 3>{});
        parts.emplace(body.mesh, value_or<std::vector<std::string>>(each, "parts", {}));
        body.parts = parts.at(body.mesh);
        bodies.push_back(std::move(body));
    }
    const bool is_scene = json.contains("scene");
    if (is_scene ? bodies.size() < 2 || bodies.size() > limits::bodies_max : bodies.size() != 2) {
        throw Refusal{bad_input("the number of bodies is out of range")};
    }
    return bodies;
}

std::optional<ManifestScene> read_scene(const Json& json) {
    if (!json.contains("scene")) {
        return std::nullopt;
    }
    const Json& scene = json.at("scene");
    const auto head = read_hash(scene, "head");
    if (!head) {
        throw Refusal{bad_input("the scene has no SHA-256")};
    }
    return ManifestScene{*head, value_of<std::uint64_t>(scene, "steps")};
}

Grid read_grid(const Json& json) {
    Grid grid;
    for (std::size_t i = 0; i < grid.position.size(); ++i) {
        const Json& axis = json.at("position").at(i);
        grid.position[i] = {number_of(axis.at("first")),
                            number_of(axis.at("last")),
                            value_of<std::uint64_t>(axis, "count")};
        for (const Json& q : json.at("rotation_wxyz").at(i)) {
            grid.rotation[i].push_back(
                {number_of(q.at(0)), number_of(q.at(1)), number_of(q.at(2)), number_of(q.at(3))});
        }
    }
    // `decode_grid` checks the numbers of the grid, which are untrusted.
    if (const auto checked = decode_grid(encode_grid(grid)); !checked) {
        throw Refusal{bad_input(checked.error().detail)};
    }
    return grid;
}

ManifestPoses read_poses(const Json& json) {
    ManifestPoses poses;
    const auto kind = std::ranges::find(kind_names, value_of<std::string>(json, "kind"));
    if (kind == kind_names.end()) {
        throw Refusal{bad_input("the kind of poses is not known")};
    }
    poses.kind = static_cast<PosesKind>(kind - kind_names.begin());
    poses.count = value_of<std::uint64_t>(json, "count");
    poses.hash = read_hash(json, "sha256");
    poses.labels.ids = value_or(json, "ids", false);
    poses.labels.times = value_or(json, "times", false);
    poses.labels.end_times = value_or(json, "end_times", false);
    if (poses.kind == PosesKind::Grid) {
        poses.grid = read_grid(json.at("grid"));
        if (poses.grid->count() != poses.count) {
            throw Refusal{bad_input("the grid has another number of poses")};
        }
    }
    if (poses.kind == PosesKind::Random) {
        const Json& penetration = json.at("penetration");
        poses.random = RandomPoses{poses.count,
                                   value_of<std::uint64_t>(json, "seed"),
                                   number_of(penetration.at(0)),
                                   number_of(penetration.at(1))};
        if (!is_penetration(*poses.random)) {
            throw Refusal{bad_input("the penetration is not within 0 to 1")};
        }
    }
    poses.file = value_or<std::string>(json, "file", "");
    poses.quat_order = value_or<std::string>(json, "quat_order", "");
    poses.of_both_bodies = value_or(json, "both", false);
    if (json.contains("rigid_tolerance") && !json["rigid_tolerance"].is_null()) {
        poses.rigid_tolerance = number_of(json["rigid_tolerance"]);
    }
    poses.unit = value_or<std::string>(json, "unit", "");
    if (poses.count > limits::scenarios_max) {
        throw Refusal{bad_input("the number of poses is out of range")};
    }
    return poses;
}

IgnoredRange read_ignored(const Json& json) {
    const Json& triangles = json.at("triangles");
    const auto end_of = [&](std::size_t body, std::size_t end) {
        return triangles.at(body).at(end).get<std::uint32_t>();
    };
    const Json& bodies = json.at("bodies");
    return {end_of(0, 0),
            end_of(0, 1),
            end_of(1, 0),
            end_of(1, 1),
            bodies.at(0).get<std::uint32_t>(),
            bodies.at(1).get<std::uint32_t>()};
}

std::optional<double> read_length(const Json& query, const char* key) {
    if (!query.contains(key)) {
        return std::nullopt;
    }
    const double length = number_of(query[key]);
    if (!is_clearance(length)) {
        throw Refusal{bad_input(std::string("the ") + key + " is out of range")};
    }
    return length;
}

Question read_question(std::string_view name) {
    for (const auto& [known, question] : {std::pair(distance_name, Question::Distance),
                                          std::pair(motion_name, Question::Motion),
                                          std::pair(shots_name, Question::Shots)}) {
        if (name == known) {
            return question;
        }
    }
    throw Refusal{bad_input("it has a question that is not known; use a later cdctl")};
}

MotionQuery read_motion(const Json& query) {
    const auto word = std::ranges::find(until_words, value_of<std::string>(query, "until"));
    if (word == until_words.end()) {
        throw Refusal{bad_input("the end of its motions is not known")};
    }
    return {number_of(query.at("resolution")), static_cast<Until>(word - until_words.begin())};
}

Query read_query(const Json& json) {
    Query query;
    const auto level = level_from_text(value_of<std::string>(json, "level"));
    if (!level) {
        throw Refusal{bad_input("the level is not known")};
    }
    query.level = *level;
    query.limit_pairs = value_of<std::uint64_t>(json, "limit_pairs");
    query.maps = value_of<bool>(json, "maps");
    query.clearance = read_length(json, "clearance");
    query.up_to = read_length(json, "up_to");
    if (json.contains("question")) {
        query.question = read_question(value_of<std::string>(json, "question"));
        query.first_hits = value_or(json, "first_hits", false);
    }
    if (query.question == Question::Motion) {
        query.motion = read_motion(json);
    }
    if (const char* problem = query_problem(query)) {
        throw Refusal{bad_input(std::string("its query is ") + problem)};
    }
    for (const Json& each : json.at("ignored")) {
        query.ignored.push_back(read_ignored(each));
    }
    return query;
}

/// Returns the text of a job without the key `tolerance`, which earlier versions wrote.
std::string without_tolerance(std::string job) {
    const std::size_t line = job.find("\ntolerance = ");
    return line == std::string::npos ? job : job.erase(line, job.find('\n', line + 1) - line);
}

std::optional<ManifestReuse> read_reuse(const Json& json) {
    const auto found = json.find("reused_from");
    if (found == json.end()) {
        return std::nullopt;
    }
    return ManifestReuse{value_of<std::string>(*found, "run"),
                         read_hash(*found, "digest"),
                         value_or<std::uint64_t>(*found, "scenarios", 0)};
}

RunManifest read_manifest(const Json& json) {
    const auto version = value_of<std::uint64_t>(json, "format");
    if (version > format_version) {
        throw Refusal{bad_input("its format is " + std::to_string(version) +
                                ", and this program reads " + std::to_string(format_version) +
                                "; use a later cdctl")};
    }
    RunManifest manifest;
    manifest.query = read_query(json.at("query"));
    if (value_of<std::uint64_t>(json, "record_version") !=
        record_version(manifest.query, json.contains("scene"))) {
        throw Refusal{
            bad_input("its records are of another version; use the cdctl that wrote them")};
    }
    manifest.origin.program = value_or<std::string>(json, "program", "");
    manifest.origin.commit = value_or<std::string>(json, "commit", "");
    manifest.origin.command = value_or<std::string>(json, "command", "");
    manifest.origin.started = value_or<std::string>(json, "started", "");
    manifest.origin.ended = value_or<std::string>(json, "ended", "");
    const Json where = json.value("where", Json::object());
    manifest.where = {value_or<std::uint64_t>(where, "threads", 0),
                      value_or<std::string>(where, "simd", ""),
                      value_or<std::string>(where, "master", ""),
                      value_or<std::string>(where, "job", ""),
                      value_or<std::uint64_t>(where, "workers", 0)};
    manifest.name = value_of<std::string>(json, "name");
    manifest.unit = value_of<std::string>(json, "unit");
    manifest.job = without_tolerance(value_or<std::string>(json, "job", ""));
    manifest.bodies = read_bodies(json);
    manifest.poses = read_poses(json.at("poses"));
    manifest.scene = read_scene(json);
    if (manifest.poses.count == 0 && !manifest.scene) {
        throw Refusal{bad_input("the number of poses is out of range")};
    }
    if (json["query"].contains("tolerance")) {
        manifest.outcome.tolerance = number_of(json["query"]["tolerance"]);
    }
    manifest.outcome.answered = value_or<std::uint64_t>(json, "answered", 0);
    manifest.outcome.digest = read_hash(json, "digest");
    manifest.outcome.map_digest = read_hash(json, "map_digest");
    manifest.outcome.reused = read_reuse(json);
    manifest.formats = value_or<std::vector<std::string>>(json, "formats", {});
    for (const Json& file : json.value("files", Json::array())) {
        manifest.files.push_back(
            {value_of<std::string>(file, "name"), value_of<std::uint64_t>(file, "bytes")});
    }
    return manifest;
}

bool is_equal(const Query& left, const Query& right) {
    return left.level == right.level && left.limit_pairs == right.limit_pairs &&
           left.maps == right.maps && left.ignored == right.ignored &&
           left.clearance == right.clearance && left.question == right.question &&
           left.up_to == right.up_to && left.first_hits == right.first_hits &&
           left.motion == right.motion;
}

bool has_same_poses(const ManifestPoses& left, const ManifestPoses& right) {
    if (left.random && right.random) {
        return left.random == right.random;
    }
    return left.count == right.count && left.hash && left.hash == right.hash;
}

} // namespace

std::string manifest_json(const RunManifest& manifest) {
    Json json{{"format", format_version},
              {"record_version", record_version(manifest.query, manifest.scene.has_value())},
              {"program", manifest.origin.program},
              {"commit", manifest.origin.commit},
              {"command", manifest.origin.command},
              {"started", manifest.origin.started},
              {"ended", manifest.origin.ended},
              {"where", where_json(manifest.where)},
              {"name", manifest.name},
              {"unit", manifest.unit},
              {"job", manifest.job},
              {"bodies", bodies_json(manifest.bodies)},
              {"poses", poses_json(manifest.poses)},
              {"query", query_json(manifest.query)},
              {"complete", manifest.is_complete()},
              {"answered", manifest.outcome.answered},
              {"digest", hash_json(manifest.outcome.digest)},
              {"map_digest", hash_json(manifest.outcome.map_digest)},
              {"formats", manifest.formats},
              {"files", files_json(manifest.files)}};
    if (manifest.outcome.tolerance > 0) {
        json["query"]["tolerance"] = manifest.outcome.tolerance;
    }
    if (manifest.scene) {
        json["scene"] = {{"head", to_hex(manifest.scene->head)}, {"steps", manifest.scene->steps}};
    }
    if (manifest.outcome.reused) {
        json["reused_from"] = reuse_json(*manifest.outcome.reused);
    }
    return json_text(json, 1);
}

Result<RunManifest> parse_manifest(std::string_view text) {
    try {
        return read_manifest(Json::parse(text));
    } catch (const Refusal& refusal) {
        return refusal.error;
    } catch (const nlohmann::json::exception&) {
        return bad_input("it is damaged, or no run.json of cdctl");
    }
}

bool is_same_job(const RunManifest& left, const RunManifest& right) {
    const bool same_meshes =
        std::ranges::equal(left.bodies, right.bodies, {}, &ManifestBody::mesh, &ManifestBody::mesh);
    const auto head = [](const RunManifest& run) {
        return run.scene ? std::optional(run.scene->head) : std::nullopt;
    };
    return same_meshes && head(left) == head(right) && has_same_poses(left.poses, right.poses) &&
           is_equal(left.query, right.query) && left.outcome.tolerance == right.outcome.tolerance;
}

Status check_exact(const RunManifest& manifest) {
    return manifest.outcome.tolerance > 0
               ? bad_input("the run had a tolerance of " + exact_text(manifest.outcome.tolerance) +
                           ", which is gone, so no run gives its answers again: run its job file "
                           "without the key tolerance into another folder")
               : Status(Done{});
}

bool reuses_same_run(const RunManifest& left, const RunManifest& right) {
    const auto& one = left.outcome.reused;
    const auto& other = right.outcome.reused;
    return one && other ? one->run == other->run && one->digest == other->digest
                        : one.has_value() == other.has_value();
}

std::string iso_time(std::uint64_t unix_seconds) {
    const auto time = static_cast<std::time_t>(unix_seconds);
    std::tm parts{};
    gmtime_r(&time, &parts);
    std::array<char, 32> text{};
    const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return {text.data(), size};
}

} // namespace cd
