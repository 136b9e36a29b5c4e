// Small matters of text: what a mistyped word was probably meant to be, and numbers for people.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cd {

/// The known word that takes the fewest edits to reach, if it takes few for the word's length.
[[nodiscard]] std::optional<std::string_view> nearest_word(std::string_view word,
                                                           std::span<const std::string_view> known);

/// "; did you mean "x"?" where some known word is near, otherwise the list of those that exist.
[[nodiscard]] std::string suggestion(std::string_view word,
                                     std::span<const std::string_view> known);

/// With thin groups: 48 212.
[[nodiscard]] std::string grouped(std::uint64_t number);

/// The shortest decimal that reads back as the same double.
[[nodiscard]] std::string exact_text(double value);

/// With `digits` digits after the point.
[[nodiscard]] std::string fixed_text(double value, int digits);

/// 950 /s as "950", 58 400 as "58.4 k", 1 200 000 as "1.2 M".
[[nodiscard]] std::string rate_text(double per_second);

/// "1 part", "12 parts".
[[nodiscard]] std::string counted(std::uint64_t number, std::string_view noun);

} // namespace cd
