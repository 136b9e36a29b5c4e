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

    [[nodiscard]] TreeView view() const;
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    std::vector<ObbNode> nodes_;
    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> triangle_ids_;
};

/// The part of the tree under `node`, with each vertex that it uses once.
[[nodiscard]] Subtree extract_subtree(const ObbTree& tree, std::uint32_t node);

/// The canonical, uncompressed bytes of a subtree: the same for the same tree, on any host. Boxes
/// are stored so that they decode to exactly themselves.
[[nodiscard]] Bytes encode_subtree(const Subtree& subtree, Precision precision);

/// The inverse. The bytes may be hostile: every index, range and number is checked, and nothing is
/// allocated that the bytes do not justify. Errors: BadFrame.
[[nodiscard]] Result<Subtree> decode_subtree(std::span<const std::byte> bytes);

} // namespace cd
