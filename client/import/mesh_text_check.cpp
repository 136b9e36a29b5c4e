#include "client/import/mesh_text_check.hpp"

#include "client/import/ac3d_text.hpp"
#include "common/core/hash.hpp"

#include <array>
#include <bit>
#include <limits>
#include <optional>
#include <span>
#include <unordered_set>

namespace cd {

namespace {

Error bad(const std::filesystem::path& path, const std::string& detail) {
    return {ErrorCode::BadInput, path.string() + ": " + detail};
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
    if (!is_ac3d(path, lower_extension)) {
        return std::optional<TextMesh>();
    }
    auto text = read_ac3d(path);
    if (!text) {
        return text.error();
    }
    return std::optional(std::move(text.value()));
}

} // namespace cd
