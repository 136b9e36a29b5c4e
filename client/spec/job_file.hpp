// The description of a job, from job.toml or the command line.
#pragma once

#include "client/spec/body_spec.hpp"
#include "client/spec/poses_spec.hpp"
#include "client/spec/scene_spec.hpp"
#include "common/core/result.hpp"
#include "common/job/query.hpp"
#include "proto/messages/cluster_options.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

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

/// The error for `chord` in a job without a curve.
inline constexpr std::string_view chord_use = "chord is for line, arc, screw and drive, and for "
                                              "files of poses with velocities; without these "
                                              "the path is straight from pose to pose";

/// Where a job is described, for errors.
struct JobSource {
    std::filesystem::path file; ///< The job file, or empty.
    /// The lines of the keys of [poses], [rules], [motion], [query], [output] and [cluster] in the
    /// job file, and of its tables, such as "[shots]"; 0 for a job that a results folder keeps.
    std::map<std::string, std::uint32_t, std::less<>> lines;
};

struct JobSpec : JobSource {
    std::string name;
    std::string unit = "m";
    std::array<BodySpec, 2> bodies; ///< Not used with `scene`.
    /// With `scene` the file of its [poses], whose path may be empty.
    PosesSpec poses = RandomPoses{};
    std::optional<SceneSpec> scene; ///< The bodies, poses and rules of a job with [bodies].
    Query query; ///< Without `Query::ignored`, which follows from `ignore` and the meshes.
    /// Of motions along a curve: how far the keys may be from it. The clearance grows by it, so
    /// that what is proven holds for the curve.
    std::optional<double> chord;
    /// Without motions: poses are inserted until nothing moves farther from one to the next.
    std::optional<double> max_step;
    std::vector<IgnoreRule> ignore;
    OutputSpec output;
    ClusterOptions cluster;
};

/// Reads and checks a job file. Relative paths in it are relative to its folder. Errors: NotFound,
/// Io; BadInput naming the file, line and key, and the nearest known word for an unknown one.
[[nodiscard]] Result<JobSpec> read_job_file(const std::filesystem::path& path);

/// Parses the text of a job file; `path` is used in messages and for relative paths.
[[nodiscard]] Result<JobSpec> parse_job(std::string_view text, const std::filesystem::path& path);

/// Returns the error BadInput "JOB:LINE: DETAIL" for a key in `JobSpec::lines`, without the line if
/// it is not known, and without the place if there is no job file.
[[nodiscard]] Error
error_at_key(const JobSpec& spec, std::string_view key, const std::string& detail);

/// Makes the lines of [shots] the job's body B, and their bundles its poses.
void take_shots(ShotsSpec shots, JobSpec& spec);

/// Returns the lines of a job, of two bodies or of a scene; null if it has none.
[[nodiscard]] const ShotsSpec* shots_of(const JobSpec& spec);

/// Returns the name of a body in exports: its name in the job, or else "a" or "b".
[[nodiscard]] std::string export_name(const JobSpec& spec, std::size_t body);

/// Returns the mesh files that a job names: those of two bodies, or of the entries of [bodies].
[[nodiscard]] std::vector<BodySpec*> meshes_of(JobSpec& spec);

/// Refuses `q` and `claim` for a strategy that ignores them. Errors: BadInput.
[[nodiscard]] Status check_matching(const ClusterOptions& options);

/// Parses a distribution depth: a number, or "auto", which gives nothing. Errors: BadInput.
[[nodiscard]] Result<std::optional<std::uint32_t>> parse_depth(std::string_view text);

/// Removes repeated formats.
void keep_each_once(std::vector<std::string>& formats);

/// Refuses an unknown format. Errors: BadInput naming the known formats.
[[nodiscard]] Status check_format(std::string_view format);

/// What decides whether a run has a contact map.
struct MapUse {
    Level level = Level::Pairs;
    bool maps = false;     ///< The query has `maps`.
    bool is_scene = false; ///< Results of many bodies have no contact map.

    [[nodiscard]] bool has_map() const { return !is_scene && (maps || level >= Level::Pairs); }
};

/// Refuses the formats vtp and glb for a job without a contact map. Errors: BadInput.
[[nodiscard]] Status check_map_formats(std::span<const std::string> formats, const MapUse& use);

} // namespace cd
