// A job from the command line: a job file with overrides, or no file at all.
#pragma once

#include "client/spec/job_file.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// The values of options; empty if an option was not given.
struct JobOptions {
    std::string file;

    // These options replace a job file.
    std::string a;
    std::string b;
    std::string unit;
    std::string unit_a;
    std::string unit_b;
    std::string poses;
    std::string poses_unit; ///< Unit of translations; empty: the job's.
    std::string quat_order;
    bool poses_of_both = false;
    std::optional<double> rigid_tolerance;
    std::optional<std::uint64_t> random;
    std::optional<std::uint64_t> seed;
    std::vector<double> penetration;

    // These options override a job file.
    std::string name;
    std::string precision; ///< "auto" or "float", for both bodies.
    std::string level;
    std::optional<double> tolerance;
    std::optional<std::uint64_t> limit_pairs;
    bool maps = false;
    std::string out;
    std::vector<std::string> formats;
    bool exact_points = false;
    std::string strategy;
    std::string analysis;
    std::string depth_a; ///< A number, or "auto".
    std::string depth_b;
    std::optional<std::uint32_t> q;
    std::optional<std::uint32_t> v_kb;
    bool claim = false;
};

/// Refuses options about meshes and poses, which `options.file` already names. Errors: BadInput
/// naming the file.
[[nodiscard]] Status check_no_inputs(const JobOptions& options);

/// Applies the options that override a job file. Errors: BadInput naming the option.
[[nodiscard]] Status apply(const JobOptions& options, JobSpec& spec);

/// Makes a job from options. Errors: those of `read_job_file`; BadInput naming the option.
[[nodiscard]] Result<JobSpec> make_job_spec(const JobOptions& options);

} // namespace cd
