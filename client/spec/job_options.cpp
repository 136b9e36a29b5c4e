#include "client/spec/job_options.hpp"

#include "client/base/units.hpp"
#include "client/formats/output_file.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <utility>

namespace cd {

namespace {

Error usage(const std::string& what) {
    return bad_input(what);
}

bool gives_inputs(const JobOptions& options) {
    return !options.a.empty() || !options.b.empty() || !options.unit.empty() ||
           !options.unit_a.empty() || !options.unit_b.empty() || options.poses != PoseOptions();
}

Result<PosesSpec> poses_of(const PoseOptions& poses, const std::string& job_unit) {
    if (poses.file.empty() == !poses.random) {
        return usage("give the poses: either --poses FILE or --random N");
    }
    const bool has_random_option = poses.seed || !poses.penetration.empty();
    const bool has_file_option =
        !poses.unit.empty() || !poses.quat_order.empty() || poses.of_both || poses.rigid_tolerance;
    if (!poses.random) {
        if (has_random_option) {
            return usage("--seed and --penetration belong to --random");
        }
        PoseFileSpec file{poses.file, poses.quat_order, poses.of_both, poses.rigid_tolerance};
        if (poses.rigid_tolerance && !(*poses.rigid_tolerance >= 0)) {
            return usage("--rigid-tolerance is a number of at least 0");
        }
        const std::string& unit = job_unit.empty() ? JobSpec().unit : job_unit;
        if (!poses.unit.empty()) {
            file.length_factor = unit_factor(poses.unit, unit).value_or(1);
            file.unit = poses.unit;
        }
        return PosesSpec(std::move(file));
    }
    if (has_file_option) {
        return usage("--poses-unit, --quat-order, --both and --rigid-tolerance belong to --poses");
    }
    RandomPoses random;
    random.count = *poses.random;
    random.seed = poses.seed.value_or(random.seed);
    if (random.seed > std::numeric_limits<std::int64_t>::max()) {
        return usage("--seed is at most 9223372036854775807, as in a job file");
    }
    if (!poses.penetration.empty()) {
        random.penetration_min = poses.penetration.front();
        random.penetration_max = poses.penetration.back();
    }
    if (!is_penetration(random)) {
        return usage("--penetration has to be LEAST MOST with 0 <= LEAST <= MOST <= 1");
    }
    return PosesSpec(random);
}

Result<JobSpec> spec_without_file(const JobOptions& options) {
    if (options.a.empty() || options.b.empty()) {
        return usage("give a job file, or the two meshes with --a and --b");
    }
    auto poses = CD_TRY(poses_of(options.poses, options.unit));
    JobSpec spec;
    spec.bodies[0] = {options.a, options.unit_a, ""};
    spec.bodies[1] = {options.b, options.unit_b, ""};
    spec.unit = options.unit.empty() ? spec.unit : options.unit;
    spec.poses = std::move(poses);
    spec.name = spec.bodies[0].path.stem().string() + "-" + spec.bodies[1].path.stem().string();
    return spec;
}

/// A job, and whether its file has the keys for which the user may have usual values.
struct ReadJob {
    struct Written {
        bool level = false;
        bool formats = false;
    };
    JobSpec spec;
    Written written;
};

Result<ReadJob> without_file(const JobOptions& options) {
    auto spec = CD_TRY(spec_without_file(options));
    return ReadJob{std::move(spec), {}};
}

Result<ReadJob> from_file(const std::filesystem::path& path) {
    const std::string text = CD_TRY(read_file(path));
    auto spec = CD_TRY(parse_job(text, path));
    const toml::table job = toml::parse(text); // It has just been parsed without an error.
    return ReadJob{std::move(spec), {bool(job["query"]["level"]), bool(job["output"]["formats"])}};
}

template <class T>
void replace(T& value, const std::optional<T>& given) {
    value = given.value_or(value);
}

/// Replaces a length of the job's if the option is given. Errors: BadInput.
Status replace_length(const char* option,
                      const std::optional<double>& given,
                      std::optional<double>& length) {
    if (given && !is_clearance(*given)) {
        return usage(std::string(option) + " is a finite length of at least 0, in the job's unit");
    }
    length = given ? given : length;
    return Done{};
}

/// The keys of a job file, each with the option that sets it as the user wrote it.
using GivenOptions = std::map<std::string_view, std::string>;

GivenOptions given_options(const JobOptions& options) {
    GivenOptions given;
    const auto add = [&](std::string_view key, bool is_given, const std::string& option) {
        if (is_given) {
            given.emplace(key, option);
        }
    };
    const QueryOptions& query = options.query;
    add("level", !query.level.empty(), "--level " + query.level);
    add("limit_pairs",
        query.limit_pairs.has_value(),
        "--limit-pairs " + std::to_string(query.limit_pairs.value_or(0)));
    add("maps", query.maps, "--maps");
    add("clearance",
        query.clearance.has_value(),
        "--clearance " + exact_text(query.clearance.value_or(0)));
    add("up_to", query.up_to.has_value(), "--up-to " + exact_text(query.up_to.value_or(0)));
    const std::vector<std::string>& formats = options.output.formats;
    add("formats", !formats.empty(), fmt::format("--formats {}", fmt::join(formats, ",")));
    const MatchingOptions& cluster = options.cluster;
    add("strategy", !cluster.strategy.empty(), "--strategy " + cluster.strategy);
    add("q", cluster.q.has_value(), "--q " + std::to_string(cluster.q.value_or(0)));
    add("claim", cluster.claim, "--claim");
    add("depth", !cluster.depth_a.empty(), "--depth-a " + cluster.depth_a);
    add("depth", !cluster.depth_b.empty(), "--depth-b " + cluster.depth_b);
    return given;
}

/// Returns the error of keys that do not go together. It names the options that set them, and the
/// places of the others in the job file.
Error conflict_between(std::initializer_list<std::string_view> keys,
                       const std::string& reason,
                       const GivenOptions& given,
                       const JobSpec& spec) {
    std::string options;
    std::string others;
    std::optional<std::uint32_t> line;
    for (const std::string_view key : keys) {
        const auto option = given.find(key);
        const auto in_file = spec.lines.find(key);
        if (option != given.end()) {
            options += (options.empty() ? "" : " and ") + option->second;
        } else if (in_file != spec.lines.end()) {
            line = line.value_or(in_file->second);
            others += fmt::format(" and {} of {}", key, spec.file.string());
            others += in_file->second == 0 ? "" : ":" + std::to_string(in_file->second);
        }
    }
    if (options.empty()) {
        return line ? error_in_job(spec.file, *line, reason) : usage(reason);
    }
    return usage(options + others + ": " + reason);
}

Status apply(const QueryOptions& options, Query& query) {
    if (!options.level.empty() && !set_asked_level(options.level, query)) {
        return usage(fmt::format(
            "--level \"{}\" is not one of {}", options.level, fmt::join(asked_levels, ", ")));
    }
    replace(query.limit_pairs, options.limit_pairs);
    if (query.limit_pairs > std::numeric_limits<std::uint32_t>::max()) {
        return usage("--limit-pairs is at most 4294967295, as in a job file");
    }
    query.maps = query.maps || options.maps;
    CD_TRY(replace_length("--clearance", options.clearance, query.clearance));
    return replace_length("--up-to", options.up_to, query.up_to);
}

Status apply(const OutputOptions& options, OutputSpec& output) {
    output.dir = options.dir.empty() ? output.dir : std::filesystem::path(options.dir);
    if (!options.formats.empty()) {
        output.formats = options.formats;
        keep_each_once(output.formats);
    }
    output.exact_points = output.exact_points || options.exact_points;
    for (const std::string& format : output.formats) {
        CD_TRY(check_format(format));
    }
    return Done{};
}

Status apply(const MatchingOptions& options, JobSpec& spec) {
    if (!options.strategy.empty()) {
        spec.cluster.strategy = options.strategy;
    }
    if (!options.analysis.empty()) {
        const auto analysis = analysis_mode_from_text(options.analysis);
        if (!analysis) {
            return usage("--analysis \"" + options.analysis +
                         "\" is not one of auto, always, never");
        }
        spec.cluster.analysis = *analysis;
    }
    for (const auto& [body, given] :
         {std::pair(0, &options.depth_a), std::pair(1, &options.depth_b)}) {
        if (given->empty()) {
            continue;
        }
        const auto parsed = CD_TRY(parse_depth(*given));
        spec.cluster.set_depth(static_cast<std::size_t>(body), parsed);
    }
    replace(spec.cluster.q, options.q);
    replace(spec.cluster.v_kb, options.v_kb);
    spec.cluster.claim = spec.cluster.claim || options.claim;
    return Done{};
}

/// Refuses keys that do not go together once the options are applied. Errors: BadInput.
Status check_together(const GivenOptions& given, const JobSpec& spec) {
    const auto conflict = [&](std::initializer_list<std::string_view> keys, std::string_view why) {
        return conflict_between(keys, std::string(why), given, spec);
    };
    if (const auto found = conflict_in(spec.query)) {
        return conflict({found->key, found->other}, found->reason);
    }
    if (const auto found = conflict_in_scene(spec.query); spec.scene && found) {
        return conflict({found->key, found->other}, found->reason);
    }
    if (spec.scene && given.contains("depth")) {
        return conflict({"depth", "[bodies]"},
                        "distribution depths are for two bodies; leave them out for a job with "
                        "[bodies]");
    }
    const MapUse use{spec.query.level, spec.query.maps, spec.scene.has_value()};
    if (const Status formats = check_map_formats(spec.output.formats, use);
        !spec.output.dir.empty() && !formats) {
        return conflict({"formats", spec.scene ? "[bodies]" : "level"}, formats.error().detail);
    }
    if (const Status matching = check_matching(spec.cluster); !matching) {
        return conflict({"q", "claim", "strategy"}, matching.error().detail);
    }
    return Done{};
}

} // namespace

Status apply(const JobOptions& options, JobSpec& spec) {
    spec.name = options.name.empty() ? spec.name : options.name;
    for (BodySpec* body : meshes_of(spec)) {
        body->rounds_to_float =
            options.precision.empty() ? body->rounds_to_float : options.precision == "float";
    }
    CD_TRY(apply(options.query, spec.query));
    CD_TRY(apply(options.output, spec.output));
    CD_TRY(apply(options.cluster, spec));
    return check_together(given_options(options), spec);
}

Status check_no_inputs(const JobOptions& options) {
    return gives_inputs(options) ? Status(usage(options.file + " names the meshes and the poses; "
                                                               "change them there, or give none"))
                                 : Status(Done{});
}

void take_usual_formats(const std::vector<std::string>& usual,
                        const MapUse& use,
                        std::vector<std::string>& formats) {
    std::vector<std::string> usable = usual;
    std::erase_if(usable, [&](const std::string& format) {
        return !check_map_formats(std::span(&format, 1), use);
    });
    keep_each_once(usable);
    formats = usable.empty() ? formats : std::move(usable);
}

Result<JobSpec> make_job_spec(const JobOptions& options) {
    if (Status none = check_no_inputs(options); !options.file.empty() && !none) {
        return none.error();
    }
    const auto [read, written] =
        CD_TRY(options.file.empty() ? without_file(options) : from_file(options.file));
    JobSpec spec = read;
    JobOptions usual = options;
    usual.query.level =
        options.query.level.empty() && !written.level ? options.query.usual_level : "";
    if (usual.query.level.empty() || !apply(usual, spec)) {
        spec = read;
        CD_TRY(apply(options, spec));
    }
    if (options.output.formats.empty() && !written.formats) {
        take_usual_formats(options.output.usual_formats,
                           {spec.query.level, spec.query.maps, spec.scene.has_value()},
                           spec.output.formats);
    }
    return spec;
}

} // namespace cd
