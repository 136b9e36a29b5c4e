// Reads poses from rows of numbers, and checks that they are rigid.
#pragma once

#include "client/curves/row_curve.hpp"
#include "client/formats/npy.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/poses/pose_source.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// The layout of the numbers of a pose.
enum class PoseLayout : std::uint8_t {
    Matrix44, ///< Row-major; the last row is 0 0 0 1.
    Matrix34, ///< Row-major.
    Xyzw,     ///< x y z qx qy qz qw
    Wxyz,     ///< x y z qw qx qy qz
};

[[nodiscard]] std::size_t numbers_of(PoseLayout layout);

/// Reads one pose. Errors: BadInput with the value, as for `open_pose_file`.
[[nodiscard]] Result<Pose> checked_pose(std::span<const double> numbers, PoseLayout layout);

/// Returns the names of the bodies of rows that have poses of both: a and b.
[[nodiscard]] std::vector<std::string> both_bodies();

/// Rows with one pose each (B's in A's frame), or with one for each of several bodies, in the
/// world.
struct PoseTable {
    std::unique_ptr<NpyRows> rows;
    PoseLayout layout = PoseLayout::Matrix44;
    std::vector<std::string> bodies = {}; ///< Names of the bodies of a row; empty: one pose, of B.
    bool from_angles = false; ///< Quaternions computed from angles; any norm is accepted.
    std::vector<std::string> zeros = {};   ///< Columns missing in the file, which count as 0.
    std::vector<std::uint64_t> lines = {}; ///< Line of each pose in a text file; else empty.
    double length_factor = 1; ///< Factor from the file's unit of translations to the job's.
    PoseLabels labels = {};   ///< Ids and times of all rows, if the file has them.
    std::string name = {};    ///< Name of the file.
    std::vector<PoseRates> rates = {}; ///< Of each pose, in the file's unit, if the file has them.
    bool nan_is_absent = false; ///< A pose of which all numbers are NaN is that of an absent body.

    [[nodiscard]] std::size_t poses_each() const { return bodies.empty() ? 1 : bodies.size(); }
};

/// Names a pose's place in its file: "line 2" in a text file, else "row 0", or "row 0, body a" if
/// rows have poses of several bodies. Poses are numbered across rows.
[[nodiscard]] std::string place_of_pose(const PoseTable& table, std::uint64_t pose);

/// What `check_rows` finds in rows that it accepts.
struct RigidityReport {
    std::uint64_t off = 0;        ///< Accepted poses that are off by more than 1e-9.
    std::uint64_t worst_pose = 0; ///< The pose that is off most, as in `place_of_pose`.
    double worst = 0;             ///< How far `worst_pose` is off.
};

/// Reads and checks all rows. Errors: BadInput naming the place and the value, as for
/// `open_pose_file`; Io.
[[nodiscard]] Result<RigidityReport> check_rows(const PoseTable& table,
                                                std::optional<double> rigid_tolerance);

/// Reads the poses of rows [first, first + count), which must exist, row by row: nothing for an
/// absent body. `check_rows` must have accepted the rows; they are checked again, since a file may
/// have changed. Errors: Io; BadInput naming the file and the place.
[[nodiscard]] Result<std::vector<std::optional<Pose>>>
poses_of_rows(const PoseTable& table, std::uint64_t first, std::uint64_t count);

/// Makes a source of the scenarios in rows, which `check_rows` must have accepted. Rows have one
/// pose, or those of both bodies.
[[nodiscard]] std::unique_ptr<PoseSource> make_table_source(PoseTable table);

} // namespace cd
