// A hint for poses in a wrong unit: how close they bring the bodies.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/pose_source.hpp"

#include <optional>
#include <string>

namespace cd {

/// The minimum distance of the bodies' boxes over all poses. Nothing if the boxes meet at one pose,
/// if poses cannot be read, or if `stop` returns true.
[[nodiscard]] std::optional<double>
least_distance(const Mesh& a, const Mesh& b, PoseSource& poses, const StopCheck& stop = {});

/// A line for the summary of a job whose boxes never overlap: the minimum distance and, if that is
/// many lengths of the bodies, the question whether the poses are in millimetres. Empty if boxes
/// overlap. Errors: Interrupted.
[[nodiscard]] Result<std::string> nearness_hint(const Mesh& a,
                                                const Mesh& b,
                                                PoseSource& poses,
                                                const std::string& unit,
                                                const StopCheck& stop = {});

} // namespace cd
