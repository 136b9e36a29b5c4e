// The OBB tree of a mesh (paper, sections 6.1 and 6.2), laid out flat.
#pragma once

#include "common/core/thread_pool.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/topology.hpp"
#include "common/tree/wide_node.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// A node: an oriented box that contains its triangles, always. A point x is inside when
/// |row_i . (x - center)| <= half_i for the three rows of `axes` taken as exact numbers; the rows
/// are orthonormal only within float rounding, and the box test allows for that.
///
/// Axes and centre are finite. The half sizes are positive, and infinite where coordinates are
/// beyond the floats. The centre is a double because small features far from the origin (maps)
/// would lie within one step of a float.
struct ObbNode {
    std::array<double, 3> center{};
    std::array<float, 9> axes{}; ///< Row-major: three unit directions.
    std::array<float, 3> half{};
    std::uint32_t right = 0; ///< Index of the right child; 0 for a leaf. The left child follows.
    std::uint32_t triangles_begin = 0; ///< The triangles under this node, in tree order.
    std::uint32_t triangles_end = 0;

    [[nodiscard]] bool is_leaf() const { return right == 0; }
    [[nodiscard]] std::uint32_t triangle_count() const { return triangles_end - triangles_begin; }

    friend bool operator==(const ObbNode&, const ObbNode&) = default;
};

/// What a traversal reads, wherever the arrays live: a whole tree or one subtree. Node 0 is the
/// root, children stand after their parents (preorder), and `triangles` and `triangle_ids` are in
/// tree order.
struct TreeView {
    std::span<const ObbNode> nodes;
    std::span<const Vec3> vertices;
    std::span<const Triangle> triangles;
    std::span<const std::uint32_t> triangle_ids; ///< Places in the mesh.
    WideView wide = {};                          ///< Of the same triangles; empty if not made.
};

class WideTree;

/// An immutable tree with its triangles, shared freely between threads.
class ObbTree {
  public:
    ObbTree(std::shared_ptr<const Mesh> mesh,
            std::vector<ObbNode> nodes,
            std::vector<std::uint32_t> triangle_ids,
            Topology topology);

    [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
    [[nodiscard]] const std::shared_ptr<const Mesh>& mesh_pointer() const { return mesh_; }
    [[nodiscard]] const Topology& topology() const { return topology_; }
    [[nodiscard]] std::span<const ObbNode> nodes() const { return nodes_; }
    [[nodiscard]] std::span<const std::uint32_t> triangle_ids() const { return triangle_ids_; }
    [[nodiscard]] TreeView view() const;

    /// Makes the wide tree, which searches need to be fast. Not while others use the tree.
    void prepare_search(ThreadPool* pool = nullptr);

    [[nodiscard]] std::uint32_t depth() const; ///< Edges on the longest way down.
    [[nodiscard]] std::uint64_t memory_bytes() const;

  private:
    std::shared_ptr<const Mesh> mesh_;
    std::vector<ObbNode> nodes_;
    std::vector<std::uint32_t> triangle_ids_;
    std::vector<Triangle> triangles_; ///< In tree order.
    Topology topology_;
    std::shared_ptr<const WideTree> wide_; ///< Null until searches were prepared.
};

} // namespace cd
