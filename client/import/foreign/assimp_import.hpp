// Reads mesh files with assimp, in a child process.
#pragma once

#include "client/import/imported_mesh.hpp"

namespace cd {

/// Reads any format that assimp reads, in a child process whose memory and time are bounded by the
/// file's size. If assimp crashes or hangs on a file, the result is an ordinary error.
///
/// Errors: BadInput naming the file, and the face if assimp reports it; Interrupted when a signal
/// or `options.is_stopped` ended the reading; Io when no child process could be started.
[[nodiscard]] Result<ImportedMesh> import_with_assimp(const std::filesystem::path& path,
                                                      const ImportOptions& options);

} // namespace cd
