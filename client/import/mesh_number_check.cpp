#include "client/import/mesh_number_check.hpp"

#include "client/import/collada_check.hpp"
#include "client/import/mesh_words.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

namespace cd {

namespace {

Error bad(const std::filesystem::path& path, std::uint64_t line, const std::string& detail) {
    return {ErrorCode::BadInput, path.string() + ":" + std::to_string(line) + ": " + detail};
}

/// What is not finite passes: the importer knows it, and its face is named then.
bool is_number(std::string_view word) {
    return to_number(word).has_value();
}

Error no_number(const std::filesystem::path& path, std::uint64_t line, const std::string& word) {
    return bad(path, line, "a vertex whose coordinate '" + word + "' is not a number");
}

/// Of a binary STL file its size follows from its count.
bool is_binary_stl(const std::filesystem::path& path) {
    constexpr std::uint64_t header = 80;
    constexpr std::uint64_t bytes_per_triangle = 50;
    std::ifstream in(path, std::ios::binary);
    std::array<char, header + 4> begin{};
    if (!in.read(begin.data(), begin.size())) {
        return false;
    }
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        count |= std::uint64_t{static_cast<unsigned char>(begin[header + i])} << (8 * i);
    }
    std::error_code error;
    return std::filesystem::file_size(path, error) == begin.size() + bytes_per_triangle * count;
}

/// The first coordinate of a line that is not a number. `wanted` are the coordinates of the last
/// "vertex" that are still to come.
std::optional<std::string> stl_fault(const std::string& line, int& wanted) {
    std::istringstream words(line);
    std::string word;
    while (words >> word) {
        if (wanted > 0) {
            --wanted;
            if (!is_number(word)) {
                return word;
            }
        } else if (word == "solid" || word == "endsolid") {
            break; // A name follows.
        } else if (word == "vertex") {
            wanted = 3;
        }
    }
    return std::nullopt;
}

Status check_stl(const std::filesystem::path& path) {
    if (is_binary_stl(path)) {
        return Done{};
    }
    std::ifstream in(path, std::ios::binary);
    std::string line;
    int wanted = 0;
    for (std::uint64_t number = 1; std::getline(in, line); ++number) {
        if (const auto word = stl_fault(line, wanted)) {
            return no_number(path, number, *word);
        }
    }
    return Done{};
}

/// Where the coordinates of a PLY file in text stand.
struct PlyVertices {
    std::uint64_t lines_before = 0;
    std::uint64_t count = 0;
    std::vector<bool> is_coordinate; ///< Of each word of a vertex' line.
    bool are_described = false;      ///< By the properties that follow in the header.

    void begin_element(const std::string& name, std::uint64_t lines) {
        const bool is_before = is_coordinate.empty() && !are_described;
        are_described = name == "vertex";
        if (are_described) {
            count += lines;
        } else if (is_before) {
            lines_before += lines;
        }
    }
};

/// Nothing for a binary file, or one whose vertices hold lists. Leaves the header behind.
std::optional<PlyVertices> read_ply_header(std::istream& in, std::uint64_t& number) {
    PlyVertices vertices;
    bool is_text = false;
    std::string line;
    while (std::getline(in, line)) {
        ++number;
        std::istringstream words(line);
        std::string keyword;
        std::string second;
        std::string third;
        words >> keyword >> second >> third;
        if (keyword == "format") {
            is_text = second == "ascii";
        } else if (keyword == "element") {
            vertices.begin_element(second, to_whole(third).value_or(0));
        } else if (keyword == "property" && vertices.are_described) {
            if (second == "list") {
                return std::nullopt;
            }
            vertices.is_coordinate.push_back(third == "x" || third == "y" || third == "z");
        } else if (keyword == "end_header") {
            return is_text ? std::optional(vertices) : std::nullopt;
        }
    }
    return std::nullopt;
}

Status check_ply(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::uint64_t number = 0;
    const auto vertices = read_ply_header(in, number);
    if (!vertices) {
        return Done{};
    }
    std::string line;
    std::string word;
    std::uint64_t elements = 0; // Blank lines are none.
    while (elements < vertices->lines_before + vertices->count && std::getline(in, line)) {
        ++number;
        std::istringstream words(line);
        bool blank = true;
        for (std::size_t i = 0; words >> word; ++i) {
            blank = false;
            if (elements >= vertices->lines_before && i < vertices->is_coordinate.size() &&
                vertices->is_coordinate[i] && !is_number(word)) {
                return no_number(path, number, word);
            }
        }
        elements += blank ? 0 : 1;
    }
    return Done{};
}

/// Text as some programs print what is no number: 1.#QNAN, -1.#IND00, 1.#INF.
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

/// By which importers tell formats apart where a file's name does not.
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

Status check_numbers(const std::filesystem::path& path, const std::string& lower_extension) {
    const std::string begin = first_bytes(path);
    // Some importers look into any archive for files that they know.
    if (begin.starts_with("PK\x03\x04") && lower_extension != ".3mf") {
        return Error{ErrorCode::BadInput, path.string() + ": is an archive; unpack it"};
    }
    const bool is_binary = lower_extension == ".stl" && is_binary_stl(path);
    if (is_binary) {
        return Done{};
    }
    if (Status printed = check_printed_nan(path); !printed) {
        return printed;
    }
    if (lower_extension == ".stl") {
        return check_stl(path);
    }
    if (lower_extension == ".ply") {
        return check_ply(path);
    }
    const bool is_markup = Words(without_utf8_mark(begin)).next().starts_with('<');
    return is_markup ? check_markup(path) : Status(Done{});
}

} // namespace cd
