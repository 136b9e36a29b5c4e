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

constexpr std::array<std::string_view, 8> format_names{
    "text", "json", "csv", "csv-pairs", "npz", "h5", "vtp", "glb"};
constexpr std::string_view depth_auto = "auto";

BodySpec read_body(const TomlFields& job, std::string_view key, const std::filesystem::path& file) {
    const toml::table* table = job.table(key);
    if (table == nullptr) {
        job.refuse(key, "the table [" + std::string(key) + "] with its mesh is missing");
    }
    const TomlFields fields(table,
                            job,
                            "[" + std::string(key) + "]",
                            {"mesh", "unit", "name", "up", "precision", "origin"});
    BodySpec body = read_mesh(fields, file);
    body.name = fields.text("name").value_or("");
    return body;
}

void read_ignore(const TomlFields& query, JobSpec& spec) {
    const toml::array* rules = query.array("ignore");
    if (rules == nullptr) {
        return;
    }
    if (spec.scene) {
        query.refuse("ignore",
                     "ignore is for two bodies; with [bodies] write [rules] order = [{ ignore = "
                     "[\"body/part\", \"other/part\"] }]");
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
    if (const auto conflict = conflict_in_scene(query); spec.scene && conflict) {
        fields.refuse(conflict->key, std::string(conflict->reason));
    }
    read_ignore(fields, spec);
}

/// Reads [motion], if the job has it, which sets the question of the query.
void read_motion(const TomlFields& job, JobSpec& spec) {
    const toml::table* table = job.table("motion");
    if (table == nullptr) {
        return;
    }
    if (job.has("shots")) {
        job.refuse("motion", "lines of [shots] do not move; leave out [motion], or [shots]");
    }
    const TomlFields fields(table, job, "[motion]", {"resolution", "until", "chord"});
    MotionQuery motion;
    const auto resolution = fields.number("resolution");
    if (!resolution) {
        fields.refuse("",
                      "resolution is missing: the length, in the job's unit, below which a part of "
                      "the motion may stay open");
    }
    if (!(*resolution > 0)) {
        fields.refuse("resolution", "resolution is a length above 0, in the job's unit");
    }
    motion.resolution = *resolution;
    if (const auto word = fields.word("until", until_words)) {
        const auto place = std::ranges::find(until_words, *word) - until_words.begin();
        motion.until = static_cast<Until>(place);
    }
    spec.chord = read_length(fields, "chord");
    if (spec.chord && *spec.chord == 0) {
        fields.refuse("chord", "chord is a length above 0, in the job's unit");
    }
    const bool may_be_curve = std::holds_alternative<CurveSpec>(spec.poses) ||
                              std::holds_alternative<PoseFileSpec>(spec.poses);
    if (spec.chord && !may_be_curve) {
        fields.refuse("chord", std::string(chord_use));
    }
    spec.query.question = Question::Motion;
    spec.query.motion = motion;
}

/// Reads the key `max_step` of [poses], and checks what kinds of poses have an order.
void read_order(const TomlFields& job, JobSpec& spec) {
    const bool is_curve = std::holds_alternative<CurveSpec>(spec.poses);
    const bool has_order = is_curve || std::holds_alternative<PoseFileSpec>(spec.poses);
    if (spec.query.motion && !has_order) {
        job.refuse("motion",
                   "a motion leads from each pose to the next; grids and random poses have no "
                   "order: give [poses] a file, line, arc, screw or drive, or leave out [motion]");
    }
    const toml::table* const table = job.table("poses");
    const toml::node* const step = table == nullptr ? nullptr : table->get("max_step");
    if (step != nullptr) {
        spec.max_step = step->value<double>();
        if (!spec.max_step || !(*spec.max_step > 0) || !std::isfinite(*spec.max_step)) {
            job.refuse(*step, "max_step is a length above 0, in the job's unit");
        }
        if (spec.query.motion || !has_order) {
            job.refuse(*step,
                       "max_step inserts poses between those of a file or a curve; leave it out "
                       "with [motion], which needs none, and with poses of another kind");
        }
    }
    if (is_curve && !spec.query.motion && !spec.max_step) {
        job.refuse("poses",
                   "a curve has no poses of its own: add [motion] to prove when the bodies meet on "
                   "it, or max_step = LENGTH to test poses along it");
    }
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
    if (spec.scene) {
        cluster.refuse("depth",
                       "depth is for two bodies; with [bodies] leave it out, and each tree is cut "
                       "into blocks of some 64 KiB");
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

void read_two_bodies(const TomlFields& job, JobSpec& spec) {
    if (job.has("rules")) {
        job.refuse("rules",
                   "[rules] is for a job with [bodies]; with [a] and [b] write [query] ignore = "
                   "[[\"part of a\", \"part of b\"]]");
    }
    spec.bodies[0] = read_body(job, "a", spec.file);
    const bool are_shots = job.has("shots");
    if (are_shots) {
        take_shots(read_shots(job, spec.file, spec.query), spec);
    } else {
        spec.bodies[1] = read_body(job, "b", spec.file);
        spec.poses = read_poses(job, spec.unit, spec.file);
    }
    if (const std::string name = export_name(spec, 0); name == export_name(spec, 1)) {
        job.refuse(are_shots ? "a" : "b",
                   "both bodies have the name \"" + name + "\"; exports need two names");
    }
}

/// Reads [shots] of a job with [bodies], if it has that.
void read_scene_shots(const TomlFields& job, JobSpec& spec) {
    if (!job.has("shots")) {
        return;
    }
    if (spec.scene->rules.learn) {
        job.refuse("rules",
                   "learn lists pairs of bodies, and with [shots] bodies are tested against lines "
                   "alone; leave out learn");
    }
    spec.scene->shots = read_shots(job, spec.file, spec.query);
}

void read_job(const toml::table& table, JobSpec& spec) {
    const TomlFields job(table,
                         spec.file.string(),
                         "the job",
                         {"name",
                          "unit",
                          "a",
                          "b",
                          "bodies",
                          "poses",
                          "rules",
                          "shots",
                          "motion",
                          "query",
                          "output",
                          "cluster"});
    spec.name = job.text("name").value_or(spec.file.stem().string());
    spec.unit = job.word("unit", unit_names()).value_or(spec.unit);
    if (job.has("bodies")) {
        spec.scene = read_scene(job, spec.unit, spec.file);
        read_scene_shots(job, spec);
        PoseFileSpec file = spec.scene->poses ? spec.scene->poses->file : PoseFileSpec{};
        file.path = spec.scene->fcd ? spec.scene->fcd->path : file.path;
        spec.poses = std::move(file);
    } else {
        read_two_bodies(job, spec);
    }
    read_motion(job, spec);
    if (!spec.scene) {
        read_order(job, spec);
    }
    read_query(job, spec);
    read_output(job, spec);
    read_cluster(job, spec);
    spec.lines = lines_of(table, {"poses", "rules", "motion", "query", "output", "cluster"});
}

} // namespace

Error error_at_key(const JobSpec& spec, std::string_view key, const std::string& detail) {
    const auto line = spec.lines.find(key);
    return spec.file.empty()
               ? bad_input(detail)
               : error_in_job(spec.file, line == spec.lines.end() ? 0 : line->second, detail);
}

void take_shots(ShotsSpec shots, JobSpec& spec) {
    spec.bodies[1].name = lines_name;
    spec.bodies[1].path = shots.file;
    spec.poses = std::move(shots);
}

const ShotsSpec* shots_of(const JobSpec& spec) {
    if (spec.scene) {
        return spec.scene->shots ? &*spec.scene->shots : nullptr;
    }
    return std::get_if<ShotsSpec>(&spec.poses);
}

std::string export_name(const JobSpec& spec, std::size_t body) {
    const std::string& name = spec.bodies[body].name;
    return name.empty() ? std::string(1, static_cast<char>('a' + body)) : name;
}

std::vector<BodySpec*> meshes_of(JobSpec& spec) {
    if (!spec.scene) {
        return {&spec.bodies[0], &spec.bodies[1]};
    }
    std::vector<BodySpec*> meshes;
    for (SceneBodySpec& body : spec.scene->bodies) {
        meshes.push_back(&body.mesh);
    }
    return meshes;
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
        "\" is not known; this version has text, json, csv, csv-pairs, npz, h5, vtp and glb");
}

Status check_map_formats(std::span<const std::string> formats, const MapUse& use) {
    for (const std::string& format : formats) {
        if (use.has_map() || (format != "vtp" && format != "glb")) {
            continue;
        }
        if (use.is_scene) {
            return bad_input("format " + format +
                             " shows the contact map of two bodies, which a job with [bodies] does "
                             "not have; leave it out, and draw single scenarios with `cdctl "
                             "extract --as " +
                             format + "`");
        }
        return bad_input("format " + format +
                         " shows in how many scenarios each triangle is in contact: from level "
                         "pairs on, or at level count with maps = true (--maps); run the job "
                         "so, or leave out " +
                         format);
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
