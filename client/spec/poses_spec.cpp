#include "client/spec/poses_spec.hpp"

#include "client/base/units.hpp"
#include "client/spec/body_spec.hpp"
#include "client/spec/toml_fields.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cd {

namespace {

constexpr std::array<std::string_view, 2> pose_owners{"b", "both"};

GridAxis read_axis(const TomlFields& grid, std::string_view key) {
    const auto numbers = grid.numbers(key, 3, "[first, last, count]");
    if (!numbers) {
        return {};
    }
    const double count = (*numbers)[2];
    if (count < 1 || count != std::floor(count) ||
        count > static_cast<double>(limits::scenarios_max)) {
        grid.refuse(key, std::string(key) + ": the count has to be a whole number of at least 1");
    }
    return {(*numbers)[0], (*numbers)[1], static_cast<std::uint64_t>(count)};
}

/// Bounds the angles of one axis, which become quaternions in memory.
constexpr std::uint64_t grid_angles_max = 1u << 20;

GridSpec read_grid(const TomlFields& parent, const toml::table* table, double length_factor) {
    constexpr std::array<std::string_view, 3> positions{"x", "y", "z"};
    constexpr std::array<std::string_view, 3> angles{"roll_deg", "pitch_deg", "yaw_deg"};
    const TomlFields fields(
        table, parent, "[poses] grid", {"x", "y", "z", "roll_deg", "pitch_deg", "yaw_deg"});
    GridSpec spec;
    spec.axes.resize(positions.size() + angles.size());
    for (std::size_t i = 0; i < 3; ++i) {
        const GridAxis axis = read_axis(fields, positions[i]);
        spec.axes[i] = axis;
        spec.grid.position[i] = {axis.first * length_factor, axis.last * length_factor, axis.count};
        const GridAxis degrees = read_axis(fields, angles[i]);
        spec.axes[i + 3] = degrees;
        for (const auto& [key, tested] :
             {std::pair(positions[i], spec.grid.position[i]), std::pair(angles[i], degrees)}) {
            const double reach = (tested.last - tested.first) * static_cast<double>(tested.count);
            if (!std::isfinite(reach)) {
                fields.refuse(key, std::string(key) + " is too long for numbers of 64 bits");
            }
        }
        if (degrees.count > grid_angles_max) {
            fields.refuse(angles[i], "more than " + grouped(grid_angles_max) + " angles");
        }
        spec.grid.rotation[i] = rotation_axis(degrees, static_cast<int>(i));
    }
    if (spec.grid.count() > limits::scenarios_max) {
        fields.refuse("x", "the grid has more than " + grouped(limits::scenarios_max) + " poses");
    }
    return spec;
}

RandomPoses read_random(const TomlFields& parent, const toml::table* table) {
    const TomlFields fields(table, parent, "[poses] random", {"n", "seed", "penetration"});
    RandomPoses random;
    random.count = fields.integer("n", 1, limits::scenarios_max).value_or(random.count);
    random.seed =
        fields.integer("seed", 0, std::numeric_limits<std::int64_t>::max()).value_or(random.seed);
    if (const auto range = fields.numbers("penetration", 2, "[least, most]")) {
        random.penetration_min = (*range)[0];
        random.penetration_max = (*range)[1];
        if (!is_penetration(random)) {
            fields.refuse("penetration",
                          "penetration has to be [least, most] with 0 <= least <= most <= 1");
        }
    }
    return random;
}

PoseFileSpec
read_pose_file(const TomlFields& poses, const std::string& name, const std::filesystem::path& job) {
    if (name.empty()) {
        poses.refuse("file", "file is empty; give the name of a file with poses");
    }
    PoseFileSpec file;
    file.path = beside(job, name);
    file.quat_order = poses.word("quat_order", quat_orders).value_or("");
    file.of_both_bodies = poses.word("of", pose_owners) == "both";
    file.rigid_tolerance = poses.number("rigid_tolerance");
    if (file.rigid_tolerance && *file.rigid_tolerance < 0) {
        poses.refuse("rigid_tolerance", "rigid_tolerance is negative");
    }
    return file;
}

constexpr std::array<std::string_view, 4> curve_words{"line", "arc", "screw", "drive"};

constexpr double radians_per_degree = 3.14159265358979323846 / 180;

Vec3 read_vector(const TomlFields& fields, std::string_view key, const Vec3& otherwise) {
    const auto numbers = fields.numbers(key, 3, "[x, y, z]");
    return numbers ? Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]) : otherwise;
}

Vec3 needed_vector(const TomlFields& fields, std::string_view key) {
    if (!fields.has(key)) {
        fields.refuse("", std::string(key) + " = [x, y, z] is missing");
    }
    return read_vector(fields, key, Vec3::Zero());
}

/// Returns the axis with length 1.
Vec3 read_axis_vector(const TomlFields& fields) {
    const Vec3 axis = needed_vector(fields, "axis");
    if (axis == Vec3::Zero()) {
        fields.refuse("axis", "axis has no direction");
    }
    return axis / axis.norm();
}

std::array<double, 2> read_degrees(const TomlFields& fields, std::string_view key) {
    const auto degrees = fields.numbers(key, 2, "[first, last]");
    return degrees ? std::array<double, 2>{(*degrees)[0], (*degrees)[1]} : std::array<double, 2>{};
}

CurvePhase read_line(const TomlFields& fields, double length) {
    const auto [first, last] = read_degrees(fields, "yaw_deg");
    CurvePhase phase;
    phase.from = needed_vector(fields, "from") * length;
    phase.velocity = needed_vector(fields, "to") * length - phase.from;
    phase.turn = quaternion_from_euler(0, 0, first);
    phase.spin = Vec3(0, 0, (last - first) * radians_per_degree);
    return phase;
}

/// Reads the axis and the degrees of an arc or a screw. At 0 degrees B is not turned.
CurvePhase read_turning(const TomlFields& fields, double length) {
    if (!fields.has("degrees")) {
        fields.refuse("", "degrees = [first, last] is missing");
    }
    const auto [first, last] = read_degrees(fields, "degrees");
    const Vec3 axis = read_axis_vector(fields);
    CurvePhase phase;
    phase.pivot = read_vector(fields, "origin", Vec3::Zero()) * length;
    phase.spin = axis * (first * radians_per_degree);
    phase.from = *phase.pivot;
    const Pose begin = phase.at(1);
    phase.turn = begin.quaternion();
    phase.spin = axis * ((last - first) * radians_per_degree);
    return phase;
}

CurvePhase read_arc(const TomlFields& fields, double length) {
    CurvePhase phase = read_turning(fields, length);
    const Vec3 start = needed_vector(fields, "start") * length;
    const Pose begin = Pose::from_quaternion(phase.turn, Vec3::Zero());
    phase.from = *phase.pivot + begin.rotation() * (start - *phase.pivot);
    return phase;
}

CurvePhase read_screw(const TomlFields& fields, double length) {
    CurvePhase phase = read_turning(fields, length);
    if (!fields.has("pitch")) {
        fields.refuse("", "pitch is missing: how far B goes along the axis in a turn");
    }
    const auto [first, last] = read_degrees(fields, "degrees");
    const Vec3 each_degree =
        read_axis_vector(fields) * (fields.number("pitch").value_or(0) * length / 360);
    phase.from += each_degree * first;
    phase.velocity = each_degree * (last - first);
    return phase;
}

/// Reads a drive, which goes on from the end of the one before.
CurvePhase read_drive(const TomlFields& fields, double length, const CurvePhase* before) {
    CurvePhase phase;
    if (before == nullptr) {
        phase.from = read_vector(fields, "start", Vec3::Zero()) * length;
    } else {
        if (fields.has("start")) {
            fields.refuse("start", "start belongs to the first drive; the others go on from there");
        }
        const Pose end = before->at(before->seconds);
        phase.from = end.translation();
        phase.turn = end.quaternion();
        phase.velocity = before->velocity + before->acceleration * before->seconds;
    }
    phase.velocity =
        fields.has("velocity") ? read_vector(fields, "velocity", {}) * length : phase.velocity;
    phase.acceleration = read_vector(fields, "acceleration", Vec3::Zero()) * length;
    phase.spin = read_vector(fields, "spin_deg", Vec3::Zero()) * radians_per_degree;
    phase.seconds = fields.number("seconds").value_or(0);
    if (!(phase.seconds > 0)) {
        fields.refuse("seconds", "seconds is a number above 0");
    }
    return phase;
}

std::vector<CurvePhase> read_drives(const TomlFields& poses, double length) {
    std::vector<CurvePhase> phases;
    const auto add = [&](const toml::table* table) {
        const TomlFields fields(table,
                                poses,
                                "[poses] drive",
                                {"start", "velocity", "acceleration", "spin_deg", "seconds"});
        phases.push_back(read_drive(fields, length, phases.empty() ? nullptr : &phases.back()));
    };
    if (!poses.is_array("drive")) {
        add(poses.table("drive"));
        return phases;
    }
    for (const toml::node& node : *poses.array("drive")) {
        if (!node.is_table()) {
            poses.refuse(node, "drive is a table, or an array of tables");
        }
        add(node.as_table());
    }
    if (phases.empty()) {
        poses.refuse("drive", "drive is empty");
    }
    return phases;
}

std::vector<CurvePhase> read_phases(const TomlFields& poses, std::string_view word, double length) {
    if (word == "drive") {
        return read_drives(poses, length);
    }
    const toml::table* table = poses.table(word);
    const std::string name = "[poses] " + std::string(word);
    if (word == "line") {
        return {read_line(TomlFields(table, poses, name, {"from", "to", "yaw_deg"}), length)};
    }
    if (word == "arc") {
        return {read_arc(TomlFields(table, poses, name, {"origin", "axis", "degrees", "start"}),
                         length)};
    }
    return {
        read_screw(TomlFields(table, poses, name, {"origin", "axis", "degrees", "pitch"}), length)};
}

CurveSpec read_curve(const TomlFields& poses, std::string_view word, double length) {
    CurveSpec curve;
    curve.text = poses.line_of(word);
    curve.phases = read_phases(poses, word, length);
    const bool is_finite = std::ranges::all_of(
        curve.phases, [](const CurvePhase& phase) { return phase.at(phase.seconds).is_finite(); });
    if (!is_finite) {
        poses.refuse(word, std::string(word) + " leaves the range of numbers of 64 bits");
    }
    return curve;
}

/// Reads the fields of [poses].
TomlFields poses_fields(const toml::table* table, const TomlFields& parent) {
    const TomlFields fields(table,
                            parent,
                            "[poses]",
                            {"file",
                             "grid",
                             "random",
                             "line",
                             "arc",
                             "screw",
                             "drive",
                             "unit",
                             "quat_order",
                             "of",
                             "rigid_tolerance",
                             "max_step"});
    return fields;
}

} // namespace

Result<CurveSpec>
parse_curve(const std::string& text, const std::string& unit, const std::string& job_unit) {
    const std::string place = "the curve of the poses";
    try {
        const toml::table poses = toml::parse(text, place);
        const toml::table none;
        const TomlFields fields = poses_fields(&poses, TomlFields(none, place, "the job", {}));
        for (const std::string_view word : curve_words) {
            if (fields.has(word)) {
                CurveSpec curve =
                    read_curve(fields,
                               word,
                               unit_factor(unit.empty() ? job_unit : unit, job_unit).value_or(1));
                curve.unit = unit;
                return curve;
            }
        }
    } catch (const toml::parse_error& error) {
        return error_at(place, error.source(), std::string(error.description()));
    } catch (const Refusal& refusal) {
        return refusal.error;
    }
    return bad_input(place + " is missing");
}

PosesSpec read_poses(const TomlFields& job,
                     const std::string& job_unit,
                     const std::filesystem::path& job_file) {
    const toml::table* table = job.table("poses");
    if (table == nullptr) {
        job.refuse("poses",
                   "the table [poses] is missing; it has a file, a grid, random, or "
                   "a curve");
    }
    const TomlFields fields = poses_fields(table, job);
    const auto file = fields.text("file");
    const toml::table* grid = fields.table("grid");
    const toml::table* random = fields.table("random");
    const auto curve =
        std::ranges::find_if(curve_words, [&](auto word) { return fields.has(word); });
    const auto curves =
        std::ranges::count_if(curve_words, [&](auto word) { return fields.has(word); });
    if (curves + (file ? 1 : 0) + (grid != nullptr ? 1 : 0) + (random != nullptr ? 1 : 0) != 1) {
        fields.refuse("",
                      "exactly one of file, grid, random, line, arc, screw and drive is needed");
    }
    const std::string unit = fields.word("unit", unit_names()).value_or("");
    const double factor = unit_factor(unit.empty() ? job_unit : unit, job_unit).value_or(1);
    if (file) {
        PoseFileSpec poses = read_pose_file(fields, *file, job_file);
        poses.length_factor = factor;
        poses.unit = unit;
        return poses;
    }
    for (const std::string_view key : {"quat_order", "of", "rigid_tolerance"}) {
        if (fields.has(key)) {
            fields.refuse(key, std::string(key) + " belongs to poses from a file");
        }
    }
    if (curve != curve_words.end()) {
        CurveSpec poses = read_curve(fields, *curve, factor);
        poses.unit = unit;
        return poses;
    }
    if (grid != nullptr) {
        GridSpec poses = read_grid(fields, grid, factor);
        poses.unit = unit;
        return poses;
    }
    if (fields.has("unit")) {
        fields.refuse("unit", "unit belongs to poses from a file, a grid or a curve");
    }
    return read_random(fields, random);
}

bool is_penetration(const RandomPoses& random) {
    return 0 <= random.penetration_min && random.penetration_min <= random.penetration_max &&
           random.penetration_max <= 1;
}

} // namespace cd
