#include "client/job/scene_text.hpp"

#include "client/spec/toml_text.hpp"
#include "common/core/check.hpp"

#include <array>

namespace cd {

namespace {

std::string pose_keys(const Pose& pose) {
    CD_CHECK(pose.kind() == Pose::Kind::Quaternion);
    const Vec3& t = pose.translation();
    const Quaternion& q = pose.quaternion();
    return "pose = " + toml_list(std::array{t.x(), t.y(), t.z(), q.x, q.y, q.z, q.w}, toml_number) +
           ", quat_order = " + toml_quoted("xyzw");
}

/// Returns the keys of a body's table, each after a comma but the first.
std::string body_keys(const SceneBodySpec& body) {
    std::string text = "mesh = " + toml_quoted(body.mesh.path.string());
    const auto add = [&](const char* key, const std::string& value) {
        text += value.empty() ? "" : std::string(", ") + key + " = " + toml_quoted(value);
    };
    add("unit", body.mesh.unit);
    add("up", body.mesh.up);
    add("precision", body.mesh.rounds_to_float ? "float" : "");
    if (body.mesh.origin != std::array<double, 3>{}) {
        text += ", origin = " + toml_list(body.mesh.origin, toml_number);
    }
    add("group", body.group);
    text += body.count ? ", count = " + std::to_string(*body.count) : "";
    add("split", body.is_split ? "parts" : "");
    text += body.pose ? ", " + pose_keys(*body.pose) : "";
    if (body.poses) {
        add("poses", body.poses->path.string());
        add("quat_order", body.poses->quat_order);
    }
    return text;
}

std::string poses_table(const ScenePosesSpec& poses) {
    std::string text = "\n[poses]\n" + toml_line("file", toml_quoted(poses.file.path.string()));
    const auto add = [&](const char* key, const std::string& value) {
        text += value.empty() ? "" : toml_line(key, toml_quoted(value));
    };
    add("unit", poses.file.unit);
    add("quat_order", poses.file.quat_order);
    if (poses.file.rigid_tolerance) {
        text += toml_line("rigid_tolerance", toml_number(*poses.file.rigid_tolerance));
    }
    if (!poses.body_order.empty()) {
        text += toml_line("body_order", toml_list(poses.body_order, toml_quoted));
    }
    add("absent", poses.nan_is_absent ? "nan" : "");
    return text;
}

std::string fcd_table(const FcdSpec& fcd) {
    std::string types;
    for (const auto& [type, body] : fcd.types) {
        types += (types.empty() ? "" : ", ") + toml_quoted(type) + " = " + toml_quoted(body);
    }
    std::string text = "{ file = " + toml_quoted(fcd.path.string()) + ", types = { " + types + " }";
    text += fcd.z != 0 ? ", z = " + toml_number(fcd.z) : "";
    text += fcd.skips_other_types ? ", other_types = " + toml_quoted("skip") : "";
    return "\n[poses]\n" + toml_line("fcd", text + " }");
}

std::string rules_table(const RulesSpec& rules) {
    if (rules.order.empty() && !rules.learn) {
        return {};
    }
    std::string text = "\n[rules]\n";
    text += rules.learn ? toml_line("learn", std::to_string(*rules.learn)) : "";
    if (!rules.order.empty()) {
        text += "order = [\n";
        for (const SceneRule& rule : rules.order) {
            text += "    " + rule_text(rule) + ",\n";
        }
        text += "]\n";
    }
    return text;
}

} // namespace

std::string scene_text(const SceneSpec& scene) {
    std::string text = "\n[bodies]\n";
    for (const SceneBodySpec& body : scene.bodies) {
        text += toml_line(toml_quoted(body.name), "{ " + body_keys(body) + " }");
    }
    text += scene.poses ? poses_table(*scene.poses) : "";
    text += scene.fcd ? fcd_table(*scene.fcd) : "";
    return text + rules_table(scene.rules);
}

} // namespace cd
