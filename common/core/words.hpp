// Text utilities: suggestions for mistyped words, and numbers in texts.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

namespace cd {

/// Returns the known word with the smallest edit distance from `word`; nothing if that distance is
/// more than 1 and more than half the length of `word`.
[[nodiscard]] std::optional<std::string_view> nearest_word(std::string_view word,
                                                           std::span<const std::string_view> known);

/// Returns "; did you mean "x"?" for the nearest known word, or a list of the first known words.
[[nodiscard]] std::string suggestion(std::string_view word,
                                     std::span<const std::string_view> known);

/// Returns the number that makes up the whole text; nothing if the text is anything else, or if
/// `Number` cannot hold the number.
template <class Number, class... Base>
[[nodiscard]] std::optional<Number> number_in(std::string_view text, Base... base) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [behind, error] = std::from_chars(text.data(), end, number, base...);
    return error == std::errc() && behind == end ? std::optional(number) : std::nullopt;
}

/// Returns the number with digit groups: 48 212.
[[nodiscard]] std::string grouped(std::uint64_t number);

/// Returns the shortest decimal that reads back as this double.
[[nodiscard]] std::string exact_text(double value);

/// Returns the value with `digits` digits after the point.
[[nodiscard]] std::string fixed_text(double value, int digits);

/// Returns 950 as "950", 58 400 as "58.4 k", 1 200 000 as "1.2 M".
[[nodiscard]] std::string rate_text(double per_second);

/// Returns the number with a noun: "1 part", "12 parts".
[[nodiscard]] std::string counted(std::uint64_t number, std::string_view noun);

/// Quotes a CSV field as in RFC 4180 and replaces invalid UTF-8.
[[nodiscard]] std::string csv_field(std::string_view text);

} // namespace cd
