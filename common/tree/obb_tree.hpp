// The OBB tree of a mesh (paper, sections 6.1 and 6.2), laid out flat.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/topology.hpp"
#include "common/tree/wide/wide_node.hpp"

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
    std::uint32_t unused = 0; ///< So that each byte of an array of nodes has a value.

    [[nodiscard]] bool is_leaf() const { return right == 0; }
    [[nodiscard]] std::uint32_t triangle_count() const { return triangles_end - triangles_begin; }

    friend bool operator==(const ObbNode&, const ObbNode&) = default;
};
static_assert(sizeof(ObbNode) == 88);

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

/// The arrays of the tree that the paper has, which stay as they are while `owner` lives. Without
/// nodes where a tree has another form alone.
struct BinaryTree {
    std::span<const ObbNode> nodes;
    std::span<const std::uint32_t> triangle_ids;
    std::span<const Triangle> triangles; ///< In tree order.
    std::shared_ptr<const void> owner;
};

/// An immutable tree with its triangles, shared freely between threads. It has one of two forms or
/// both: the binary tree, which is cut, walked under a tolerance and asked for insides, and the
/// wide one, which other searches walk. Copies share the forms.
class ObbTree {
  public:
    /// In the binary form.
    ObbTree(std::shared_ptr<const Mesh> mesh,
            std::vector<ObbNode> nodes,
            std::vector<std::uint32_t> triangle_ids,
            Topology topology);
    /// In the forms at hand: a binary one with nodes, a wide one that is not null.
    ObbTree(std::shared_ptr<const Mesh> mesh,
            BinaryTree binary,
            std::shared_ptr<const WideTree> wide,
            Topology topology);

    [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
    [[nodiscard]] const std::shared_ptr<const Mesh>& mesh_pointer() const { return mesh_; }
    [[nodiscard]] const Topology& topology() const { return topology_; }
    [[nodiscard]] TreeView view() const;

    [[nodiscard]] bool has_binary() const { return !binary_.nodes.empty(); }
    [[nodiscard]] const BinaryTree& binary() const { return binary_; }
    /// The next are of the binary form, which is there.
    [[nodiscard]] std::span<const ObbNode> nodes() const;
    [[nodiscard]] std::span<const std::uint32_t> triangle_ids() const;
    [[nodiscard]] std::uint32_t depth() const; ///< Edges on the longest way down.

    /// Null until searches were prepared.
    [[nodiscard]] const std::shared_ptr<const WideTree>& wide() const { return wide_; }
    /// Makes the wide form of the binary one. Not while others use the tree.
    void prepare_search(ThreadPool* pool = nullptr);

    [[nodiscard]] std::uint64_t memory_bytes() const; ///< Mapped files count.

  private:
    std::shared_ptr<const Mesh> mesh_;
    BinaryTree binary_;
    std::shared_ptr<const WideTree> wide_;
    Topology topology_;
};

} // namespace cd
