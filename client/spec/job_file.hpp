// The description of a job, from job.toml or the command line.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "proto/messages/cluster_options.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cd {

struct BodySpec {
    std::filesystem::path path;
    std::string unit;    ///< Unit of coordinates; empty: the mesh file's, or else the job's.
    std::string name;    ///< If empty: in messages the file's name, in exports `export_name`.
    std::string up = {}; ///< "y": the file's y becomes z; "z" or empty: no turn.
    bool rounds_to_float = false; ///< Round coordinates to floats.
    /// The unit that the mesh file declares, if `unit` is empty; set when the file is read.
    std::string declared_unit = {};
};

/// Poses in a file. The path "-" means standard input.
struct PoseFileSpec {
    std::filesystem::path path;
    std::string quat_order;                ///< "xyzw", "wxyz", or empty if columns have names.
    bool of_both_bodies = false;           ///< If false, the poses are B's in A's frame.
    std::optional<double> rigid_tolerance; ///< As in `check_rows`; nothing: the default.
    double length_factor = 1;              ///< Factor from the file's unit to the job's.
    std::string unit = {};                 ///< Unit of translations; empty: the job's.
};

/// Poses on a grid: `grid` as tested, `axes` as written in the job.
struct GridSpec {
    Grid grid;
    /// The axes x, y, z, then roll, pitch, yaw in degrees; empty if unknown.
    std::vector<GridAxis> axes = {};
    std::string unit = {}; ///< Unit of the axes x, y and z; empty: the job's.
};

/// [shots] gives the poses of its bundle, and the bundle is body B.
using PosesSpec = std::variant<PoseFileSpec, GridSpec, RandomPoses, ShotsSpec>;

/// Excludes the triangle pairs whose parts match the patterns `a` (in A) and `b` (in B). Patterns
/// use shell wildcards. The body's name and a slash may precede the part's name; a backslash
/// escapes / * ? and [.
struct IgnoreRule {
    std::string a;
    std::string b;
    std::uint32_t line = 0; ///< Line in the job file; 0 without a file.
};

struct OutputSpec {
    std::filesystem::path dir;                      ///< Empty: results are not kept.
    std::vector<std::string> formats{"csv", "npz"}; ///< Distinct formats.
    bool exact_points = false;                      ///< NPZ: also points at full precision.
};

struct JobSpec {
    std::string name;
    std::string unit = "m";
    std::array<BodySpec, 2> bodies;
    PosesSpec poses = RandomPoses{};
    Query query; ///< Without `Query::ignored`, which follows from `ignore` and the meshes.
    std::vector<IgnoreRule> ignore;
    OutputSpec output;
    ClusterOptions cluster;
    std::filesystem::path file; ///< The job file, or empty.
};

/// Reads and checks a job file. Relative paths in it are relative to its folder. Errors: NotFound,
/// Io; BadInput naming the file, line and key, and the nearest known word for an unknown one.
[[nodiscard]] Result<JobSpec> read_job_file(const std::filesystem::path& path);

/// Parses the text of a job file; `path` is used in messages and for relative paths.
[[nodiscard]] Result<JobSpec> parse_job(std::string_view text, const std::filesystem::path& path);

/// Makes the lines of [shots] the job's body B, and their bundles its poses.
void take_shots(ShotsSpec shots, JobSpec& spec);

/// Returns the name of a body in exports: its name in the job, or else "a" or "b".
[[nodiscard]] std::string export_name(const JobSpec& spec, std::size_t body);

/// Refuses `q` and `claim` for a strategy that ignores them. Errors: BadInput.
[[nodiscard]] Status check_matching(const ClusterOptions& options);

/// Parses a distribution depth: a number, or "auto", which gives nothing. Errors: BadInput.
[[nodiscard]] Result<std::optional<std::uint32_t>> parse_depth(std::string_view text);

/// True if the least and most penetration are in order and within 0 to 1.
[[nodiscard]] bool is_penetration(const RandomPoses& random);

/// Removes repeated formats.
void keep_each_once(std::vector<std::string>& formats);

/// Refuses an unknown format. Errors: BadInput naming the known formats.
[[nodiscard]] Status check_format(std::string_view format);

/// Refuses the formats vtp and glb for a job without a contact map. Errors: BadInput.
[[nodiscard]] Status
check_map_formats(std::span<const std::string> formats, Level level, bool maps);

} // namespace cd
