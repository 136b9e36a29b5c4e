// Reads STL files.
#pragma once

#include "client/import/imported_mesh.hpp"

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

} // namespace cd
