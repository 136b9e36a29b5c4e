// How near the poses of a job bring its bodies: the hint for poses in another unit.
#pragma once

#include "common/core/result.hpp"
#include "common/core/stop_check.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/pose_source.hpp"

#include <optional>
#include <string>

namespace cd {

/// The least distance of the bodies' boxes over all poses; nothing as soon as one pose lets the
/// boxes meet, or where poses cannot be read, or it is stopped.
[[nodiscard]] std::optional<double>
least_distance(const Mesh& a, const Mesh& b, PoseSource& poses, const StopCheck& stop = {});

/// A line for the summary of a job whose boxes never meet: how near B comes, and where that is many
/// lengths of the bodies, whether the poses are in millimetres. Empty where boxes meet.
/// Errors: Interrupted.
[[nodiscard]] Result<std::string> nearness_hint(const Mesh& a,
                                                const Mesh& b,
                                                PoseSource& poses,
                                                const std::string& unit,
                                                const StopCheck& stop = {});

} // namespace cd
