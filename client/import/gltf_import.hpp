// Reads glTF 2.0 files and GLBs.
#pragma once

#include "client/import/imported_mesh.hpp"

#include <string_view>

namespace cd {

/// The triangles of the scene that the file names, or of its first: nodes depth first, each node's
/// instances (EXT_mesh_gpu_instancing), each primitive of its mesh. A node's primitive is a part;
/// one of several is named after the mesh with "-0", "-1" ..., a single one after the node.
///
/// Positions may be floats, or integers as KHR_mesh_quantization has them. Morph targets count
/// where their weights are zero, so that the shape is the mesh's own; other weights, and skins, are
/// refused, since no rigid body follows from them. Numbers of transforms are floats, as accessors
/// have them; positions are placed in double and rounded once to float.
///
/// Errors: BadInput naming the file and the object in it (mesh, primitive, index, node, accessor),
/// for what is damaged, not known, or compressed.
[[nodiscard]] Result<ImportedMesh> read_gltf(const MeshSource& source);

/// True for a GLB whatever its name, and for text with the name of a glTF file.
[[nodiscard]] bool is_gltf(std::string_view bytes, std::string_view lower_extension);

} // namespace cd
