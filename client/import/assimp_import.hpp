// Mesh files of the formats that have no reader of our own.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Any format that assimp reads; it reads in a process of its own, whose memory and time follow
/// from the file's size, so that a file on which assimp crashes or hangs is an error like any
/// other.
///
/// Errors: BadInput naming the file, and the face as far as assimp lets it be known; Interrupted
/// when a signal ended the reading; Io.
[[nodiscard]] Result<ImportedMesh> import_with_assimp(const std::filesystem::path& path,
                                                      const ImportOptions& options);

} // namespace cd
