// Writes values as TOML.
#pragma once

#include <string>
#include <string_view>

namespace cd {

/// Quotes a text as a TOML string.
[[nodiscard]] std::string toml_quoted(std::string_view text);

} // namespace cd
