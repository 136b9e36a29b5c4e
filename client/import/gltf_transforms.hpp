// Where glTF nodes and instances stand.
#pragma once

#include "client/import/gltf_document.hpp"

#include <Eigen/Core>

namespace cd {

/// What numbers of transforms are taken for. Exporters compute them as floats, as accessors have
/// them, and write more digits; so by default each is the nearest float.
enum class GltfNumbers : std::uint8_t { Floats, Doubles };

/// Maps a node's coordinates into its parent's (section 3.5.3). Computed in double. A rotation is
/// that of the quaternion whatever its length. Errors: BadInput for a quaternion of zeros.
[[nodiscard]] Result<Eigen::Matrix4d> to_parent(const GltfNode& node, GltfNumbers numbers);
[[nodiscard]] Result<Eigen::Matrix4d> to_matrix(const GltfTransform& transform,
                                                GltfNumbers numbers);

} // namespace cd
