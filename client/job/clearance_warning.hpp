// A warning about clearances that are large beside the triangles.
#pragma once

#include "client/job/prepared_job.hpp"
#include "client/scene/scene_bodies.hpp"
#include "common/geometry/mesh.hpp"

#include <optional>
#include <string>

namespace cd {

/// Returns the median over a mesh's triangles of the longest edge, in the mesh's unit; of two
/// medians the larger.
[[nodiscard]] double median_edge(const Mesh& mesh);

/// Warns if a job lists near pairs and its clearance exceeds the median edge of a body: the number
/// of near pairs grows with the square of the clearance. `job` has its meshes and its query.
[[nodiscard]] std::optional<std::string> clearance_warning(const PreparedJob& job);
/// Warns likewise of a job with [bodies].
[[nodiscard]] std::optional<std::string> clearance_warning(const JobSpec& spec,
                                                           const SceneBodies& scene);

} // namespace cd
