// Recognises CAD models and archives, which people pass in place of meshes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Says what a CAD model or an archive is and what the user should do with it; returns nothing for
/// a file that may be a mesh. `extension` is in lower case, with its dot.
[[nodiscard]] std::optional<std::string> foreign_format(std::string_view extension,
                                                        std::string_view first_bytes);

} // namespace cd
