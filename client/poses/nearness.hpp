// A hint for poses in a wrong unit: how close they bring the bodies.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/pose_source.hpp"

#include <optional>
#include <string>

namespace cd {

/// Returns the minimum distance of the bodies' boxes over all poses. Returns nothing if the boxes
/// meet at a pose, if poses cannot be read, or if `stop` returns true.
[[nodiscard]] std::optional<double>
least_distance(const Mesh& a, const Mesh& b, PoseSource& poses, const StopCheck& stop = {});

/// Returns a line for the summary of a job whose boxes never meet: the minimum distance and, if it
/// is many lengths of the bodies, the question whether the poses are in millimetres. Returns an
/// empty text if boxes meet. Errors: Interrupted.
[[nodiscard]] Result<std::string> nearness_hint(const Mesh& a,
                                                const Mesh& b,
                                                PoseSource& poses,
                                                const std::string& unit,
                                                const StopCheck& stop = {});

} // namespace cd
