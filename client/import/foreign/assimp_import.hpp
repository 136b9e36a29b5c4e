// Reads mesh files in formats without a native reader here, in a child process.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads any format that assimp reads, in a child process whose memory and time are bounded by the
/// file's size. A file on which assimp crashes or hangs is therefore an ordinary error.
///
/// Errors: BadInput naming the file, and the face if assimp reports it; Interrupted when a signal
/// ended the reading; Io.
[[nodiscard]] Result<ImportedMesh> import_with_assimp(const std::filesystem::path& path,
                                                      const ImportOptions& options);

} // namespace cd
