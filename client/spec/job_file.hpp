// The description of a job, from job.toml or the command line.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/poses/random_poses.hpp"
#include "common/job/query.hpp"
#include "proto/messages/cluster_options.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cd {

struct BodySpec {
    std::filesystem::path path;
    std::string unit;             ///< Unit of coordinates; empty: the file's, else the job's.
    std::string name;             ///< Empty: the file's name in messages, `export_name` in exports.
    std::string up = {};          ///< "y": turned to z up; "z" or empty: not turned.
    bool rounds_to_float = false; ///< Round coordinates to floats.
    /// The unit declared in the file if the job gives none; set when the file is read.
    std::string declared_unit = {};
};

/// Poses in a file. The path "-" means standard input.
struct PoseFileSpec {
    std::filesystem::path path;
    std::string quat_order;                ///< "xyzw", "wxyz", or empty if columns have names.
    bool of_both_bodies = false;           ///< False: the poses are B's in A's frame.
    std::optional<double> rigid_tolerance; ///< As for `check_rows`; nothing: the default.
    double length_factor = 1;              ///< Factor from the file's unit to the job's.
    std::string unit = {};                 ///< Unit of translations; empty: the job's.
};

/// Poses on a grid, both as tested and as written in the job.
struct GridSpec {
    Grid grid;
    /// Axes x, y, z, then roll, pitch, yaw in degrees; empty if unknown.
    std::vector<GridAxis> axes = {};
    std::string unit = {}; ///< Unit of the first three axes; empty: the job's.
};

using PosesSpec = std::variant<PoseFileSpec, GridSpec, RandomPoses>;

/// Excludes the triangle pairs whose parts match the patterns `a` (for A) and `b` (for B). Patterns
/// use shell wildcards; the body's name and a slash may precede the part's name, and a backslash
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
    Level level = Level::Pairs;
    double tolerance = 0; ///< Tolerance in the job's unit.
    std::uint64_t limit_pairs = 0;
    bool maps = false;
    std::vector<IgnoreRule> ignore;
    OutputSpec output;
    ClusterOptions cluster;
    std::filesystem::path file; ///< The job file, or empty.
};

/// Reads and checks a job file. Relative paths are relative to the file's folder. Errors: NotFound,
/// Io; BadInput naming the file, line and key, and for an unknown word the nearest known one.
[[nodiscard]] Result<JobSpec> read_job_file(const std::filesystem::path& path);

/// Parses the text of a job file; `path` is for messages and for relative paths.
[[nodiscard]] Result<JobSpec> parse_job(std::string_view text, const std::filesystem::path& path);

/// The name of a body in exports: its name in the job, else "a" or "b".
[[nodiscard]] std::string export_name(const JobSpec& spec, std::size_t body);

/// Refuses given distribution depths if the tolerance is above 0: then the meshes fix the depths.
/// Errors: BadInput.
[[nodiscard]] Status check_depths(const JobSpec& spec);

/// Refuses options that the strategy would ignore. Errors: BadInput.
[[nodiscard]] Status check_matching(const ClusterOptions& options);

/// Parses a distribution depth: a number, or "auto" (nothing). Errors: BadInput.
[[nodiscard]] Result<std::optional<std::uint32_t>> parse_depth(std::string_view text);

/// Refuses maps at `level any`. Errors: BadInput.
[[nodiscard]] Status check_maps(const JobSpec& spec);

/// True if the range of penetrations is within 0 to 1.
[[nodiscard]] bool is_penetration(const RandomPoses& random);

/// Removes repeated formats.
void keep_each_once(std::vector<std::string>& formats);

/// Refuses unknown formats. Errors: BadInput naming the known formats.
[[nodiscard]] Status check_format(std::string_view format);

} // namespace cd
