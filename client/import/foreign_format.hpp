// Files that people give for meshes and that hold none: CAD models and archives.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// What a file with this ending (lower case, with its dot) or these first bytes is, and what to do
/// with it; nothing where it may be a mesh.
[[nodiscard]] std::optional<std::string> foreign_format(std::string_view extension,
                                                        std::string_view first_bytes);

} // namespace cd
