// Makes the nodes of a tree during its build: their boxes and the split of their triangles.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/build/build_fit.hpp"
#include "common/tree/build/build_split.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// All threads together make a node with more triangles than this, in pieces of this size. The
/// moments of the pieces are added up in order, so the number of threads does not change the fit.
inline constexpr std::uint32_t piece_triangles_max = 4096;

/// The input that all nodes of one build share.
struct BuildInput {
    std::span<const Vec3> vertices;
    BuildOptions options;
    /// False if coordinates are too large to be measured: then every box is all of space, and a
    /// node splits into any halves.
    bool measurable = true;
};

/// A node that is still to be made.
struct NodeToMake {
    ObbNode node;                       ///< Has only its range of triangles at first.
    std::span<BuildTriangle> triangles; ///< The triangles of the range.
    std::uint32_t left_count =
        0; ///< Number of triangles of the left child, once made; 0 for a leaf.
};

/// Makes a node of at most `piece_triangles_max` triangles with the whole subtree below it. Keeps
/// scratch memory between calls.
class SubtreeMaker {
  public:
    explicit SubtreeMaker(const BuildInput& input) : input_(input) {}

    /// Returns the nodes in preorder, with indices from 0. `begin` is the tree index of the first
    /// triangle. Reorders the triangles to the order of the leaves.
    [[nodiscard]] std::vector<ObbNode> make(std::span<BuildTriangle> triangles,
                                            std::uint32_t begin);

  private:
    /// A node with the index of its left child in `nodes_`; the right child follows the left.
    struct LevelNode {
        ObbNode node;
        std::uint32_t left = 0; ///< 0 for a leaf.
    };

    [[nodiscard]] std::span<BuildTriangle> triangles_of(const ObbNode& node) const {
        return triangles_.subspan(node.triangles_begin - begin_, node.triangle_count());
    }
    void fit_level(std::size_t level_begin);
    std::uint32_t make_node(ObbNode& node);
    std::uint32_t part(std::span<BuildTriangle> triangles,
                       std::span<const Projection> projections,
                       const Projection& whole);
    [[nodiscard]] std::vector<ObbNode> in_preorder();

    const BuildInput& input_;
    std::span<BuildTriangle> triangles_;
    std::uint32_t begin_ = 0;
    std::vector<LevelNode> nodes_; ///< All nodes, level by level.
    std::vector<Moments> moments_;
    std::vector<std::uint32_t> sizes_;
    std::vector<std::uint32_t> preorder_;
    SweepScratch sweep_;
    std::vector<Projection> projections_;
    std::vector<BuildTriangle> scratch_;
};

/// Makes nodes of more than `piece_triangles_max` triangles, several at once.
class LargeNodeMaker {
  public:
    LargeNodeMaker(const BuildInput& input, std::size_t triangle_count, ThreadPool& pool)
        : input_(input), pool_(pool), projections_(triangle_count), triangles_(triangle_count) {}

    /// Makes the given nodes together: sets boxes and left counts, and moves the triangles of left
    /// children to the front.
    void make(std::span<NodeToMake> nodes);

  private:
    struct Piece;
    class Wave;

    const BuildInput& input_;
    ThreadPool& pool_;
    std::vector<Projection> projections_;  ///< Projection of each triangle, in tree order.
    std::vector<BuildTriangle> triangles_; ///< Scratch memory, in tree order.
};

} // namespace cd
