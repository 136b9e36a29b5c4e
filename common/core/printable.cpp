#include "common/core/printable.hpp"

#include <algorithm>
#include <cstddef>

namespace cd {

namespace {

/// Bytes of the control character that the text begins with; 0: it begins with something else.
std::size_t control_bytes(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    if (first < 0x20 || first == 0x7f) {
        return 1;
    }
    const bool is_second_block =
        first == 0xc2 && text.size() > 1 && (static_cast<unsigned char>(text[1]) & 0xe0) == 0x80;
    return is_second_block ? 2 : 0;
}

void append_escaped(std::string& out, char character) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto value = static_cast<unsigned char>(character);
    if (character == '\n') {
        out += "\\n";
    } else if (character == '\t') {
        out += "\\t";
    } else {
        out += "\\x";
        out += digits[value / 16];
        out += digits[value % 16];
    }
}

} // namespace

bool is_printable(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (control_bytes(text.substr(i)) != 0) {
            return false;
        }
    }
    return true;
}

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = control_bytes(text);
        for (const char character : text.substr(0, bytes)) {
            append_escaped(out, character);
        }
        if (bytes == 0) {
            out += text[0];
        }
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return out;
}

} // namespace cd
