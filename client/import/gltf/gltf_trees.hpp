// Checks that the nodes of a glTF document form trees.
#pragma once

#include "client/import/gltf/gltf_document.hpp"

namespace cd {

/// Checks that each node has at most one parent (glTF 2.0, section 3.5.2). Otherwise a few nodes
/// could expand to 2^1000.
///
/// Errors: BadInput naming the node, for one that has two parents, is a root and a child, or is
/// nested deeper than `limits::mesh_file_depth_max`.
[[nodiscard]] Status check_gltf_trees(const GltfDocument& document);

} // namespace cd
