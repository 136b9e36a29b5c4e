// The cut of a tree at its distribution depth (paper, section 5.1, figure 2 and table 1).
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cd {

/// The place of a distribution root in its cut, from left to right.
using RootIndex = std::uint32_t;

/// In place of a root's number: the top of the tree, which travels as a block as the roots' do.
inline constexpr RootIndex top_root = std::numeric_limits<RootIndex>::max();

/// The roots, which ascend, but for `top_root`.
[[nodiscard]] inline std::span<const RootIndex> without_top(std::span<const RootIndex> roots) {
    return roots.empty() || roots.back() != top_root ? roots : roots.first(roots.size() - 1);
}

/// One distribution root of each body whose boxes overlap.
struct RootPair {
    RootIndex a = 0;
    RootIndex b = 0;

    friend auto operator<=>(const RootPair&, const RootPair&) = default;
};

/// The nodes above the cut and the cut itself. A node of `nodes` without children is a distribution
/// root; roots are numbered in the order in which they stand. This is all that the master needs for
/// its analysis, and a worker that makes it itself.
struct TreeTop {
    std::vector<ObbNode> nodes;            ///< Preorder; triangle ranges are those of the tree.
    std::vector<std::uint32_t> root_nodes; ///< Index into `nodes` of each root, ascending.

    [[nodiscard]] std::uint32_t root_count() const {
        return static_cast<std::uint32_t>(root_nodes.size());
    }
    [[nodiscard]] std::uint32_t triangle_count() const { return nodes.front().triangle_count(); }
    [[nodiscard]] std::uint32_t triangles_under(RootIndex root) const {
        return nodes[root_nodes[root]].triangle_count();
    }
};

/// The nodes at depth `depth` (0 is the root of the tree), or the leaves above it.
[[nodiscard]] TreeTop cut_tree(const ObbTree& tree, std::uint32_t depth);

/// The place in `tree.nodes()` of each distribution root of `cut_tree(tree, depth)`.
[[nodiscard]] std::vector<std::uint32_t> cut_nodes(const ObbTree& tree, std::uint32_t depth);

/// Finds the roots. The nodes are a tree in preorder whose triangle ranges are consecutive from 0.
[[nodiscard]] TreeTop make_tree_top(std::vector<ObbNode> nodes);

struct CollidingRoots {
    std::vector<RootPair> pairs;
    std::uint64_t box_tests = 0; ///< Pairs of boxes that were tested.
};

/// Descends both tops together. Each contact of the scenario lies under exactly one returned pair,
/// so the pairs' contacts together are the answer, without duplicates; no pair means no contact.
/// Sorted, and a function of the arguments alone. Errors: TooLarge over `limits::root_pairs_max`.
[[nodiscard]] Result<CollidingRoots>
colliding_roots(const TreeTop& a, const TreeTop& b, const PosePair& poses);

/// The distinct roots of one side of a list of pairs, ascending.
[[nodiscard]] std::vector<RootIndex> roots_of_a(std::span<const RootPair> pairs);
[[nodiscard]] std::vector<RootIndex> roots_of_b(std::span<const RootPair> pairs);

} // namespace cd
