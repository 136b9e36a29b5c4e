// Recognises CAD models and archives, which people pass in place of meshes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Describes a CAD model or an archive and says what to do with it; nothing for a file that may be
/// a mesh. `extension` is in lower case, with its dot.
[[nodiscard]] std::optional<std::string> foreign_format(std::string_view extension,
                                                        std::string_view first_bytes);

} // namespace cd
