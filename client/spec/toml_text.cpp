#include "client/spec/toml_text.hpp"

#include "common/core/words.hpp"

#include <cstddef>

namespace cd {

std::string toml_quoted(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += std::string("\\") + c;
        } else if (code < 0x20 || code == 0x7f) {
            quoted += std::string("\\u00") + digits[code >> 4] + digits[code & 0xf];
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

std::string toml_number(double value) {
    constexpr std::size_t integer_digits = 15;
    const std::string text = exact_text(value);
    const bool is_whole = text.find_first_of(".e") == std::string::npos;
    return is_whole && text.size() > integer_digits ? text + ".0" : text;
}

std::string toml_line(std::string_view key, const std::string& value) {
    return std::string(key) + " = " + value + "\n";
}

} // namespace cd
