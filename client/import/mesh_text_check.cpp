#include "client/import/mesh_text_check.hpp"

#include "client/import/ac3d_text.hpp"
#include "client/import/mesh_words.hpp"
#include "common/core/hash.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <unordered_set>

namespace cd {

namespace {

Error bad(const std::filesystem::path& path, const std::string& detail) {
    return {ErrorCode::BadInput, path.string() + ": " + detail};
}

std::optional<std::int64_t> to_index(std::string_view word) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end != word.data() ? std::optional(value) : std::nullopt;
}

std::optional<Vec3> to_vertex(Words& words) {
    Vec3 vertex;
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = to_number(words.next());
        if (!number) {
            return std::nullopt;
        }
        vertex[axis] = *number;
    }
    return vertex;
}

/// A logical line of an OBJ file: a backslash at the end joins the next one.
bool next_line(std::istream& in, std::string& line, std::uint64_t& number) {
    line.clear();
    std::string piece;
    while (std::getline(in, piece)) {
        ++number;
        if (piece.ends_with('\r')) {
            piece.pop_back();
        }
        const bool goes_on = piece.ends_with('\\');
        line += goes_on ? piece.substr(0, piece.size() - 1) + " " : piece;
        if (!goes_on) {
            return true;
        }
    }
    return !line.empty();
}

Status read_obj_face(Words& words, TextMesh& mesh, const std::string& place) {
    std::uint64_t corners = 0;
    for (std::string_view word = words.next(); !word.empty() && !word.starts_with('#');
         word = words.next()) {
        const auto index = to_index(word);
        const auto count = static_cast<std::int64_t>(mesh.vertices.size());
        const std::int64_t vertex = !index ? -1 : *index < 0 ? count + *index : *index - 1;
        if (vertex < 0 || vertex >= count) {
            return Error{ErrorCode::BadInput,
                         place + ": the face names vertex " + std::string(word) + " of " +
                             std::to_string(count)};
        }
        mesh.used[static_cast<std::size_t>(vertex)] = true;
        ++corners;
    }
    mesh.triangles += corners >= 3 ? corners - 2 : 0;
    return Done{};
}

Result<TextMesh> read_obj(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    TextMesh mesh;
    std::string line;
    std::uint64_t number = 0;
    while (next_line(in, line, number)) {
        Words words(line);
        const std::string_view keyword = words.next();
        const auto place = [&] { return path.string() + ":" + std::to_string(number); };
        if (keyword == "v") {
            const auto vertex = to_vertex(words);
            if (!vertex) {
                return Error{ErrorCode::BadInput, place() + ": a vertex without three numbers"};
            }
            if (!vertex->allFinite()) {
                return Error{ErrorCode::BadInput,
                             place() + ": a vertex with a coordinate that is not finite"};
            }
            mesh.vertices.push_back(*vertex);
            mesh.vertex_lines.push_back(number);
            mesh.used.push_back(false);
        } else if (keyword == "f") {
            if (const Status status = read_obj_face(words, mesh, place()); !status) {
                return status.error();
            }
        }
    }
    return mesh;
}

/// Plain OFF: counts, vertices, faces; comments begin with '#'.
Result<TextMesh> read_off(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream in;
    std::string line;
    while (std::getline(file, line)) {
        in << line.substr(0, line.find('#')) << '\n';
    }
    std::string keyword;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::uint64_t edges = 0;
    in >> keyword >> vertices >> faces >> edges;
    if (keyword != "OFF" || !in) {
        return bad(path, "only plain OFF files are taken: 'OFF', then the counts");
    }
    TextMesh mesh;
    for (std::uint64_t i = 0; i < vertices; ++i) {
        std::array<std::string, 3> words;
        in >> words[0] >> words[1] >> words[2];
        const auto x = to_number(words[0]);
        const auto y = to_number(words[1]);
        const auto z = to_number(words[2]);
        if (!in || !x || !y || !z) {
            return bad(path,
                       "vertex " + std::to_string(i) + " of " + std::to_string(vertices) +
                           " is missing or is not three numbers");
        }
        if (!std::isfinite(*x) || !std::isfinite(*y) || !std::isfinite(*z)) {
            return bad(path,
                       "vertex " + std::to_string(i) + " has a coordinate that is not finite");
        }
        mesh.vertices.emplace_back(*x, *y, *z);
        mesh.vertex_lines.push_back(0);
        mesh.used.push_back(false);
    }
    for (std::uint64_t i = 0; i < faces; ++i) {
        std::uint64_t corners = 0;
        in >> corners;
        for (std::uint64_t k = 0; in && k < corners; ++k) {
            std::int64_t vertex = -1;
            in >> vertex;
            if (in && (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices)) {
                return bad(path,
                           "face " + std::to_string(i) + " names vertex " + std::to_string(vertex) +
                               " of " + std::to_string(vertices));
            }
            if (in) {
                mesh.used[static_cast<std::size_t>(vertex)] = true;
            }
        }
        if (!in) {
            return bad(path,
                       "face " + std::to_string(i) + " of " + std::to_string(faces) +
                           " is missing or damaged");
        }
        mesh.triangles += corners >= 3 ? corners - 2 : 0;
        std::getline(in, line); // Colours may follow.
    }
    if (in >> keyword) {
        return bad(path,
                   "goes on after the " + std::to_string(faces) +
                       " faces that its first line counts");
    }
    return mesh;
}

/// A PLY file in text has a line for each element.
Status check_ply_lines(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string line;
    bool is_text = false;
    std::uint64_t wanted = 0;
    while (std::getline(in, line)) {
        Words words(line);
        const std::string_view keyword = words.next();
        const std::string_view second = words.next();
        if (keyword == "format") {
            is_text = second == "ascii";
        } else if (keyword == "element") {
            const auto count = to_index(words.next());
            wanted += count && *count > 0 ? static_cast<std::uint64_t>(*count) : 0;
        } else if (keyword == "end_header") {
            break;
        }
    }
    std::uint64_t lines = 0;
    while (is_text && std::getline(in, line)) {
        lines += Words(line).next().empty() ? 0u : 1u;
    }
    if (is_text && lines < wanted) {
        return bad(path,
                   "is cut short: its header counts " + std::to_string(wanted) +
                       " lines of elements, and there are " + std::to_string(lines));
    }
    return Done{};
}

/// The importer does not always round a decimal to the nearest float: it may be some steps off, and
/// the unit's factor is applied to that. So positions are looked up by cells of eight floats.
constexpr int cell_bits = 3;
constexpr std::int32_t steps_off_max = 4;

using Cell = std::array<std::int32_t, 3>;

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        return static_cast<std::size_t>(checksum(std::as_bytes(std::span(cell))));
    }
};

using Cells = std::unordered_set<Cell, CellHash>;

/// Numbers the floats in their order, both zeros as 0.
std::int32_t float_number(double value) {
    const auto bits = std::bit_cast<std::int32_t>(static_cast<float>(value));
    return bits < 0 ? -(bits & std::numeric_limits<std::int32_t>::max()) : bits;
}

/// True when a position within some float steps of the given one is in the cells.
bool has_nearby(const Cells& cells, const Vec3& wanted) {
    for (int choice = 0; choice < 8; ++choice) {
        Cell cell{};
        for (int axis = 0; axis < 3; ++axis) {
            const std::int32_t off = (choice >> axis & 1) != 0 ? steps_off_max : -steps_off_max;
            cell[static_cast<std::size_t>(axis)] = (float_number(wanted[axis]) + off) >> cell_bits;
        }
        if (cells.contains(cell)) {
            return true;
        }
    }
    return false;
}

} // namespace

Status check_against_text(const std::filesystem::path& path,
                          const TextMesh& text,
                          const ImportOptions& options,
                          const Mesh& mesh) {
    if (text.triangles != mesh.triangles().size()) {
        return bad(path,
                   "the file's faces make " + std::to_string(text.triangles) +
                       " triangles, but the importer took " +
                       std::to_string(mesh.triangles().size()));
    }
    Cells cells;
    cells.reserve(mesh.vertices().size());
    for (const Vec3& vertex : mesh.vertices()) {
        cells.insert({float_number(vertex.x()) >> cell_bits,
                      float_number(vertex.y()) >> cell_bits,
                      float_number(vertex.z()) >> cell_bits});
    }
    for (std::size_t i = 0; i < text.vertices.size(); ++i) {
        if (text.used[i] && !has_nearby(cells, options.unit_factor * text.vertices[i])) {
            const std::uint64_t line = text.vertex_lines[i];
            return bad(path,
                       "the importer did not take vertex " + std::to_string(i) +
                           (line != 0 ? " (line " + std::to_string(line) + ")" : "") +
                           "; write three numbers, and 0.25 for .25");
        }
    }
    return Done{};
}

Result<std::optional<TextMesh>> read_text_mesh(const std::filesystem::path& path,
                                               const std::string& lower_extension) {
    if (lower_extension == ".ply") {
        const Status whole = check_ply_lines(path);
        return whole ? Result(std::optional<TextMesh>()) : whole.error();
    }
    const bool is_obj = lower_extension == ".obj";
    const bool is_off = lower_extension == ".off";
    if (!is_obj && !is_off && !is_ac3d(path, lower_extension)) {
        return std::optional<TextMesh>();
    }
    auto text = is_obj ? read_obj(path) : is_off ? read_off(path) : read_ac3d(path);
    if (!text) {
        return text.error();
    }
    return std::optional(std::move(text.value()));
}

} // namespace cd
