// Splits a glTF file into its JSON and its binary chunk (glTF 2.0, section 4).
#pragma once

#include "common/core/result.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace cd {

/// The two parts of a glTF file; refers to the file's bytes.
struct GltfContainer {
    std::string_view json;
    std::optional<std::span<const std::byte>> chunk; ///< Set for a GLB with a binary chunk.
};

[[nodiscard]] bool is_glb(std::span<const std::byte> file);

/// Splits a file. Errors: BadInput for a GLB of a version other than 2, and for one whose lengths
/// do not match its bytes.
[[nodiscard]] Result<GltfContainer> open_gltf(std::span<const std::byte> file);

} // namespace cd
