#include "client/folder/job_text.hpp"

#include "client/words.hpp"

#include <array>

namespace cd {

namespace {

std::string line(std::string_view key, const std::string& value) {
    return std::string(key) + " = " + value + "\n";
}

std::string body_text(const ManifestBody& body, std::string_view key) {
    std::string text = "\n[" + std::string(key) + "]\n" + line("mesh", toml_quoted(body.file));
    text += body.unit.empty() ? "" : line("unit", toml_quoted(body.unit));
    return text + (body.name == key ? "" : line("name", toml_quoted(body.name)));
}

std::string poses_text(const ManifestPoses& poses) {
    std::string text = "\n[poses]\n";
    if (poses.kind == PosesKind::Grid) {
        return text + "# a grid of " + std::to_string(poses.count) + " poses\n";
    }
    if (poses.random) {
        return text + "random = { n = " + std::to_string(poses.count) +
               ", seed = " + std::to_string(poses.random->seed) + ", penetration = [" +
               exact_text(poses.random->penetration_min) + ", " +
               exact_text(poses.random->penetration_max) + "] }\n";
    }
    text += line("file", toml_quoted(poses.file));
    text += poses.quat_order.empty() ? "" : line("quat_order", toml_quoted(poses.quat_order));
    text += poses.of_both_bodies ? line("of", toml_quoted("both")) : "";
    return text + (poses.rigid_tolerance
                       ? line("rigid_tolerance", exact_text(*poses.rigid_tolerance))
                       : "");
}

std::string query_text(const Query& query) {
    std::string text = "\n[query]\n" + line("level", toml_quoted(to_text(query.level)));
    text += query.tolerance > 0 ? line("tolerance", exact_text(query.tolerance)) : "";
    text += query.limit_pairs > 0 ? line("limit_pairs", std::to_string(query.limit_pairs)) : "";
    text += query.maps ? line("maps", "true") : "";
    for (const IgnoredRange& range : query.ignored) {
        text += "# passed over: triangles " + std::to_string(range.a_begin) + " to " +
                std::to_string(range.a_end - 1) + " of a with " + std::to_string(range.b_begin) +
                " to " + std::to_string(range.b_end - 1) + " of b\n";
    }
    return text;
}

} // namespace

std::string toml_quoted(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += std::string("\\") + c;
        } else if (code < 0x20 || code == 0x7f) {
            quoted += std::string("\\u00") + digits[code >> 4] + digits[code & 0xf];
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

std::string job_text(const RunManifest& manifest) {
    constexpr std::array<std::string_view, 2> keys{"a", "b"};
    std::string text = line("name", toml_quoted(manifest.name));
    text += line("unit", toml_quoted(manifest.unit));
    for (std::size_t i = 0; i < keys.size() && i < manifest.bodies.size(); ++i) {
        text += body_text(manifest.bodies[i], keys[i]);
    }
    return text + poses_text(manifest.poses) + query_text(manifest.query);
}

} // namespace cd
