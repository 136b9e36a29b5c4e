#include "client/spec/scene_spec.hpp"

#include "client/base/units.hpp"
#include "client/spec/toml_fields.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

namespace cd {

namespace {

constexpr std::array<std::string_view, 1> split_words{"parts"};
constexpr std::array<std::string_view, 1> absent_words{"nan"};
/// Patterns of rules name groups so; no body may have such a name.
constexpr std::string_view group_prefix = "group:";

/// Reads x, y, z and a quaternion of length 1.
std::optional<Pose> read_pose(const TomlFields& fields, const std::string& quat_order) {
    const auto numbers =
        fields.numbers("pose", 7, "[x, y, z, then the quaternion in the order of quat_order]");
    if (!numbers) {
        return std::nullopt;
    }
    if (quat_order.empty()) {
        fields.refuse("pose",
                      "pose does not say which number is qw; give quat_order \"xyzw\" or \"wxyz\"");
    }
    const std::vector<double>& n = *numbers;
    const Quaternion q = quat_order == "wxyz" ? Quaternion{n[3], n[4], n[5], n[6]}
                                              : Quaternion{n[6], n[3], n[4], n[5]};
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    if (!(std::abs(length - 1) <= quaternion_off_max)) {
        fields.refuse("pose",
                      "the quaternion of pose has the length " + exact_text(length) +
                          "; a rotation has 1");
    }
    return Pose::from_quaternion(q, {n[0], n[1], n[2]});
}

std::optional<PoseFileSpec> read_own_poses(const TomlFields& fields,
                                           const std::string& quat_order,
                                           const std::filesystem::path& job) {
    const auto name = fields.text("poses");
    if (!name) {
        return std::nullopt;
    }
    if (name->empty() || *name == "-") {
        fields.refuse("poses", "poses has to be the name of a file with a pose for each step");
    }
    PoseFileSpec file;
    file.path = beside(job, *name);
    file.quat_order = quat_order;
    return file;
}

void check_name(const TomlFields& fields, const std::string& name) {
    if (const auto problem = problem_of_body_name(name)) {
        fields.refuse("", *problem);
    }
}

/// Refuses keys of a body that exclude each other.
void check_keys(const TomlFields& fields) {
    if (fields.has("pose") && fields.has("poses")) {
        fields.refuse("poses", "a body has either pose, the same at all steps, or poses");
    }
    if (fields.has("quat_order") && !fields.has("pose") && !fields.has("poses")) {
        fields.refuse("quat_order", "quat_order belongs to pose or poses; give one of these");
    }
    if (!fields.has("count")) {
        return;
    }
    for (const std::string_view key : {"pose", "poses", "split"}) {
        if (fields.has(key)) {
            fields.refuse(key,
                          std::string(key) + " is for one body, and count makes several; give each "
                                             "a pose by rows of [poses]");
        }
    }
}

SceneBodySpec read_scene_body(const TomlFields& job,
                              const std::string& name,
                              const toml::node& node,
                              const std::filesystem::path& file) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
        job.refuse(node, "[bodies] " + name + " has to be a table, such as { mesh = \"car.obj\" }");
    }
    const TomlFields fields(table,
                            job,
                            "[bodies] " + name,
                            {"mesh",
                             "unit",
                             "up",
                             "precision",
                             "origin",
                             "group",
                             "count",
                             "split",
                             "pose",
                             "poses",
                             "quat_order"});
    check_name(fields, name);
    check_keys(fields);
    SceneBodySpec body;
    body.name = name;
    body.mesh = read_mesh(fields, file);
    body.group = fields.text("group").value_or("");
    if (const auto count = fields.integer("count", 1, limits::bodies_max)) {
        body.count = static_cast<std::uint32_t>(*count);
    }
    body.is_split = fields.word("split", split_words).has_value();
    const std::string quat_order = fields.word("quat_order", quat_orders).value_or("");
    body.pose = read_pose(fields, quat_order);
    body.poses = read_own_poses(fields, quat_order, file);
    body.line = node.source().begin.line;
    return body;
}

/// Returns the entries of a table in the order of the file, which a table does not keep.
std::vector<std::pair<std::string, const toml::node*>> in_file_order(const toml::table& table) {
    std::vector<std::pair<const toml::key*, const toml::node*>> entries;
    for (const auto& [key, node] : table) {
        entries.emplace_back(&key, &node);
    }
    std::ranges::sort(entries, [](const auto& left, const auto& right) {
        return left.first->source().begin < right.first->source().begin;
    });
    std::vector<std::pair<std::string, const toml::node*>> named;
    for (const auto& [key, node] : entries) {
        named.emplace_back(std::string(key->str()), node);
    }
    return named;
}

std::vector<std::string> read_body_order(const TomlFields& poses) {
    const toml::array* names = poses.array("body_order");
    std::vector<std::string> order;
    std::set<std::string> known;
    if (names == nullptr) {
        return order;
    }
    for (const toml::node& node : *names) {
        const auto name = node.value_exact<std::string>();
        if (!name) {
            poses.refuse(node, "body_order is an array of bodies' names");
        }
        if (!known.insert(*name).second) {
            poses.refuse(node, "body_order names \"" + *name + "\" twice");
        }
        order.push_back(*name);
    }
    return order;
}

/// Refuses keys of [poses] that only a file of poses has.
void check_fcd_alone(const TomlFields& fields) {
    for (const std::string_view key :
         {"file", "unit", "quat_order", "rigid_tolerance", "body_order", "absent"}) {
        if (fields.has(key)) {
            fields.refuse(key,
                          std::string(key) + " is for a file of poses; leave out either it or fcd, "
                                             "which is in metres and says itself who is there");
        }
    }
}

/// Checks that the bodies of vehicles exist, and that the vehicles give their names and poses.
void check_vehicles(const TomlFields& poses, const SceneSpec& scene) {
    std::vector<std::string_view> names;
    for (const SceneBodySpec& body : scene.bodies) {
        names.push_back(body.name);
        if (is_of_vehicles(scene, body) &&
            (body.count || body.is_split || body.pose || body.poses)) {
            poses.refuse("fcd",
                         "fcd types gives the vehicles to \"" + body.name + "\" of line " +
                             std::to_string(body.line) +
                             ", so leave out its count, split, pose and poses");
        }
    }
    for (const auto& [type, body] : scene.fcd->types) {
        if (std::ranges::find(names, body) == names.end()) {
            poses.refuse("fcd",
                         "fcd types: no entry of [bodies] is called \"" + body + "\"" +
                             suggestion(body, names));
        }
    }
}

ScenePosesSpec read_scene_poses(const TomlFields& fields,
                                const std::string& job_unit,
                                const std::filesystem::path& job_file) {
    const auto name = fields.text("file");
    if (!name || name->empty()) {
        fields.refuse("file", "the key \"file\" with the name of a file of poses is missing");
    }
    ScenePosesSpec poses;
    poses.file.path = beside(job_file, *name);
    poses.file.quat_order = fields.word("quat_order", quat_orders).value_or("");
    poses.file.unit = fields.word("unit", unit_names()).value_or("");
    poses.file.length_factor =
        unit_factor(poses.file.unit.empty() ? job_unit : poses.file.unit, job_unit).value_or(1);
    poses.file.rigid_tolerance = fields.number("rigid_tolerance");
    if (poses.file.rigid_tolerance && *poses.file.rigid_tolerance < 0) {
        fields.refuse("rigid_tolerance", "rigid_tolerance is negative");
    }
    poses.body_order = read_body_order(fields);
    poses.nan_is_absent = fields.word("absent", absent_words).has_value();
    return poses;
}

/// Reads [poses]: a file of poses, or the vehicles of SUMO.
void read_poses_table(const TomlFields& job,
                      const std::string& job_unit,
                      const std::filesystem::path& job_file,
                      SceneSpec& scene) {
    const toml::table* table = job.table("poses");
    if (table == nullptr) {
        return;
    }
    for (const std::string_view key :
         {"grid", "random", "of", "line", "arc", "screw", "drive", "max_step"}) {
        if (const toml::node* node = table->get(key)) {
            job.refuse(*node,
                       "[poses] " + std::string(key) +
                           " is for two bodies; with [bodies] give a file that has the columns "
                           "step and body, or an array (steps, bodies, 7) with body_order");
        }
    }
    const TomlFields fields(
        table,
        job,
        "[poses]",
        {"file", "fcd", "unit", "quat_order", "rigid_tolerance", "body_order", "absent"});
    const std::uint32_t line = table->source().begin.line;
    if (fields.has("fcd")) {
        check_fcd_alone(fields);
        scene.fcd = read_fcd_spec(fields, job_unit, job_file);
        scene.fcd->line = line;
        check_vehicles(fields, scene);
        return;
    }
    scene.poses = read_scene_poses(fields, job_unit, job_file);
    scene.poses->line = line;
}

/// Refuses what only a job of two bodies has.
void check_no_two_bodies(const TomlFields& job) {
    for (const std::string_view key : {"a", "b"}) {
        if (job.has(key)) {
            job.refuse(key,
                       "[bodies] has all bodies; write [" + std::string(key) + "] in it as " +
                           std::string(key) + " = { mesh = ... }, with its poses");
        }
    }
}

} // namespace

std::optional<std::string> problem_of_body_name(std::string_view name) {
    if (name.empty() || name.size() > limits::label_bytes_max) {
        return "a body's name has 1 to " + std::to_string(limits::label_bytes_max) + " bytes";
    }
    if (name.starts_with(group_prefix)) {
        return "no body's name begins with group:, which names groups in [rules]";
    }
    return std::nullopt;
}

bool is_of_vehicles(const SceneSpec& scene, const SceneBodySpec& body) {
    return scene.fcd && std::ranges::any_of(scene.fcd->types, [&](const auto& type) {
               return type.second == body.name;
           });
}

SceneSpec
read_scene(const TomlFields& job, const std::string& unit, const std::filesystem::path& file) {
    check_no_two_bodies(job);
    const toml::table* table = job.table("bodies");
    if (table->empty()) {
        job.refuse("bodies", "[bodies] is empty; write a line NAME = { mesh = ... } for each body");
    }
    SceneSpec scene;
    for (const auto& [name, node] : in_file_order(*table)) {
        scene.bodies.push_back(read_scene_body(job, name, *node, file));
    }
    read_poses_table(job, unit, file, scene);
    scene.rules = read_rules(job);
    return scene;
}

} // namespace cd
