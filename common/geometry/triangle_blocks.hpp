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

/// Number of slots of a block, each for one triangle. Block k has the slots from block_size * k on
/// and may leave its last slots unused.
inline constexpr std::uint32_t block_size = 16;

inline constexpr std::size_t block_vertices_max = 3 * std::size_t{block_size};

/// Count of floats or doubles that may be read past the last vertex of all blocks.
inline constexpr std::size_t spare_numbers = 3 * block_vertices_max;

/// A triangle's three corners as indices into its block's vertices; the fourth number is unused.
using BlockCorners = std::array<std::uint8_t, 4>;

/// A view of a body's triangle blocks, in the body's own coordinates. Slots are numbered across all
/// blocks.
struct TriangleBlocks {
    /// Three coordinates per vertex, in `floats` or `doubles` by the mesh's precision.
    /// `spare_numbers` meaningless numbers follow the last vertex, so that `block_vertices_max`
    /// vertices can be read from any vertex on.
    std::span<const float> floats;
    std::span<const double> doubles;
    /// Number of each block's first vertex; the last entry is the total number of vertices.
    std::span<const std::uint32_t> vertex_begin;
    std::span<const BlockCorners> corners; ///< Corners per slot.
    std::span<const std::uint32_t> ids;    ///< Triangle index in the mesh, per slot.
    double reach = 0;                      ///< Bounds the magnitude of every coordinate.

    [[nodiscard]] Corners corners_at(std::uint32_t slot) const;
    [[nodiscard]] Vec3 vertex(std::size_t number) const;
};

/// Builds and owns triangle blocks.
class TriangleBlockArrays {
  public:
    explicit TriangleBlockArrays(Precision precision);

    /// Adds a block of 1 to `block_size` triangles, which index `vertices`; `ids` are their indices
    /// in the mesh. With Precision::Float, coordinates must be floats. Returns the block's number.
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
