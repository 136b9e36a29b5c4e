// Reads the header of a PLY file.
#pragma once

#include "client/import/imported_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cd {

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

enum class PlyFormat : std::uint8_t { Text, LittleEndian, BigEndian };

[[nodiscard]] std::size_t size_of(PlyType type);
[[nodiscard]] bool is_integer(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Int8;
    std::optional<PlyType> count_type; ///< Set for a list: the type of its length.
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0; ///< Count in the header; the data may hold fewer.
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Text;
    std::vector<PlyElement> elements;
    std::size_t data_begin = 0;  ///< Offset of the data's first byte in the file.
    std::uint64_t data_line = 1; ///< Line of the data's first byte, from 1.
};

/// Reads the header of a file. Errors: BadInput naming the file and the line, for a file that is
/// not PLY, an invalid line, and a header without `end_header`.
[[nodiscard]] Result<PlyHeader> read_ply_header(const MeshSource& source);

} // namespace cd
