// The poses of a job's bodies, as the job file gives them.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/curves/pose_curve.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cd {

class TomlFields;

/// The words for the order of a quaternion's numbers.
inline constexpr std::array<std::string_view, 2> quat_orders{"xyzw", "wxyz"};

/// How far the length of a quaternion may be from 1.
inline constexpr double quaternion_off_max = 1e-3;

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
using PosesSpec = std::variant<PoseFileSpec, GridSpec, RandomPoses, ShotsSpec, CurveSpec>;

/// Reads the table [poses] of a job with two bodies. `unit` is the job's, `file` the job file.
/// Throws a `Refusal`.
[[nodiscard]] PosesSpec
read_poses(const TomlFields& job, const std::string& unit, const std::filesystem::path& file);

/// Reads a curve from its line in a job file, such as "line = { ... }", with lengths in `unit` of a
/// job in `job_unit`. Errors: BadInput.
[[nodiscard]] Result<CurveSpec>
parse_curve(const std::string& text, const std::string& unit, const std::string& job_unit);

/// True if the least and most penetration are in order and within 0 to 1.
[[nodiscard]] bool is_penetration(const RandomPoses& random);

} // namespace cd
