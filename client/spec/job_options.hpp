// A job from the command line: a job file with overrides, or no file at all.
#pragma once

#include "client/spec/job_file.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// Options that give the poses in place of a job file.
struct PoseOptions {
    std::string file;
    std::string unit; ///< Unit of translations; empty: the job's.
    std::string quat_order;
    bool of_both = false;
    std::optional<double> rigid_tolerance;
    std::optional<std::uint64_t> random; ///< Number of random scenarios; nothing: read `file`.
    std::optional<std::uint64_t> seed;
    std::vector<double> penetration;

    friend bool operator==(const PoseOptions&, const PoseOptions&) = default;
};

/// Options that override a job file's table [query].
struct QueryOptions {
    std::string level;
    std::optional<std::uint64_t> limit_pairs;
    bool maps = false;
    std::optional<double> clearance;
    std::optional<double> up_to;
    /// The level of a job that neither `level` nor its file gives one, if it can be asked so.
    std::string usual_level;
};

/// Options that override a job file's table [output].
struct OutputOptions {
    std::string dir;
    std::vector<std::string> formats;
    bool exact_points = false;
    /// The formats of a job that neither `formats` nor its file gives any, as far as it has them.
    std::vector<std::string> usual_formats;
};

/// Options that override a job file's table [cluster].
struct MatchingOptions {
    std::string strategy; ///< One of `strategy_names`, or empty.
    std::string analysis;
    std::string depth_a; ///< A number, or "auto".
    std::string depth_b;
    std::optional<std::uint32_t> q;
    std::optional<std::uint32_t> v_kb;
    bool claim = false;
};

/// The values of the command line's options; empty or nothing for an option not given.
struct JobOptions {
    std::string file;

    // These options replace a job file.
    std::string a;
    std::string b;
    std::string unit;
    std::string unit_a;
    std::string unit_b;
    PoseOptions poses;

    // These options override a job file.
    std::string name;
    std::string precision; ///< "auto" or "float", for both bodies.
    QueryOptions query;
    OutputOptions output;
    MatchingOptions cluster;
};

/// Refuses options that give meshes or poses, since the job file `options.file` names these.
/// Errors: BadInput naming that file.
[[nodiscard]] Status check_no_inputs(const JobOptions& options);

/// Applies to `spec` the options that override a job file. Errors: BadInput naming the option.
[[nodiscard]] Status apply(const JobOptions& options, JobSpec& spec);

/// Replaces `formats` by those of `usual` that a run with this map use can have, if there are any.
void take_usual_formats(const std::vector<std::string>& usual,
                        const MapUse& use,
                        std::vector<std::string>& formats);

/// Makes a job from options. Errors: as `read_job_file`; BadInput naming the option.
[[nodiscard]] Result<JobSpec> make_job_spec(const JobOptions& options);

} // namespace cd
