// One distribution root's subtree as bytes: what is streamed, cached, and named by its hash.
#pragma once

#include "common/core/bytes.hpp"
#include "common/core/hash.hpp"
#include "common/core/result.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// A subtree that stands on its own: nodes renumbered from 0, its own vertices, local indices.
class Subtree {
  public:
    Subtree(std::vector<ObbNode> nodes,
            std::vector<Vec3> vertices,
            std::vector<Triangle> triangles,
            std::vector<std::uint32_t> triangle_ids);

    /// With the wide tree, if it was made before.
    [[nodiscard]] TreeView view() const;
    /// Makes the wide tree, which searches without a tolerance need to be fast, where it is not yet
    /// made. For any number of threads at once: one of them makes it.
    void prepare_search() const;
    /// Counts a wide tree as large as they mostly are, made or not: the same at any time.
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    struct Search;

    std::vector<ObbNode> nodes_;
    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> triangle_ids_;
    std::shared_ptr<Search> search_;
};

/// The part of the tree under `node`, with each vertex that it uses once, numbered in the order of
/// first use. Vertices with equal coordinates become one.
[[nodiscard]] Subtree extract_subtree(const ObbTree& tree, std::uint32_t node);

/// The canonical, uncompressed bytes of a subtree as `extract_subtree` makes them: the same for the
/// same tree, on any host. Boxes are stored so that they decode to exactly themselves. With
/// Precision::Float every coordinate is a float.
///
///     u8 version = 1    u8 flags (1: double vertices, 2: 32-bit corners)
///     u32 nodes    u32 vertices    u32 triangles
///     columns of the nodes: center x y z (f64), axes 0-5 (f32), axes 6-8 (u32: bits less those of
///         the cross product of the first two rows), half x y z (f32)
///     of each node in preorder a varint: 0, or the number of a leaf's triangles
///     columns of the vertices: x, y, z (f32 or f64)
///     three corners of each triangle (u16 or u32): how far behind the next vertex not yet met
///     triangle ids (u32): the zigzag step from the id before
///
/// Each column, the corners and the ids stand as byte planes, lowest first, which compress better.
[[nodiscard]] Bytes encode_subtree(const Subtree& subtree, Precision precision);

/// The inverse. The bytes may be hostile: every index, range and number is checked, and nothing is
/// allocated that the bytes do not justify (at most 3 times their size). That ids are distinct and
/// boxes contain their triangles is not checked: the block's hash vouches for its origin. Errors:
/// BadFrame.
[[nodiscard]] Result<Subtree> decode_subtree(std::span<const std::byte> bytes);

} // namespace cd
