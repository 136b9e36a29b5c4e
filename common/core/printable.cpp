#include "common/core/printable.hpp"

#include "common/core/limits/wire.hpp"

#include <cstddef>

namespace cd {

namespace {

struct Character {
    std::size_t bytes = 1;
    bool is_printable = false;
    bool is_valid = true;
};

/// Decodes the first character of a non-empty text. Each byte of invalid UTF-8 counts as one
/// character. Overlong forms, surrogates and values above U+10FFFF are invalid (RFC 3629).
Character first_of(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) {
        return {1, first >= 0x20 && first != 0x7f};
    }
    const std::size_t bytes = first < 0xc2 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    constexpr Character stray{1, false, false};
    if (bytes == 1 || first > 0xf4 || bytes > text.size()) {
        return stray;
    }
    unsigned point = first & (0xffU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0U) != 0x80) {
            return stray;
        }
        point = point << 6 | (byte(i) & 0x3fU);
    }
    const bool is_valid = bytes == 2 ||
                          (bytes == 3 && point >= 0x800 && (point < 0xd800 || point > 0xdfff)) ||
                          (bytes == 4 && point >= 0x10000 && point <= 0x10ffff);
    return is_valid ? Character{bytes, point >= 0xa0} : stray;
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
    while (!text.empty()) {
        const Character character = first_of(text);
        if (!character.is_printable) {
            return false;
        }
        text.remove_prefix(character.bytes);
    }
    return true;
}

bool is_good_name(std::string_view name) {
    return !name.empty() && name.size() <= limits::certified_name_bytes_max && is_printable(name) &&
           name.front() != ' ' && name.back() != ' ';
}

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Character character = first_of(text);
        for (const char byte : text.substr(0, character.bytes)) {
            if (character.is_printable) {
                out += byte;
            } else {
                append_escaped(out, byte);
            }
        }
        text.remove_prefix(character.bytes);
    }
    return out;
}

std::string valid_utf8(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Character character = first_of(text);
        out += character.is_valid ? text.substr(0, character.bytes) : "\xEF\xBF\xBD";
        text.remove_prefix(character.bytes);
    }
    return out;
}

std::string_view utf8_prefix(std::string_view text, std::size_t bytes_max) {
    std::size_t bytes = 0;
    while (bytes < text.size()) {
        const std::size_t next = bytes + first_of(text.substr(bytes)).bytes;
        if (next > bytes_max) {
            break;
        }
        bytes = next;
    }
    return text.substr(0, bytes);
}

} // namespace cd
