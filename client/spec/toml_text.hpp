// Writes values as TOML.
#pragma once

#include <string>
#include <string_view>

namespace cd {

/// Quotes a text as a TOML string.
[[nodiscard]] std::string toml_quoted(std::string_view text);

/// Writes a finite number, as a float if it is too large for an integer of TOML.
[[nodiscard]] std::string toml_number(double value);

/// Writes "KEY = VALUE" as a line.
[[nodiscard]] std::string toml_line(std::string_view key, const std::string& value);

/// Writes an array; `write` makes the text of an element.
template <class Range, class Write>
[[nodiscard]] std::string toml_list(const Range& range, const Write& write) {
    std::string text;
    for (const auto& each : range) {
        text += (text.empty() ? "" : ", ") + write(each);
    }
    return "[" + text + "]";
}

} // namespace cd
