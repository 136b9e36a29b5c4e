// Texts from others, before people see them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cd {

/// Valid UTF-8, and without anything that ends a line or steers a terminal: control characters of
/// ASCII, and those of Unicode's second block (U+0080 to U+009F).
[[nodiscard]] bool is_printable(std::string_view text);
/// Of a holder of a certificate: printable, 1 to 64 bytes. No blank begins or ends it, which nobody
/// would see: so it could pass for another's.
[[nodiscard]] bool is_good_name(std::string_view name);
/// With what is not printable as \n, \t or \x1b in its place.
[[nodiscard]] std::string escaped(std::string_view text);

/// The text with U+FFFD in place of each byte that is not valid UTF-8.
[[nodiscard]] std::string valid_utf8(std::string_view text);
/// The longest prefix of at most `bytes_max` bytes that ends at the end of a character.
[[nodiscard]] std::string_view utf8_prefix(std::string_view text, std::size_t bytes_max);

} // namespace cd
