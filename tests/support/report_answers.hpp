// Reads what a report with a viewer holds, as the page's script does.
#pragma once

#include "common/core/files/bytes.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cd::tests {

/// Unpacks one gzip member; nothing if it is damaged, or if something follows it.
inline std::optional<Bytes> gunzip(std::span<const std::byte> packed) {
    z_stream stream{};
    Bytes bytes;
    if (inflateInit2(&stream, 15 + 16) != Z_OK) {
        return std::nullopt;
    }
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    std::array<std::byte, 4096> piece{};
    int state = Z_OK;
    while (state == Z_OK) {
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        bytes.insert(bytes.end(), piece.begin(), piece.end() - stream.avail_out);
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END && stream.avail_in == 0 ? std::optional(bytes) : std::nullopt;
}

/// Decodes Base64 with padding; digits are not checked.
inline Bytes from_base64(std::string_view text) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    Bytes bytes;
    unsigned bits = 0;
    unsigned count = 0;
    for (const char digit : text.substr(0, text.find('='))) {
        bits = bits << 6 | static_cast<unsigned>(digits.find(digit));
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> count & 0xff));
        }
    }
    return bytes;
}

/// Returns the answers in a report by their paths. A path with rows left out has " (cut)" behind
/// it.
inline std::map<std::string, std::string> answers_in(std::string_view html) {
    constexpr std::string_view begin = "<template data-path=\"";
    constexpr std::string_view cut = " data-cut=\"true\"";
    std::map<std::string, std::string> answers;
    for (std::size_t at = html.find(begin); at != html.npos; at = html.find(begin, at)) {
        at += begin.size();
        std::string path(html.substr(at, html.find('"', at) - at));
        at += path.size() + 1;
        if (html.substr(at).starts_with(cut)) {
            path += " (cut)";
            at += cut.size();
        }
        const std::string_view text = html.substr(at + 1, html.find('<', at) - at - 1);
        const auto bytes = gunzip(from_base64(text));
        answers[path] =
            bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size())
                  : "damaged";
    }
    return answers;
}

} // namespace cd::tests
