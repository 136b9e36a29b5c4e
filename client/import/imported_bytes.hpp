// The result of an import as bytes, to pass it from a child process to its parent.
#pragma once

#include "client/import/imported_mesh.hpp"
#include "common/core/files/bytes.hpp"

#include <optional>

namespace cd {

[[nodiscard]] Bytes to_bytes(const Result<ImportedMesh>& imported);

/// The inverse of `to_bytes`. Nothing for incomplete bytes.
[[nodiscard]] std::optional<Result<ImportedMesh>>
imported_from_bytes(std::span<const std::byte> bytes);

} // namespace cd
