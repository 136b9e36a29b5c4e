// A hint for poses in a wrong unit: how close they bring the bodies.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/pose_source.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Returns the minimum distance of the bodies' boxes over all poses; of motions over their keys.
/// Returns nothing if the boxes meet at a pose, if poses cannot be read, or if `stop` returns true.
[[nodiscard]] std::optional<double>
least_distance(const Mesh& a, const Mesh& b, PoseSource& poses, const StopCheck& stop = {});

/// Returns a line for the summary of a job whose boxes never meet: the minimum distance and, if it
/// is many lengths of the bodies, the question whether the poses are in millimetres. `pose` names
/// what is counted: of a motion the bodies may be nearer between its keys. Returns an
/// empty text if boxes meet. Errors: Interrupted.
[[nodiscard]] Result<std::string> nearness_hint(const Mesh& a,
                                                const Mesh& b,
                                                PoseSource& poses,
                                                const std::string& unit,
                                                std::string_view pose = "pose",
                                                const StopCheck& stop = {});

} // namespace cd
