// Poses written as text: CSV with named columns, and TUM trajectories.
#pragma once

#include "client/poses/pose_rows.hpp"

#include <istream>

namespace cd {

/// CSV: the first line names the columns, in any order: `x,y,z,qx,qy,qz,qw`, or `m00` to `m23` (row
/// and column), or any of `x`, `y`, `z`, and of `roll_deg`, `pitch_deg`, `yaw_deg` or `roll_rad`,
/// `pitch_rad`, `yaw_rad`, where a missing number is 0. `id` and `t` (a number) become the labels;
/// ids are integers where all of them are, else texts. `time` and `name` are passed over. With
/// `of_both_bodies` also `scenario` (from 0) and `body` (a, b, 0 or 1), each pair once; the labels
/// are those of the rows of a. Blank lines and lines that begin with '#' are passed over. Errors:
/// BadInput naming the line.
[[nodiscard]] Result<PoseTable> read_csv_poses(std::istream& in, bool of_both_bodies);

/// TUM: `time x y z qx qy qz qw` a line, blanks between; the times become labels. Errors: BadInput
/// naming the line.
[[nodiscard]] Result<PoseTable> read_tum_poses(std::istream& in);

} // namespace cd
