#include "client/folder/job_text.hpp"

#include "client/spec/query_spec.hpp"
#include "common/core/words.hpp"

#include <array>
#include <variant>

namespace cd {

namespace {

std::string line(std::string_view key, const std::string& value) {
    return std::string(key) + " = " + value + "\n";
}

/// Writes a number in TOML, as a float if it is too large for an integer of TOML.
std::string number(double value) {
    constexpr std::size_t integer_digits = 15;
    const std::string text = exact_text(value);
    const bool is_whole = text.find_first_of(".e") == std::string::npos;
    return is_whole && text.size() > integer_digits ? text + ".0" : text;
}

template <class Range, class Write>
std::string list(const Range& range, const Write& write) {
    std::string text;
    for (const auto& each : range) {
        text += (text.empty() ? "" : ", ") + write(each);
    }
    return "[" + text + "]";
}

std::string body_text(const BodySpec& body, std::string_view key) {
    std::string text =
        "\n[" + std::string(key) + "]\n" + line("mesh", toml_quoted(body.path.string()));
    text += body.unit.empty() ? "" : line("unit", toml_quoted(body.unit));
    text += body.name.empty() ? "" : line("name", toml_quoted(body.name));
    text += body.up.empty() ? "" : line("up", toml_quoted(body.up));
    return text + (body.rounds_to_float ? line("precision", toml_quoted("float")) : "");
}

std::string poses_text(const RandomPoses& random) {
    return line("random",
                "{ n = " + std::to_string(random.count) +
                    ", seed = " + std::to_string(random.seed) + ", penetration = [" +
                    number(random.penetration_min) + ", " + number(random.penetration_max) + "] }");
}

std::string poses_text(const GridSpec& grid) {
    constexpr std::array<std::string_view, 6> keys{
        "x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg"};
    if (grid.axes.size() != keys.size()) {
        return "# a grid of " + std::to_string(grid.grid.count()) + " poses\n";
    }
    std::string axes;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const GridAxis& axis = grid.axes[i];
        if (axis != GridAxis{}) {
            axes += (axes.empty() ? " " : ", ") + std::string(keys[i]) + " = [" +
                    number(axis.first) + ", " + number(axis.last) + ", " +
                    std::to_string(axis.count) + "]";
        }
    }
    return line("grid", "{" + axes + " }") +
           (grid.unit.empty() ? "" : line("unit", toml_quoted(grid.unit)));
}

std::string poses_text(const PoseFileSpec& poses) {
    std::string text = line("file", toml_quoted(poses.path.string()));
    text += poses.unit.empty() ? "" : line("unit", toml_quoted(poses.unit));
    text += poses.quat_order.empty() ? "" : line("quat_order", toml_quoted(poses.quat_order));
    text += poses.of_both_bodies ? line("of", toml_quoted("both")) : "";
    return text +
           (poses.rigid_tolerance ? line("rigid_tolerance", number(*poses.rigid_tolerance)) : "");
}

std::string axis_text(std::string_view key, const GridAxis& axis) {
    return axis == GridAxis{} ? ""
                              : line(key,
                                     "[" + number(axis.first) + ", " + number(axis.last) + ", " +
                                         std::to_string(axis.count) + "]");
}

std::string lines_text(const ShotsSpec& shots) {
    if (!shots.is_grid()) {
        return line("file", toml_quoted(shots.file.string())) +
               (shots.form == LineForm::Rays ? line("form", toml_quoted("rays")) : "");
    }
    const LineGrid& grid = shots.grid;
    std::string text =
        line("spacing", number(grid.spacing)) + line("tile", std::to_string(grid.tile));
    if (grid.jitter_seed) {
        text += line("jitter", "{ seed = " + std::to_string(*grid.jitter_seed) + " }");
    } else if (grid.offset != LineGrid().offset) {
        text += line("offset", list(grid.offset, number));
    }
    return text + axis_text("azimuth_deg", shots.azimuth_deg) +
           axis_text("elevation_deg", shots.elevation_deg);
}

std::string shots_text(const ShotsSpec& shots, const Query& query) {
    return "\n[shots]\n" + lines_text(shots) + (query.first_hits ? line("first", "true") : "");
}

/// Writes body B and the poses.
std::string tested_text(const JobSpec& spec) {
    if (const auto* shots = std::get_if<ShotsSpec>(&spec.poses)) {
        return shots_text(*shots, spec.query);
    }
    std::string text = body_text(spec.bodies[1], "b") + "\n[poses]\n";
    if (const auto* file = std::get_if<PoseFileSpec>(&spec.poses)) {
        return text + poses_text(*file);
    }
    const auto* grid = std::get_if<GridSpec>(&spec.poses);
    return text +
           (grid != nullptr ? poses_text(*grid) : poses_text(std::get<RandomPoses>(spec.poses)));
}

std::string query_text(const JobSpec& spec) {
    const Query& query = spec.query;
    std::string text = "\n[query]\n" + line("level", toml_quoted(asked_level(query)));
    text += query.clearance ? line("clearance", number(*query.clearance)) : "";
    text += query.up_to ? line("up_to", number(*query.up_to)) : "";
    text += query.limit_pairs > 0 ? line("limit_pairs", std::to_string(query.limit_pairs)) : "";
    text += query.maps ? line("maps", "true") : "";
    if (!spec.ignore.empty()) {
        text += line("ignore", list(spec.ignore, [](const IgnoreRule& rule) {
                         return "[" + toml_quoted(rule.a) + ", " + toml_quoted(rule.b) + "]";
                     }));
    }
    return text;
}

std::string output_text(const OutputSpec& output) {
    return "\n[output]\n" + line("dir", toml_quoted(output.dir.string())) +
           line("formats", list(output.formats, toml_quoted));
}

std::string cluster_text(const ClusterOptions& options) {
    const ClusterOptions usual;
    const auto depth = [&](std::size_t body) {
        const auto given = options.depth(body);
        return given ? std::to_string(*given) : toml_quoted("auto");
    };
    std::string text;
    if (options.strategy != usual.strategy) {
        text += line("strategy", toml_quoted(options.strategy));
    }
    if (options.depth(0) || options.depth(1)) {
        text += line("depth", "{ a = " + depth(0) + ", b = " + depth(1) + " }");
    }
    text += options.q == usual.q ? "" : line("q", std::to_string(options.q));
    text += options.v_kb == usual.v_kb ? "" : line("v_kb", std::to_string(options.v_kb));
    text += options.claim ? line("claim", "true") : "";
    text += options.seed == usual.seed ? "" : line("seed", std::to_string(options.seed));
    if (options.analysis != usual.analysis) {
        text += line("analysis", toml_quoted(to_text(options.analysis)));
    }
    text += options.hints ? "" : line("hints", "false");
    return text.empty() ? text : "\n[cluster]\n" + text;
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

std::string job_text(const JobSpec& spec) {
    std::string text = line("name", toml_quoted(spec.name)) + line("unit", toml_quoted(spec.unit));
    text += body_text(spec.bodies[0], "a") + tested_text(spec);
    return text + query_text(spec) + (spec.output.dir.empty() ? "" : output_text(spec.output)) +
           cluster_text(spec.cluster);
}

} // namespace cd
