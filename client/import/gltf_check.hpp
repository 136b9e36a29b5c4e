// Finds what an importer would misread, or fall over, in a glTF file.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>

namespace cd {

/// The importer reads nothing of a null in a node's transform, and goes as deep as nodes are
/// nested.
///
/// Errors: BadInput naming the file and the node, for such a transform, a node that is the child of
/// two, and one that is nested deeper than limits.hpp allows.
[[nodiscard]] Status check_gltf(const std::filesystem::path& path, bool is_glb);

} // namespace cd
