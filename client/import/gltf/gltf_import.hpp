// Reads glTF 2.0 files and GLBs.
#pragma once

#include "client/import/imported_mesh.hpp"

#include <string_view>

namespace cd {

/// The triangles of the file's default scene, or else its first: nodes depth first, for each node
/// its instances (EXT_mesh_gpu_instancing), for each instance the primitives of the mesh. A
/// primitive of a node is a part. A single primitive is named after the node, one of several after
/// the mesh with "-0", "-1" and so on.
///
/// Positions may be floats, or integers with KHR_mesh_quantization. Morph targets whose weights are
/// all zero are ignored; other weights, and skins, are refused, since the mesh would not be rigid.
/// Transforms are rounded to floats, applied in double, and each position is rounded once to float.
///
/// Errors: BadInput naming the file and the object in it (mesh, primitive, index, node, accessor),
/// for damaged, unknown or compressed content.
[[nodiscard]] Result<ImportedMesh> read_gltf(const MeshSource& source);

/// True for a GLB under any name, and for a file named .gltf or .glb.
[[nodiscard]] bool is_gltf(std::string_view bytes, std::string_view lower_extension);

} // namespace cd
