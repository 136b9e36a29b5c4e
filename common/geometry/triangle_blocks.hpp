// Triangles in blocks whose corners lie together: the leaves of a wide tree, and what pair tests
// read.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The most triangles of a block. Block k has the places from block_size * k on; places that it
/// does not fill hold nothing.
inline constexpr std::uint32_t block_size = 16;

/// The most vertices of a block.
inline constexpr std::size_t block_vertices_max = 3 * std::size_t{block_size};

/// Numbers that may be read after the last vertex of all blocks.
inline constexpr std::size_t spare_numbers = 3 * block_vertices_max;

/// The corners of a triangle as places among its block's vertices, and one number that is not used.
using BlockCorners = std::array<std::uint8_t, 4>;

/// Blocks of a body's triangles in its own coordinates, wherever the arrays live. A triangle is
/// named by its place.
struct TriangleBlocks {
    /// Three coordinates a vertex, in one of these, as the mesh's precision says. After the last
    /// come `spare_numbers` that mean nothing: as many as a block can have may be read from any
    /// vertex on.
    std::span<const float> floats;
    std::span<const double> doubles;
    std::span<const std::uint32_t> vertex_begin; ///< The first vertex of each block, and the end.
    std::span<const BlockCorners> corners;       ///< Of each place.
    std::span<const std::uint32_t> ids; ///< Of each place: the triangle's place in its mesh.
    double reach = 0;                   ///< No coordinate is larger.

    [[nodiscard]] Corners corners_at(std::uint32_t place) const;
    [[nodiscard]] Vec3 vertex(std::size_t number) const;
};

/// Holds blocks, added one after the other.
class TriangleBlockArrays {
  public:
    explicit TriangleBlockArrays(Precision precision);

    /// Adds a block of 1 to `block_size` triangles, each with its id. With Precision::Float all
    /// vertices are floats. Returns the block's number.
    std::uint32_t add(std::span<const Triangle> triangles,
                      std::span<const std::uint32_t> ids,
                      std::span<const Vec3> vertices);

    [[nodiscard]] TriangleBlocks view() const;
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    void add_vertex(const Vec3& vertex);

    Precision precision_;
    std::vector<float> floats_;
    std::vector<double> doubles_;
    std::vector<std::uint32_t> vertex_begin_ = {0};
    std::vector<BlockCorners> corners_;
    std::vector<std::uint32_t> ids_;
    double reach_ = 0;
};

} // namespace cd
