#include "client/import/gltf/gltf_buffers.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cd {

namespace {

std::array<int, 256> make_digits() {
    constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<int, 256> digits{};
    digits.fill(-1);
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        digits[static_cast<unsigned char>(alphabet[i])] = static_cast<int>(i);
    }
    return digits;
}

/// Decodes base64 (RFC 4648, section 4), also without padding; nothing for damaged text.
std::optional<Bytes> decode_base64(std::string_view text) {
    static const std::array<int, 256> digits = make_digits();
    while (text.ends_with('=')) {
        text.remove_suffix(1);
    }
    Bytes bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int digit = digits[static_cast<unsigned char>(c)];
        if (digit < 0) {
            return std::nullopt;
        }
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> count));
        }
    }
    return count == 6 ? std::nullopt : std::optional(std::move(bytes));
}

/// Replaces escapes such as %20 by their characters.
std::string without_escapes(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned value = 0;
        const char* const begin = text.data() + i + 1;
        const bool is_escape = text[i] == '%' && i + 2 < text.size() &&
                               std::from_chars(begin, begin + 2, value, 16).ptr == begin + 2 &&
                               value != 0;
        out += is_escape ? static_cast<char>(value) : text[i];
        i += is_escape ? 2 : 0;
    }
    return out;
}

/// True when letters, digits, '+', '-' and '.' precede a colon.
bool has_scheme(std::string_view uri) {
    const std::string_view scheme = uri.substr(0, uri.find(':'));
    return scheme.size() < uri.size() && !scheme.empty() &&
           std::ranges::all_of(scheme, [](unsigned char c) {
               return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
           });
}

/// Decodes `data:[type];base64,...` (RFC 2397). Errors: BadInput for anything but base64.
Result<Bytes> decode_data_uri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64")) {
        return bad_input("its data: URI is not in base64");
    }
    auto bytes = decode_base64(uri.substr(comma + 1));
    if (!bytes) {
        return bad_input("its data: URI is damaged base64");
    }
    return std::move(*bytes);
}

/// Turns a URI into the relative path of a file in the document's folder or below it. Errors:
/// BadInput for a URI with a scheme (RFC 3986), an absolute path, and a path with "..".
Result<std::filesystem::path> relative_file(std::string_view uri) {
    const std::filesystem::path path = without_escapes(uri);
    const bool goes_up = std::ranges::find(path, std::filesystem::path("..")) != path.end();
    if (uri.empty() || has_scheme(uri) || path.is_absolute() || goes_up) {
        return bad_input("its uri is '" + std::string(uri) +
                         "'; only files beside this one or in folders below are opened");
    }
    return path;
}

} // namespace

Result<std::span<const std::byte>> GltfBuffers::open_uri(const std::string& uri,
                                                         const std::filesystem::path& folder) {
    if (uri.starts_with("data:")) {
        auto bytes = CD_TRY(decode_data_uri(uri));
        return std::span<const std::byte>(decoded_.emplace_back(std::move(bytes)));
    }
    const auto name = CD_TRY(relative_file(uri));
    const auto file = DiskFile::open(folder / name);
    if (!file) {
        return bad_input(file.error().detail);
    }
    auto mapping = CD_TRY(file.value().map());
    return files_.emplace_back(std::move(mapping)).bytes();
}

Result<GltfBuffers> GltfBuffers::load(const std::vector<GltfBuffer>& buffers,
                                      const std::optional<std::span<const std::byte>>& chunk,
                                      const std::filesystem::path& folder) {
    GltfBuffers loaded;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const GltfBuffer& buffer = buffers[i];
        const std::string place = "buffer " + std::to_string(i) + ": ";
        if (!buffer.uri && (i != 0 || !chunk)) {
            return bad_input(place + "it has no bytes: neither a uri nor a chunk of a GLB");
        }
        const auto bytes = CD_TRY(within(
            place, buffer.uri ? loaded.open_uri(*buffer.uri, folder) : Result(chunk.value())));
        if (bytes.size() < buffer.bytes) {
            return bad_input(place + "it counts " + std::to_string(buffer.bytes) + " bytes, and " +
                             std::to_string(bytes.size()) + " are there");
        }
        loaded.bytes_.push_back(bytes.first(buffer.bytes));
    }
    return loaded;
}

std::uint64_t GltfBuffers::size() const {
    std::uint64_t size = 0;
    for (const auto& bytes : bytes_) {
        size += bytes.size();
    }
    return size;
}

} // namespace cd
