#include "client/job/job_text.hpp"

#include "client/job/scene_text.hpp"
#include "client/spec/query_spec.hpp"
#include "client/spec/toml_text.hpp"
#include "common/core/words.hpp"

#include <array>
#include <variant>

namespace cd {

namespace {

std::string body_text(const BodySpec& body, std::string_view key) {
    std::string text =
        "\n[" + std::string(key) + "]\n" + toml_line("mesh", toml_quoted(body.path.string()));
    text += body.unit.empty() ? "" : toml_line("unit", toml_quoted(body.unit));
    text += body.name.empty() ? "" : toml_line("name", toml_quoted(body.name));
    text += body.up.empty() ? "" : toml_line("up", toml_quoted(body.up));
    text += body.rounds_to_float ? toml_line("precision", toml_quoted("float")) : "";
    return text + (body.origin == std::array<double, 3>{}
                       ? ""
                       : toml_line("origin", toml_list(body.origin, toml_number)));
}

std::string poses_text(const RandomPoses& random) {
    return toml_line("random",
                     "{ n = " + std::to_string(random.count) +
                         ", seed = " + std::to_string(random.seed) + ", penetration = [" +
                         toml_number(random.penetration_min) + ", " +
                         toml_number(random.penetration_max) + "] }");
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
                    toml_number(axis.first) + ", " + toml_number(axis.last) + ", " +
                    std::to_string(axis.count) + "]";
        }
    }
    return toml_line("grid", "{" + axes + " }") +
           (grid.unit.empty() ? "" : toml_line("unit", toml_quoted(grid.unit)));
}

std::string poses_text(const PoseFileSpec& poses) {
    std::string text = toml_line("file", toml_quoted(poses.path.string()));
    text += poses.unit.empty() ? "" : toml_line("unit", toml_quoted(poses.unit));
    text += poses.quat_order.empty() ? "" : toml_line("quat_order", toml_quoted(poses.quat_order));
    text += poses.of_both_bodies ? toml_line("of", toml_quoted("both")) : "";
    return text + (poses.rigid_tolerance
                       ? toml_line("rigid_tolerance", toml_number(*poses.rigid_tolerance))
                       : "");
}

std::string poses_text(const CurveSpec& curve) {
    return curve.text + "\n" +
           (curve.unit.empty() ? "" : toml_line("unit", toml_quoted(curve.unit)));
}

std::string axis_text(std::string_view key, const GridAxis& axis) {
    return axis == GridAxis{}
               ? ""
               : toml_line(key,
                           "[" + toml_number(axis.first) + ", " + toml_number(axis.last) + ", " +
                               std::to_string(axis.count) + "]");
}

/// Returns the line of the box that lines of a scene cover; empty without one.
std::string box_text(const ShotsSpec& shots) {
    if (!shots.box) {
        return {};
    }
    const auto& [low, high] = *shots.box;
    return toml_line("box",
                     toml_list(std::array{low.x(), low.y(), low.z(), high.x(), high.y(), high.z()},
                               toml_number));
}

std::string poses_text(const ShotsSpec& shots) {
    if (!shots.is_grid()) {
        return box_text(shots) + toml_line("file", toml_quoted(shots.file.string())) +
               (shots.form == LineForm::Rays ? toml_line("form", toml_quoted("rays")) : "");
    }
    const LineGrid& grid = shots.grid;
    std::string text = box_text(shots) + toml_line("spacing", toml_number(grid.spacing)) +
                       toml_line("tile", std::to_string(grid.tile));
    if (grid.jitter_seed) {
        text += toml_line("jitter", "{ seed = " + std::to_string(*grid.jitter_seed) + " }");
    } else if (grid.offset != LineGrid().offset) {
        text += toml_line("offset", toml_list(grid.offset, toml_number));
    }
    return text + axis_text("azimuth_deg", shots.azimuth_deg) +
           axis_text("elevation_deg", shots.elevation_deg);
}

std::string shots_text(const ShotsSpec& shots, const Query& query) {
    return "\n[shots]\n" + poses_text(shots) + (query.first_hits ? toml_line("first", "true") : "");
}

std::string two_bodies_text(const JobSpec& spec) {
    const std::string a = body_text(spec.bodies[0], "a");
    if (const auto* shots = std::get_if<ShotsSpec>(&spec.poses)) {
        return a + shots_text(*shots, spec.query);
    }
    return a + body_text(spec.bodies[1], "b") + "\n[poses]\n" +
           std::visit([](const auto& poses) { return poses_text(poses); }, spec.poses) +
           (spec.max_step ? toml_line("max_step", toml_number(*spec.max_step)) : "");
}

std::string motion_text(const MotionQuery& motion, const std::optional<double>& chord) {
    const bool is_usual = motion.until == Until::Contact;
    return "\n[motion]\n" + toml_line("resolution", toml_number(motion.resolution)) +
           (is_usual ? "" : toml_line("until", toml_quoted(to_text(motion.until)))) +
           (chord ? toml_line("chord", toml_number(*chord)) : "");
}

std::string query_text(const JobSpec& spec) {
    const Query& query = spec.query;
    std::string text = query.motion ? motion_text(*query.motion, spec.chord) : "";
    text += "\n[query]\n" + toml_line("level", toml_quoted(asked_level(query)));
    text += query.clearance ? toml_line("clearance", toml_number(*query.clearance)) : "";
    text += query.up_to ? toml_line("up_to", toml_number(*query.up_to)) : "";
    text +=
        query.limit_pairs > 0 ? toml_line("limit_pairs", std::to_string(query.limit_pairs)) : "";
    text += query.maps ? toml_line("maps", "true") : "";
    if (!spec.ignore.empty()) {
        text += toml_line("ignore", toml_list(spec.ignore, [](const IgnoreRule& rule) {
                              return "[" + toml_quoted(rule.a) + ", " + toml_quoted(rule.b) + "]";
                          }));
    }
    return text;
}

std::string output_text(const OutputSpec& output) {
    return "\n[output]\n" + toml_line("dir", toml_quoted(output.dir.string())) +
           toml_line("formats", toml_list(output.formats, toml_quoted));
}

std::string cluster_text(const ClusterOptions& options) {
    const ClusterOptions usual;
    const auto depth = [&](std::size_t body) {
        const auto given = options.depth(body);
        return given ? std::to_string(*given) : toml_quoted("auto");
    };
    std::string text;
    if (options.strategy != usual.strategy) {
        text += toml_line("strategy", toml_quoted(options.strategy));
    }
    if (options.depth(0) || options.depth(1)) {
        text += toml_line("depth", "{ a = " + depth(0) + ", b = " + depth(1) + " }");
    }
    text += options.q == usual.q ? "" : toml_line("q", std::to_string(options.q));
    text += options.v_kb == usual.v_kb ? "" : toml_line("v_kb", std::to_string(options.v_kb));
    text += options.claim ? toml_line("claim", "true") : "";
    text += options.seed == usual.seed ? "" : toml_line("seed", std::to_string(options.seed));
    if (options.analysis != usual.analysis) {
        text += toml_line("analysis", toml_quoted(to_text(options.analysis)));
    }
    text += options.hints ? "" : toml_line("hints", "false");
    return text.empty() ? text : "\n[cluster]\n" + text;
}

} // namespace

std::string job_text(const JobSpec& spec) {
    std::string text =
        toml_line("name", toml_quoted(spec.name)) + toml_line("unit", toml_quoted(spec.unit));
    text += spec.scene ? scene_text(*spec.scene) : two_bodies_text(spec);
    text += spec.scene && spec.scene->shots ? shots_text(*spec.scene->shots, spec.query) : "";
    return text + query_text(spec) + (spec.output.dir.empty() ? "" : output_text(spec.output)) +
           cluster_text(spec.cluster);
}

} // namespace cd
