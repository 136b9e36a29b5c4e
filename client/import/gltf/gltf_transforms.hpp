// Matrices of glTF nodes and instances.
#pragma once

#include "client/import/gltf/gltf_document.hpp"

#include <Eigen/Core>

namespace cd {

/// Maps a node's coordinates into its parent's (section 3.5.3). Exporters compute transforms in
/// float but may write more digits: each number is rounded to the nearest float, and the rest is
/// computed in double. Quaternions need not have length 1. Errors: BadInput for a quaternion of
/// zeros.
[[nodiscard]] Result<Eigen::Matrix4d> to_parent(const GltfNode& node);
[[nodiscard]] Result<Eigen::Matrix4d> to_matrix(const GltfTransform& transform);

} // namespace cd
