#include "client/spec/job_file.hpp"

#include "client/base/units.hpp"
#include "client/formats/output_file.hpp"
#include "client/spec/query_spec.hpp"
#include "client/spec/shots_spec.hpp"
#include "client/spec/toml_fields.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr std::array<std::string_view, 7> format_names{
    "text", "json", "csv", "csv-pairs", "npz", "vtp", "glb"};
constexpr std::string_view depth_auto = "auto";
constexpr std::array<std::string_view, 2> up_axes{"y", "z"};
constexpr std::array<std::string_view, 2> quat_orders{"xyzw", "wxyz"};
constexpr std::array<std::string_view, 2> pose_owners{"b", "both"};
/// "auto": floats if they hold every coordinate, else doubles.
constexpr std::array<std::string_view, 2> precision_names{"auto", "float"};

std::filesystem::path beside(const std::filesystem::path& job, const std::string& path) {
    return path == "-" ? std::filesystem::path(path) : job.parent_path() / path;
}

void read_body(const TomlFields& job,
               std::string_view key,
               const std::filesystem::path& file,
               BodySpec& body) {
    const toml::table* table = job.table(key);
    if (table == nullptr) {
        job.refuse(key, "the table [" + std::string(key) + "] with its mesh is missing");
    }
    const TomlFields fields(
        table, job, "[" + std::string(key) + "]", {"mesh", "unit", "name", "up", "precision"});
    const auto mesh = fields.text("mesh");
    if (!mesh || mesh->empty()) {
        fields.refuse("mesh", "the key \"mesh\" with the file's name is missing");
    }
    body.path = beside(file, *mesh);
    body.unit = fields.word("unit", unit_names()).value_or("");
    body.name = fields.text("name").value_or("");
    body.up = fields.word("up", up_axes).value_or("");
    body.rounds_to_float = fields.word("precision", precision_names) == "float";
}

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

void read_poses(const TomlFields& job, JobSpec& spec) {
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
    const double factor = unit_factor(unit.empty() ? spec.unit : unit, spec.unit).value_or(1);
    if (file) {
        PoseFileSpec poses = read_pose_file(fields, *file, spec.file);
        poses.length_factor = factor;
        poses.unit = unit;
        spec.poses = std::move(poses);
        return;
    }
    for (const std::string_view key : {"quat_order", "of", "rigid_tolerance"}) {
        if (fields.has(key)) {
            fields.refuse(key, std::string(key) + " belongs to poses from a file");
        }
    }
    if (grid != nullptr) {
        GridSpec poses = read_grid(fields, grid, factor);
        poses.unit = unit;
        spec.poses = std::move(poses);
    } else if (fields.has("unit")) {
        fields.refuse("unit", "unit belongs to poses from a file or a grid");
    } else {
        spec.poses = read_random(fields, random);
    }
}

void read_ignore(const TomlFields& query, JobSpec& spec) {
    const toml::array* rules = query.array("ignore");
    if (rules == nullptr) {
        return;
    }
    for (const toml::node& node : *rules) {
        const toml::array* rule = node.as_array();
        if (rule == nullptr || rule->size() != 2 || !rule->get(0)->is_string() ||
            !rule->get(1)->is_string()) {
            query.refuse(node,
                         "ignore is an array of pairs of part names, such as "
                         "[[\"wheel_*\", \"ground\"]]");
        }
        spec.ignore.push_back({rule->get(0)->value_or(std::string()),
                               rule->get(1)->value_or(std::string()),
                               node.source().begin.line});
    }
}

std::optional<double> read_length(const TomlFields& query, std::string_view key) {
    const std::optional<double> length = query.number(key);
    if (length && !is_clearance(*length)) {
        query.refuse(key, std::string(key) + " is a length of at least 0, in the job's unit");
    }
    return length;
}

void read_query(const TomlFields& job, JobSpec& spec) {
    const toml::table* table = job.table("query");
    if (table == nullptr) {
        return;
    }
    if (const toml::node* gone = table->get("tolerance")) {
        job.refuse(*gone,
                   "the key tolerance, under which small boxes stayed undecided, is gone, since "
                   "exact answers are faster: remove it; level \"any\" is the fastest");
    }
    const TomlFields fields(
        table, job, "[query]", {"level", "clearance", "up_to", "limit_pairs", "maps", "ignore"});
    Query& query = spec.query;
    static_cast<void>(set_asked_level(fields.word("level", asked_levels).value_or("pairs"), query));
    query.limit_pairs = fields.integer("limit_pairs", 0, std::numeric_limits<std::uint32_t>::max())
                            .value_or(query.limit_pairs);
    query.maps = fields.boolean("maps").value_or(query.maps);
    query.clearance = read_length(fields, "clearance");
    query.up_to = read_length(fields, "up_to");
    if (const auto conflict = conflict_in(query)) {
        fields.refuse(conflict->key, std::string(conflict->reason));
    }
    read_ignore(fields, spec);
}

void read_output(const TomlFields& job, JobSpec& spec) {
    const toml::table* table = job.table("output");
    if (table == nullptr) {
        return;
    }
    const TomlFields fields(table, job, "[output]", {"dir", "formats"});
    spec.output.dir = beside(spec.file, fields.text("dir").value_or("out"));
    const toml::array* formats = fields.array("formats");
    if (formats == nullptr) {
        return;
    }
    spec.output.formats.clear();
    for (const toml::node& node : *formats) {
        const auto format = node.value_exact<std::string>();
        const Status known =
            format ? check_format(*format) : bad_input("a format is text in quotes");
        if (!known) {
            fields.refuse(node, known.error().detail);
        }
        spec.output.formats.push_back(*format);
    }
    keep_each_once(spec.output.formats);
}

void read_depth(const TomlFields& cluster, JobSpec& spec) {
    const toml::table* table = cluster.says("depth", depth_auto) ? nullptr : cluster.table("depth");
    if (table == nullptr) {
        return;
    }
    const TomlFields fields(table, cluster, "[cluster] depth", {"a", "b"});
    const auto depth = [&](std::string_view key) -> std::optional<std::uint32_t> {
        return fields.says(key, depth_auto)
                   ? std::nullopt
                   : fields.integer(key, 0, limits::distribution_depth_max);
    };
    spec.cluster.set_depth(0, depth("a"));
    spec.cluster.set_depth(1, depth("b"));
}

void read_cluster(const TomlFields& job, JobSpec& spec) {
    const toml::table* table = job.table("cluster");
    if (table == nullptr) {
        return;
    }
    const TomlFields fields(
        table,
        job,
        "[cluster]",
        {"strategy", "depth", "q", "v_kb", "claim", "seed", "analysis", "hints"});
    ClusterOptions& options = spec.cluster;
    options.strategy = fields.word("strategy", strategy_names()).value_or(options.strategy);
    read_depth(fields, spec);
    options.q =
        static_cast<std::uint32_t>(fields.integer("q", 1, limits::q_max).value_or(options.q));
    options.v_kb = static_cast<std::uint32_t>(
        fields.integer("v_kb", 1, limits::v_kb_max).value_or(options.v_kb));
    options.claim = fields.boolean("claim").value_or(options.claim);
    options.hints = fields.boolean("hints").value_or(options.hints);
    if (const auto analysis = fields.word("analysis", analysis_mode_names())) {
        options.analysis = analysis_mode_from_text(*analysis).value_or(options.analysis);
    }
    options.seed =
        fields.integer("seed", 0, std::numeric_limits<std::int64_t>::max()).value_or(options.seed);
}

void read_job(const toml::table& table, JobSpec& spec) {
    const TomlFields job(
        table,
        spec.file.string(),
        "the job",
        {"name", "unit", "a", "b", "poses", "shots", "query", "output", "cluster"});
    spec.name = job.text("name").value_or(spec.file.stem().string());
    spec.unit = job.word("unit", unit_names()).value_or(spec.unit);
    read_body(job, "a", spec.file, spec.bodies[0]);
    const bool are_shots = job.has("shots");
    if (are_shots) {
        take_shots(read_shots(job, spec.file, spec.query), spec);
    } else {
        read_body(job, "b", spec.file, spec.bodies[1]);
        read_poses(job, spec);
    }
    if (const std::string name = export_name(spec, 0); name == export_name(spec, 1)) {
        job.refuse(are_shots ? "a" : "b",
                   "both bodies have the name \"" + name + "\"; exports need two names");
    }
    read_query(job, spec);
    read_output(job, spec);
    read_cluster(job, spec);
}

} // namespace

void take_shots(ShotsSpec shots, JobSpec& spec) {
    spec.bodies[1].name = lines_name;
    spec.bodies[1].path = shots.file;
    spec.poses = std::move(shots);
}

std::string export_name(const JobSpec& spec, std::size_t body) {
    const std::string& name = spec.bodies[body].name;
    return name.empty() ? std::string(1, static_cast<char>('a' + body)) : name;
}

Status check_matching(const ClusterOptions& options) {
    const Strategy* strategy = find_strategy(options.strategy);
    if (strategy != nullptr && !strategy->uses_q &&
        (options.claim || options.q != ClusterOptions{}.q)) {
        return bad_input("q and claim belong to the paper's strategies; " + options.strategy +
                         " ignores both. Leave them out, or add --strategy best-match (or "
                         "[cluster] strategy)");
    }
    return Done{};
}

Result<std::optional<std::uint32_t>> parse_depth(std::string_view text) {
    if (text == depth_auto) {
        return std::optional<std::uint32_t>();
    }
    const auto depth = number_in<std::uint32_t>(text);
    if (!depth || *depth > limits::distribution_depth_max) {
        return bad_input("a distribution depth is auto or 0 to " +
                         std::to_string(limits::distribution_depth_max) + ", not \"" +
                         std::string(text) + "\"");
    }
    return depth;
}

bool is_penetration(const RandomPoses& random) {
    return 0 <= random.penetration_min && random.penetration_min <= random.penetration_max &&
           random.penetration_max <= 1;
}

void keep_each_once(std::vector<std::string>& formats) {
    std::vector<std::string> once;
    for (std::string& format : formats) {
        if (std::find(once.begin(), once.end(), format) == once.end()) {
            once.push_back(std::move(format));
        }
    }
    formats = std::move(once);
}

Status check_format(std::string_view format) {
    if (std::find(format_names.begin(), format_names.end(), format) != format_names.end()) {
        return Done{};
    }
    return bad_input(
        "format \"" + std::string(format) +
        "\" is not known; this version has text, json, csv, csv-pairs, npz, vtp and glb");
}

Status check_map_formats(std::span<const std::string> formats, Level level, bool maps) {
    const bool has_map = maps || level >= Level::Pairs;
    for (const std::string& format : formats) {
        if (!has_map && (format == "vtp" || format == "glb")) {
            return bad_input("format " + format +
                             " shows in how many scenarios each triangle is in contact: from level "
                             "pairs on, or at level count with maps = true (--maps); run the job "
                             "so, or leave out " +
                             format);
        }
    }
    return Done{};
}

Result<JobSpec> parse_job(std::string_view text, const std::filesystem::path& path) {
    JobSpec spec;
    spec.file = path;
    try {
        read_job(toml::parse(text, path.string()), spec);
    } catch (const toml::parse_error& error) {
        return error_at(path.string(), error.source(), std::string(error.description()));
    } catch (const Refusal& refusal) {
        return refusal.error;
    }
    return spec;
}

Result<JobSpec> read_job_file(const std::filesystem::path& path) {
    const std::string text = CD_TRY(read_file(path));
    return parse_job(text, path);
}

} // namespace cd
