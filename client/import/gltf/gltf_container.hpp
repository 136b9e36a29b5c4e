// Splits a glTF file into JSON and binary chunk (glTF 2.0, section 4).
#pragma once

#include "common/core/result.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace cd {

/// The parts of a file; refers to the file's bytes.
struct GltfContainer {
    std::string_view json;
    std::optional<std::span<const std::byte>> chunk; ///< The binary chunk of a GLB.
};

[[nodiscard]] bool is_glb(std::span<const std::byte> file);

/// Splits a file. Errors: BadInput for a GLB of another version, or with lengths that do not match
/// its bytes.
[[nodiscard]] Result<GltfContainer> open_gltf(std::span<const std::byte> file);

} // namespace cd
