// Poses from files: CSV with named columns, NumPy arrays, TUM trajectories, standard input.
#pragma once

#include "client/poses/pose_rows.hpp"
#include "client/spec/poses_spec.hpp"
#include "client/spec/scene_spec.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/poses/pose_source.hpp"

#include <memory>
#include <string>
#include <vector>

namespace cd {

struct OpenedPoses {
    std::unique_ptr<PoseSource> source;
    std::vector<std::string> warnings; ///< A sentence each, naming the file.
    std::vector<std::string> zeros;    ///< Columns missing in the file, which count as 0.
    PoseLabels labels;                 ///< Ids and times of all scenarios, if the file has them.
    /// How each body moves from its pose on, in the job's unit: a scenario's one, or its two, if
    /// the file has velocities.
    std::vector<PoseRates> rates;
};

/// Opens a file of poses and checks all of them, so that a run does not fail midway.
///
/// The extension decides the format: `.csv`, or `-` for CSV on standard input; `.npy` and `.npz`
/// (the array `poses`, or the only one) of shape (N,4,4), (N,3,4), (N,12) row-major, or (N,7) with
/// the translation first and `quat_order` given; `.tum` and `.txt`. With `of_both_bodies` an array
/// has a second axis of two, and a CSV file columns `scenario` and `body`. Matrices and quaternions
/// are kept as they are; Euler angles become quaternions. Large `.npy` arrays are not loaded whole.
///
/// Errors: BadInput naming the file, the line or the row (from 0) and the value, for a number that
/// is missing or not finite; a quaternion whose norm differs from 1 by more than 1e-3; a matrix
/// with max|R'R - I| > 1e-5 or det <= 0 (`rigid_tolerance` replaces 1e-3 and 1e-5). A warning
/// counts the poses off by more than 1e-9. TooLarge if memory does not suffice.
[[nodiscard]] Result<OpenedPoses> open_pose_file(const PoseFileSpec& spec);

/// Rows of poses that have all been checked.
struct OpenedTable {
    PoseTable table;
    std::vector<std::string> warnings = {}; ///< A sentence each, naming the file.
};

/// Opens a file of the poses of many bodies, with a row for each step, and checks all of them.
///
/// Formats: `.csv`, or `-` for CSV on standard input, with the columns `step`, `body` and those of
/// a pose (scene_csv.hpp); `.npy` and `.npz` with a second axis of bodies, named by `body_order`,
/// and else as for `open_pose_file`. With `nan_is_absent` a body is absent where all its numbers
/// are NaN. Errors: as `open_pose_file`; BadInput for bodies that do not fit `body_order`.
[[nodiscard]] Result<OpenedTable> open_scene_poses(const ScenePosesSpec& spec);

} // namespace cd
