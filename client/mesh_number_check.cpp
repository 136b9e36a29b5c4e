#include "client/mesh_number_check.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
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
    if (word.starts_with('+')) {
        word.remove_prefix(1);
    }
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return !word.empty() && end == word.data() + word.size() &&
           error != std::errc::invalid_argument;
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

Status check_stl(const std::filesystem::path& path) {
    if (is_binary_stl(path)) {
        return Done{};
    }
    std::ifstream in(path, std::ios::binary);
    std::string line;
    std::string word;
    int wanted = 0; // Coordinates of the last "vertex" that are still to come.
    for (std::uint64_t number = 1; std::getline(in, line); ++number) {
        std::istringstream words(line);
        while (words >> word) {
            if (wanted > 0) {
                --wanted;
                if (!is_number(word)) {
                    return no_number(path, number, word);
                }
            } else if (word == "solid" || word == "endsolid") {
                break; // A name follows.
            } else if (word == "vertex") {
                wanted = 3;
            }
        }
    }
    return Done{};
}

/// Where the coordinates of a PLY file in text stand.
struct PlyVertices {
    std::uint64_t lines_before = 0;
    std::uint64_t count = 0;
    std::vector<bool> is_coordinate; ///< Of each word of a vertex' line.
};

/// Nothing for a binary file, or one whose vertices hold lists. Leaves the header behind.
std::optional<PlyVertices> read_ply_header(std::istream& in, std::uint64_t& number) {
    PlyVertices vertices;
    bool is_text = false;
    bool of_vertex = false;
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
            const bool before = vertices.is_coordinate.empty() && !of_vertex;
            of_vertex = second == "vertex";
            std::uint64_t count = 0;
            std::from_chars(third.data(), third.data() + third.size(), count);
            (of_vertex ? vertices.count : vertices.lines_before) += of_vertex || before ? count : 0;
        } else if (keyword == "property" && of_vertex) {
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

/// The JSON of a glTF file: the file itself, or the first chunk of a GLB.
std::string gltf_json(const std::filesystem::path& path, bool is_glb) {
    std::ifstream in(path, std::ios::binary);
    if (is_glb) {
        constexpr std::size_t header = 20; // Of the file, and of the first chunk.
        std::array<char, header> begin{};
        if (!in.read(begin.data(), begin.size())) {
            return {};
        }
        std::uint64_t size = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            size |= std::uint64_t{static_cast<unsigned char>(begin[12 + i])} << (8 * i);
        }
        std::error_code error;
        // Checked before the allocation: the file chooses this number.
        if (size > std::filesystem::file_size(path, error) || error) {
            return {};
        }
        std::string text(size, '\0');
        in.read(text.data(), static_cast<std::streamsize>(size));
        return text;
    }
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

Status check_gltf(const std::filesystem::path& path, bool is_glb) {
    const auto json = nlohmann::json::parse(gltf_json(path, is_glb), nullptr, false);
    if (!json.is_object() || !json.contains("nodes") || !json["nodes"].is_array()) {
        return Done{}; // The importer says what is wrong with it, if anything is.
    }
    const auto& nodes = json["nodes"];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const char* key : {"matrix", "translation", "rotation", "scale"}) {
            if (!nodes[i].is_object() || !nodes[i].contains(key)) {
                continue;
            }
            for (const auto& entry : nodes[i][key]) {
                if (!entry.is_number()) {
                    return Error{ErrorCode::BadInput,
                                 path.string() + ": node " + std::to_string(i) + ": its " + key +
                                     " holds what is not a number"};
                }
            }
        }
    }
    return Done{};
}

/// Text as some programs print what is no number: 1.#QNAN, -1.#IND00, 1.#INF.
Status check_printed_nan(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string line;
    for (std::uint64_t number = 1; std::getline(in, line); ++number) {
        for (std::size_t at = line.find("1.#"); at != std::string::npos;
             at = line.find("1.#", at + 1)) {
            const std::string_view rest = std::string_view(line).substr(at + 3);
            for (const std::string_view word : {"QNAN", "SNAN", "INF", "IND"}) {
                if (rest.starts_with(word)) {
                    return bad(
                        path, number, "a number that is not finite: 1.#" + std::string(word));
                }
            }
        }
    }
    return Done{};
}

} // namespace

Status check_numbers(const std::filesystem::path& path, const std::string& lower_extension) {
    if (lower_extension == ".glb" || lower_extension == ".gltf") {
        return check_gltf(path, lower_extension == ".glb");
    }
    const bool is_binary = lower_extension == ".stl" && is_binary_stl(path);
    if (is_binary) {
        return Done{};
    }
    if (const Status printed = check_printed_nan(path); !printed) {
        return printed;
    }
    if (lower_extension == ".stl") {
        return check_stl(path);
    }
    return lower_extension == ".ply" ? check_ply(path) : Status(Done{});
}

} // namespace cd
