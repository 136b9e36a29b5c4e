// Triangle blocks: the leaves of a wide tree and the input of pair tests.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Slots of a block, each for a triangle. Block k has the slots from block_size * k on; it may
/// leave the last ones unused.
inline constexpr std::uint32_t block_size = 16;

inline constexpr std::size_t block_vertices_max = 3 * std::size_t{block_size};

/// Numbers that may be read past the last vertex of all blocks.
inline constexpr std::size_t spare_numbers = 3 * block_vertices_max;

/// A triangle's corners as indices into its block's vertices; the fourth number is unused.
using BlockCorners = std::array<std::uint8_t, 4>;

/// A view of a body's triangle blocks, in the body's own coordinates. A slot's number identifies a
/// triangle.
struct TriangleBlocks {
    /// Three coordinates per vertex; the mesh's precision decides which span is used.
    /// `spare_numbers` meaningless numbers follow the last vertex, so that block_vertices_max
    /// vertices can be read from any vertex on.
    std::span<const float> floats;
    std::span<const double> doubles;
    /// First vertex of each block, then the number of vertices.
    std::span<const std::uint32_t> vertex_begin;
    std::span<const BlockCorners> corners; ///< Per slot.
    std::span<const std::uint32_t> ids;    ///< Triangle index in the mesh, per slot.
    double reach = 0;                      ///< Bounds every coordinate's magnitude.

    [[nodiscard]] Corners corners_at(std::uint32_t place) const;
    [[nodiscard]] Vec3 vertex(std::size_t number) const;
};

/// Builds and owns triangle blocks.
class TriangleBlockArrays {
  public:
    explicit TriangleBlockArrays(Precision precision);

    /// Adds a block of 1 to `block_size` triangles, which index `vertices`, with their ids (indices
    /// in the mesh). With Precision::Float all vertices must be floats. Returns the block's number.
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
