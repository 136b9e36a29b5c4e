// The OBB tree of a mesh (paper, sections 6.1 and 6.2) in flat arrays.
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

/// A node: an oriented box that always contains the node's triangles. A point x is inside when
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
    std::uint32_t right =
        0; ///< Index of the right child; 0 for a leaf. The left child is the next node.
    std::uint32_t triangles_begin = 0; ///< The range of triangles under this node, in tree order.
    std::uint32_t triangles_end = 0;
    std::uint32_t unused = 0; ///< Padding; defines every byte of a node in a file.

    [[nodiscard]] bool is_leaf() const { return right == 0; }
    [[nodiscard]] std::uint32_t triangle_count() const { return triangles_end - triangles_begin; }

    friend bool operator==(const ObbNode&, const ObbNode&) = default;
};
static_assert(sizeof(ObbNode) == 88);

/// A tree as a traversal reads it, either a whole tree or one subtree. Node 0 is the root, children
/// come after their parents (preorder), and `triangles` and `triangle_ids` are in tree order.
struct TreeView {
    std::span<const ObbNode> nodes;
    std::span<const Vec3> vertices;
    std::span<const Triangle> triangles;
    std::span<const std::uint32_t> triangle_ids; ///< Indices in the mesh.
    WideView wide = {}; ///< The wide tree of these triangles; empty if not made.
};

class WideTree;

/// The arrays of the paper's binary tree; the arrays do not change while `owner` lives. `nodes` is
/// empty if the tree has only the wide form.
struct BinaryTree {
    std::span<const ObbNode> nodes;
    std::span<const std::uint32_t> triangle_ids;
    std::span<const Triangle> triangles; ///< Copies of the mesh's triangles, in tree order.
    std::shared_ptr<const void> owner;
};

/// An immutable tree with its triangles, shared freely between threads. It has one or both of two
/// forms: the binary tree, which is cut and used for point-in-solid tests, and the wide tree,
/// which searches descend. Copies share the forms.
class ObbTree {
  public:
    /// Makes a tree in the binary form.
    ObbTree(std::shared_ptr<const Mesh> mesh,
            std::vector<ObbNode> nodes,
            std::vector<std::uint32_t> triangle_ids,
            Topology topology);
    /// Makes a tree of the given forms, at least one: `binary` has nodes, or `wide` is not null.
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
    /// Returns the nodes in preorder. Requires the binary form.
    [[nodiscard]] std::span<const ObbNode> nodes() const;
    /// Returns the mesh ids of the triangles in tree order. Requires the binary form.
    [[nodiscard]] std::span<const std::uint32_t> triangle_ids() const;
    /// Returns the number of edges on the longest path from the root. Requires the binary form.
    [[nodiscard]] std::uint32_t depth() const;

    /// Returns the wide form; null until `prepare_search` was called or a wide tree was given.
    [[nodiscard]] const std::shared_ptr<const WideTree>& wide() const { return wide_; }
    /// Makes the wide form from the binary one. No other thread may use the tree meanwhile.
    void prepare_search(ThreadPool* pool = nullptr);

    /// Makes the support points of the wide form, if it has nodes and no points yet. No other
    /// thread may use the tree meanwhile.
    void prepare_planes(ThreadPool* pool = nullptr);

    [[nodiscard]] std::uint64_t memory_bytes() const; ///< Counts mesh, both forms and mapped files.

  private:
    std::shared_ptr<const Mesh> mesh_;
    BinaryTree binary_;
    std::shared_ptr<const WideTree> wide_;
    Topology topology_;
};

} // namespace cd
