// The description of a job, as job.toml or the command line gives it.
#pragma once

#include "common/core/result.hpp"
#include "common/job/pose_source.hpp"
#include "common/job/query.hpp"
#include "proto/cluster_options.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace cd {

struct BodySpec {
    std::filesystem::path path;
    std::string unit;    ///< Of the file's coordinates; empty: what the file says, else the job's.
    std::string name;    ///< For people; empty: the file's name.
    std::string up = {}; ///< "y" is turned to z; "z" and empty: taken as it is.
    bool rounds_to_float = false; ///< Coordinates become floats where the file has more digits.
    /// What the file says, where the job says none; known once it has been read.
    std::string declared_unit = {};
};

/// Poses that stand in a file; "-" is standard input.
struct PoseFileSpec {
    std::filesystem::path path;
    std::string quat_order;      ///< "xyzw", "wxyz", or empty where the file itself says.
    bool of_both_bodies = false; ///< Otherwise the poses are B's in A's frame.
    std::optional<double> rigid_tolerance;
    double length_factor = 1; ///< From the unit of the file's translations to the job's.
    std::string unit = {};    ///< Of the file's translations; empty: the job's.
};

/// Poses on a grid, as they are tested and as the job says them.
struct GridSpec {
    Grid grid;
    /// x, y, z, then roll, pitch, yaw in degrees; empty where that is not known.
    std::vector<GridAxis> axes = {};
    std::string unit = {}; ///< Of the first three axes; empty: the job's.
};

using PosesSpec = std::variant<PoseFileSpec, GridSpec, RandomPoses>;

/// Part names of A and of B, each with the wildcards of a shell: their pairs are passed over. The
/// body's name and a slash may stand before the part's; a backslash takes the meaning of / * ? [.
struct IgnoreRule {
    std::string a;
    std::string b;
    std::uint32_t line = 0; ///< In the job file; 0 where there is none.
};

struct OutputSpec {
    std::filesystem::path dir;                      ///< Empty: results are not kept.
    std::vector<std::string> formats{"csv", "npz"}; ///< Each once.
    bool exact_points = false; ///< NPZ: points with all their bits beside those in the world.
};

struct JobSpec {
    std::string name;
    std::string unit = "m";
    std::array<BodySpec, 2> bodies;
    PosesSpec poses = RandomPoses{};
    Level level = Level::Pairs;
    double tolerance = 0; ///< In the job's unit.
    std::uint64_t limit_pairs = 0;
    bool maps = false;
    std::vector<IgnoreRule> ignore;
    OutputSpec output;
    ClusterOptions cluster;
    std::filesystem::path file; ///< The job file; empty where there is none.
};

/// Reads and checks a job file. Relative paths in it are relative to the folder that it stands in.
/// Errors: NotFound, Io; BadInput naming the file, the line, the key, and for a word that is not
/// known the nearest that is.
[[nodiscard]] Result<JobSpec> read_job_file(const std::filesystem::path& path);

/// The same on text; `path` is for messages and for relative paths.
[[nodiscard]] Result<JobSpec> parse_job(std::string_view text, const std::filesystem::path& path);

/// The name of a body in exports: what the job calls it, else "a" or "b".
[[nodiscard]] std::string export_name(const JobSpec& spec, std::size_t body);

/// A tolerance above 0 fixes the distribution depths, so none may be given beside it. Errors:
/// BadInput.
[[nodiscard]] Status check_depths(const JobSpec& spec);

/// What the strategy would not look at may not be given. Errors: BadInput.
[[nodiscard]] Status check_matching(const ClusterOptions& options);

/// Of a distribution depth: a number, or "auto", which is nothing. Errors: BadInput.
[[nodiscard]] Result<std::optional<std::uint32_t>> parse_depth(std::string_view text);

/// Maps go with every level but any. Errors: BadInput.
[[nodiscard]] Status check_maps(const JobSpec& spec);

/// Leaves out each format that stands there already.
void keep_each_once(std::vector<std::string>& formats);

/// Errors: BadInput naming the formats that exist.
[[nodiscard]] Status check_format(std::string_view format);

} // namespace cd
