#include "client/import/foreign/assimp_checks.hpp"

#include "client/import/foreign/collada_check.hpp"
#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

namespace cd {

namespace {

Error bad(const std::filesystem::path& path, std::uint64_t line, const std::string& detail) {
    return bad_input(path.string() + ":" + std::to_string(line) + ": " + detail);
}

/// Finds the first NaN or infinity as some programs print it: 1.#QNAN, -1.#IND00, 1.#INF.
std::optional<std::string_view> printed_nan(std::string_view line) {
    constexpr std::string_view begin = "1.#";
    for (std::size_t at = line.find(begin); at != line.npos; at = line.find(begin, at + 1)) {
        for (const std::string_view word : {"QNAN", "SNAN", "INF", "IND"}) {
            if (line.substr(at + begin.size()).starts_with(word)) {
                return line.substr(at, begin.size() + word.size());
            }
        }
    }
    return std::nullopt;
}

Status check_printed_nan(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string line;
    for (std::uint64_t number = 1; std::getline(in, line); ++number) {
        if (const auto word = printed_nan(line)) {
            return bad(path, number, "a number that is not finite: " + std::string(*word));
        }
    }
    return Done{};
}

/// Reads a file's first bytes, which reveal its format if its name does not.
std::string first_bytes(const std::filesystem::path& path) {
    std::array<char, 64> begin{};
    std::ifstream in(path, std::ios::binary);
    in.read(begin.data(), begin.size());
    return {begin.data(), static_cast<std::size_t>(in.gcount())};
}

Status check_markup(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    return is_collada(text) ? check_collada(path, text) : Status(Done{});
}

} // namespace

Status check_for_assimp(const std::filesystem::path& path, const std::string& lower_extension) {
    const std::string begin = first_bytes(path);
    // assimp opens any archive and reads whatever it finds in it, so archives are refused.
    if (begin.starts_with("PK\x03\x04") && lower_extension != ".3mf") {
        return bad_input(path.string() + ": is an archive; unpack it");
    }
    CD_TRY(check_printed_nan(path));
    const bool is_markup = TextReader(without_utf8_mark(begin)).word().starts_with('<');
    return is_markup ? check_markup(path) : Status(Done{});
}

} // namespace cd
