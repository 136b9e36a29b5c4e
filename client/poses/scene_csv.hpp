// Poses of a scene's bodies, written as CSV.
#pragma once

#include "client/poses/pose_rows.hpp"

#include <istream>

namespace cd {

/// Reads CSV with a row for each body at each step, in any order. The first line names the columns:
/// `step` (from 0), `body` (a name), those of a pose as for `read_csv_poses`, and optionally `t`,
/// the time of the step, which is equal in all rows of a step and rises from step to step.
/// Velocities become rates, as for `read_csv_poses`. `time` and `name` are ignored.
///
/// Returns a row for each step, with a pose of each body that the file names, in the order of their
/// first lines. The times become labels. With `nan_is_absent` all numbers of a pose may be NaN.
/// Errors: BadInput naming the line, or the step and the body whose row is missing; Io if reading
/// fails.
[[nodiscard]] Result<PoseTable> read_scene_csv(std::istream& in, bool nan_is_absent);

} // namespace cd
