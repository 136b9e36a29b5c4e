// Takes a glTF file apart: JSON as it is, or a GLB with its chunks (glTF 2.0, section 4).
#pragma once

#include "common/core/result.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace cd {

/// Parts of the file's bytes.
struct GltfContainer {
    std::string_view json;
    std::optional<std::span<const std::byte>> chunk; ///< The binary one of a GLB.
};

[[nodiscard]] bool is_glb(std::span<const std::byte> file);

/// Errors: BadInput for a GLB of another version, or whose lengths are not those of its bytes.
[[nodiscard]] Result<GltfContainer> open_gltf(std::span<const std::byte> file);

} // namespace cd
