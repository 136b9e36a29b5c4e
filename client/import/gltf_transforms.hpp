// Where glTF nodes and instances stand.
#pragma once

#include "client/import/gltf_document.hpp"

#include <Eigen/Core>

namespace cd {

/// Maps a node's coordinates into its parent's (section 3.5.3). Exporters compute transforms as
/// floats, as accessors have them, and write more digits: each number is taken as the nearest
/// float, and all else is computed in double. A rotation is that of the quaternion whatever its
/// length. Errors: BadInput for a quaternion of zeros.
[[nodiscard]] Result<Eigen::Matrix4d> to_parent(const GltfNode& node);
[[nodiscard]] Result<Eigen::Matrix4d> to_matrix(const GltfTransform& transform);

} // namespace cd
