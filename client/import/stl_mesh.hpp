// Reads STL files.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Text or binary. A file is binary when its size is 84 + 50 n for the n facets that it counts,
/// even if it begins with "solid"; else it is text when its first 84 bytes begin with "solid" and
/// hold no zero byte. Facets' normals are not read.
///
/// In text each solid is a part, keywords may be in upper case, and lines between solids are
/// skipped. A binary file is one part. Bytes after its last facet are accepted with a warning where
/// they are fewer than a facet takes, or all zero.
///
/// Errors: BadInput naming the file and the line (text) or the facet and its byte (binary).
[[nodiscard]] Result<ImportedMesh> import_stl(const MeshSource& source);

} // namespace cd
