// The native readers of mesh files.
#pragma once

#include "client/import/imported_mesh.hpp"

#include <filesystem>
#include <string_view>

namespace cd {

/// Reads text or binary STL. A file is binary if its size is 84 + 50 n for the facet count n in its
/// header, even if it begins with "solid"; otherwise it is text if its first 84 bytes begin with
/// "solid" and contain no zero byte. Normals of facets are ignored.
///
/// In text each solid is a part, keywords may be in upper case, and lines between solids are
/// skipped. A binary file is one part. Bytes after its last facet are accepted with a warning if
/// there are fewer than a facet has, or if all are zero.
///
/// Errors: BadInput naming the file and the line (text) or the facet and its byte (binary).
[[nodiscard]] Result<ImportedMesh> import_stl(const MeshSource& source);

/// Reads the polygons and groups of an OBJ file. A part begins at each `o`, at each `g` whose name
/// differs from the previous `g`, and at each change of material (`usemtl`). A part is named after
/// the object or group; a part that begins at a change of material is named after the group, or the
/// material if there is no group. Names may contain blanks. Points and lines are skipped and
/// counted. Normals, texture coordinates and smoothing are ignored.
///
/// Errors: BadInput naming the file and the line, also for unsupported statements: free-form curves
/// and surfaces, `call`, and keywords in upper case.
[[nodiscard]] Result<ImportedMesh> import_obj(const MeshSource& source);

/// Reads text or binary PLY in either byte order. A number in text becomes the nearest double,
/// whatever type the header gives. The file has one element `vertex` with x, y and z, followed by
/// `face`, or by `tristrips`, in which -1 separates strips. Other elements and properties are
/// ignored.
///
/// Errors: BadInput naming the file, the line (text) or byte (binary), and the vertex or face.
[[nodiscard]] Result<ImportedMesh> import_ply(const MeshSource& source);

/// Reads OFF in text form. Normals, colours and texture coordinates of vertices (NOFF, COFF, STOFF
/// and their combinations) are ignored. Each vertex and each face is on its own line; comments
/// begin with '#'.
///
/// Errors: BadInput naming the file, the line, and the vertex or face, also for binary files and
/// for vertices with other than three coordinates (4OFF, nOFF).
[[nodiscard]] Result<ImportedMesh> import_off(const MeshSource& source);

/// Reads a mesh from the arrays `vertices` (N,3) and `faces` (M,3) of an .npz file, in doubles.
/// Parts are optional. A row of `parts` (P,3; u4) holds a part's first triangle, the triangle after
/// its last, and the bytes of its name; `part_names` (u1) holds all names without separators.
///
/// Errors: BadInput naming the file and the face, vertex or part.
[[nodiscard]] Result<ImportedMesh> import_npz(const std::filesystem::path& path,
                                              const ImportOptions& options);

/// Reads the triangles of glTF 2.0 files and GLBs: of the default scene, or of the first if the
/// file names none. Nodes are read depth first; each instance of a node (EXT_mesh_gpu_instancing)
/// gives one part for each primitive of its mesh. A single primitive is named after the node, one
/// of several after the mesh with "-0", "-1" and so on.
///
/// Positions may be floats, or integers with KHR_mesh_quantization. Morph targets whose weights are
/// all zero are ignored; other weights, and skins, are refused, since the mesh would not be rigid.
/// Transforms are rounded to floats, applied in double, and each position is rounded once to float.
///
/// Errors: BadInput naming the file and the JSON object in it (mesh, primitive, index, node or
/// accessor), for damaged, unknown or compressed content.
[[nodiscard]] Result<ImportedMesh> read_gltf(const MeshSource& source);

/// True for a GLB under any name, and for a file named .gltf or .glb.
[[nodiscard]] bool is_gltf(std::string_view bytes, std::string_view lower_extension);

} // namespace cd
