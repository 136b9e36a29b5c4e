// Checks and escapes foreign text before it is shown to people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cd {

/// Tests for valid UTF-8 without control characters: those of ASCII, which end lines or steer a
/// terminal, and C1 (U+0080 to U+009F).
[[nodiscard]] bool is_printable(std::string_view text);
/// Tests the name of a certificate's holder: printable, 1 to 64 bytes. Leading or trailing blanks
/// are refused: they are invisible, so the name could pass for another.
[[nodiscard]] bool is_good_name(std::string_view name);
/// Writes each unprintable byte as an escape such as \n, \t or \x1b.
[[nodiscard]] std::string escaped(std::string_view text);

/// Replaces each byte that is not valid UTF-8 by U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);
/// Returns the longest prefix of at most `bytes_max` bytes that splits no character.
[[nodiscard]] std::string_view utf8_prefix(std::string_view text, std::size_t bytes_max);

} // namespace cd
