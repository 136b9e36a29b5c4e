// Makes the motions of a job from its poses: one from each pose to the next.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/motion/motion_keys.hpp"

#include <memory>
#include <string>

namespace cd {

/// The motions between consecutive poses. Scenario i leads from pose i to pose i + 1.
struct JobMotions {
    std::unique_ptr<PoseSource> poses;
    PoseLabels labels; ///< The ids of the poses at the motions' begins, and both times.
    BodyRadii moved;   ///< How far rounding has moved points of A and of B (RoundedKeys), at most.
    /// How far apart the motions between the keys and those between the given poses are, at any
    /// time, at most. It holds for poses of kind Quaternion with norm 1, within roundings, and
    /// turns of at most 90 degrees from each to the next.
    BodyRadii moved_between;
};

/// Reads all poses, rounds them as keys (motion_keys.hpp), and makes the motions between them. The
/// labels are those of the poses. `resolution` is that of the query. Errors: BadInput for fewer
/// than two poses; BadInput that begins with the pose's place (`PoseSource::place_of`) for times
/// that do not rise, and as `round_keys`; those of `poses`.
[[nodiscard]] Result<JobMotions> make_motions(
    PoseSource& poses, const PoseLabels& labels, const Mesh& a, const Mesh& b, double resolution);

/// Poses with others inserted between them, and the times of all if the given ones have times.
struct InsertedPoses {
    std::unique_ptr<PoseSource> poses;
    PoseLabels labels;
};

/// The most poses that `make_steps` makes.
inline constexpr std::uint64_t step_poses_max = 1'000'000;

/// Inserts poses on the motions between consecutive poses, until no point of one body moves farther
/// than `max_step` against the other from one pose to the next. The given poses stay as they are.
/// Errors: as `make_motions`; BadInput if rounding moves the bodies by more than 1/16 of
/// `max_step`; TooLarge for more than `step_poses_max` poses.
[[nodiscard]] Result<InsertedPoses> make_steps(
    PoseSource& poses, const PoseLabels& labels, const Mesh& a, const Mesh& b, double max_step);

/// Says by how much rounding has moved the bodies: "rounding moved the bodies by at most 2.3e-13
/// and 1.1e-12 m".
[[nodiscard]] std::string moved_text(const BodyRadii& moved, const std::string& unit);

} // namespace cd
