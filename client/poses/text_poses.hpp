// Poses written as text: CSV with named columns, and TUM trajectories.
#pragma once

#include "client/poses/pose_rows.hpp"

#include <istream>

namespace cd {

/// Reads CSV. The first line names the columns in any order: `x,y,z,qx,qy,qz,qw`, or `m00` to `m23`
/// (row and column), or some of `x`, `y`, `z`, `roll_deg`, `pitch_deg`, `yaw_deg` (or `roll_rad`,
/// `pitch_rad`, `yaw_rad`); the rest of these are 0. `id` and `t` (a number) become labels; ids
/// are integers if all of them are, else texts. `vx`, `vy`, `vz`, `ax`, `ay`, `az` and `wx`, `wy`,
/// `wz` (radians a second; or `wx_deg`, `wy_deg`, `wz_deg`) become rates, each of the three whole
/// or not at all. `time` and `name` are ignored. `of_both_bodies` requires `scenario` (from 0) and
/// `body` (a, b, 0 or 1), each pair once; labels are then taken from the rows of a. Blank lines and
/// lines that begin with '#' are ignored. Errors: BadInput naming the line; Io if reading fails.
[[nodiscard]] Result<PoseTable> read_csv_poses(std::istream& in, bool of_both_bodies);

/// Reads TUM: `time x y z qx qy qz qw` on each line, separated by blanks; times become labels.
/// Errors: BadInput naming the line; Io if reading fails.
[[nodiscard]] Result<PoseTable> read_tum_poses(std::istream& in);

} // namespace cd
