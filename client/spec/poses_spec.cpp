#include "client/spec/poses_spec.hpp"

#include "client/base/units.hpp"
#include "client/spec/body_spec.hpp"
#include "client/spec/toml_fields.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/words.hpp"

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

} // namespace

PosesSpec read_poses(const TomlFields& job,
                     const std::string& job_unit,
                     const std::filesystem::path& job_file) {
    const toml::table* table = job.table("poses");
    if (table == nullptr) {
        job.refuse("poses", "the table [poses] is missing; it has a file, a grid or random");
    }
    const TomlFields fields(
        table,
        job,
        "[poses]",
        {"file", "grid", "random", "unit", "quat_order", "of", "rigid_tolerance"});
    const auto file = fields.text("file");
    const toml::table* grid = fields.table("grid");
    const toml::table* random = fields.table("random");
    const int sources = (file ? 1 : 0) + (grid != nullptr ? 1 : 0) + (random != nullptr ? 1 : 0);
    if (sources != 1) {
        fields.refuse("", "exactly one of file, grid and random is needed");
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
    if (grid != nullptr) {
        GridSpec poses = read_grid(fields, grid, factor);
        poses.unit = unit;
        return poses;
    }
    if (fields.has("unit")) {
        fields.refuse("unit", "unit belongs to poses from a file or a grid");
    }
    return read_random(fields, random);
}

bool is_penetration(const RandomPoses& random) {
    return 0 <= random.penetration_min && random.penetration_min <= random.penetration_max &&
           random.penetration_max <= 1;
}

} // namespace cd
