// Checks and escapes foreign text before it is shown to people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cd {

/// Tests whether a text is valid UTF-8 without control characters, which could end a line or steer
/// a terminal: U+0000 to U+001F and U+007F to U+009F.
[[nodiscard]] bool is_printable(std::string_view text);
/// Tests whether a certificate's holder may have this name: printable, 1 to 64 bytes, no blank at
/// either end, which nobody would see, so that the name could pass for another.
[[nodiscard]] bool is_good_name(std::string_view name);
/// Returns the text with each unprintable byte as an escape such as \n, \t or \x1b.
[[nodiscard]] std::string escaped(std::string_view text);

/// Returns the text with U+FFFD in place of each byte that is not valid UTF-8.
[[nodiscard]] std::string valid_utf8(std::string_view text);
/// Returns the longest prefix of at most `bytes_max` bytes that does not split a character.
[[nodiscard]] std::string_view utf8_prefix(std::string_view text, std::size_t bytes_max);

} // namespace cd
