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

/// The known word with the smallest edit distance; nothing if the distance is more than half the
/// length of `word`, and more than 1.
[[nodiscard]] std::optional<std::string_view> nearest_word(std::string_view word,
                                                           std::span<const std::string_view> known);

/// "; did you mean "x"?" if a known word is near, otherwise the list of known words.
[[nodiscard]] std::string suggestion(std::string_view word,
                                     std::span<const std::string_view> known);

/// The number that makes up the whole text; nothing if the text is anything else, or if `Number`
/// cannot hold it.
template <class Number, class... Base>
[[nodiscard]] std::optional<Number> number_in(std::string_view text, Base... base) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [behind, error] = std::from_chars(text.data(), end, number, base...);
    return error == std::errc() && behind == end ? std::optional(number) : std::nullopt;
}

/// The number with digit groups: 48 212.
[[nodiscard]] std::string grouped(std::uint64_t number);

/// The shortest decimal that reads back as the same double.
[[nodiscard]] std::string exact_text(double value);

/// The value with `digits` digits after the point.
[[nodiscard]] std::string fixed_text(double value, int digits);

/// 950 /s as "950", 58 400 as "58.4 k", 1 200 000 as "1.2 M".
[[nodiscard]] std::string rate_text(double per_second);

/// "1 part", "12 parts".
[[nodiscard]] std::string counted(std::uint64_t number, std::string_view noun);

/// Quotes a CSV field as in RFC 4180 and replaces invalid UTF-8.
[[nodiscard]] std::string csv_field(std::string_view text);

} // namespace cd
