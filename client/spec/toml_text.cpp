#include "client/spec/toml_text.hpp"

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

} // namespace cd
