// What a reader has found, as bytes between two processes of one program.
#pragma once

#include "client/import/imported_mesh.hpp"
#include "common/core/bytes.hpp"

#include <optional>

namespace cd {

[[nodiscard]] Bytes to_bytes(const Result<ImportedMesh>& imported);

/// The inverse. Nothing for bytes that are not whole.
[[nodiscard]] std::optional<Result<ImportedMesh>>
imported_from_bytes(std::span<const std::byte> bytes);

} // namespace cd
