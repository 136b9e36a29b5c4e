// The cut of a tree at its distribution depth (paper, section 5.1, figure 2 and table 1).
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace cd {

/// The index of a distribution root in its cut, from left to right.
using RootIndex = std::uint32_t;

/// The number that means the upper tree instead of a root. The upper tree is sent as a block, like
/// the roots' subtrees.
inline constexpr RootIndex top_root = std::numeric_limits<RootIndex>::max();

/// Returns `roots`, which are ascending, without `top_root`.
[[nodiscard]] inline std::span<const RootIndex> without_top(std::span<const RootIndex> roots) {
    return roots.empty() || roots.back() != top_root ? roots : roots.first(roots.size() - 1);
}

/// Two distribution roots, one of each body, whose boxes overlap.
struct RootPair {
    RootIndex a = 0;
    RootIndex b = 0;

    friend auto operator<=>(const RootPair&, const RootPair&) = default;
};

/// The upper tree: the nodes above the cut and the cut itself. A node of `nodes` without children
/// is a distribution root; roots are numbered in the order of `nodes`. The master needs nothing
/// else for its analysis, nor does a worker that analyses poses itself.
struct TreeTop {
    std::vector<ObbNode> nodes;            ///< Preorder; triangle ranges refer to the whole tree.
    std::vector<std::uint32_t> root_nodes; ///< Index into `nodes` of each root, ascending.

    [[nodiscard]] std::uint32_t root_count() const {
        return static_cast<std::uint32_t>(root_nodes.size());
    }
    [[nodiscard]] std::uint32_t triangle_count() const { return nodes.front().triangle_count(); }
    [[nodiscard]] std::uint32_t triangles_under(RootIndex root) const {
        return nodes[root_nodes[root]].triangle_count();
    }
};

/// Cuts the tree at depth `depth` (0 is the root of the tree). A leaf above that depth is a root,
/// too.
[[nodiscard]] TreeTop cut_tree(const ObbTree& tree, std::uint32_t depth);

/// Returns the index in `tree.nodes()` of each distribution root of `cut_tree(tree, depth)`.
[[nodiscard]] std::vector<std::uint32_t> cut_nodes(const ObbTree& tree, std::uint32_t depth);

/// Makes an upper tree of `nodes` and finds its roots. The nodes are a tree in preorder whose
/// triangle ranges are consecutive from 0.
[[nodiscard]] TreeTop make_tree_top(std::vector<ObbNode> nodes);

struct CollidingRoots {
    std::vector<RootPair> pairs;
    std::uint64_t box_tests = 0; ///< Number of box pairs that were tested.
};

/// Descends both upper trees together. Each pair of triangles that is at most `clearance` apart in
/// the world, which is a contact without a clearance, lies under exactly one returned pair. So the
/// answers of the pairs together are the answer, without duplicates; no pair means none. The pairs
/// are sorted and depend only on the arguments. Errors: TooLarge if there are more than
/// `limits::root_pairs_max` pairs.
[[nodiscard]] Result<CollidingRoots>
colliding_roots(const TreeTop& a, const TreeTop& b, const PosePair& poses, double clearance = 0);

/// Calls `visit` for each pair that `colliding_roots` returns, unsorted, until `visit` returns
/// false. Returns the number of box pairs that were tested.
std::uint64_t visit_colliding_roots(const TreeTop& a,
                                    const TreeTop& b,
                                    const PosePair& poses,
                                    double clearance,
                                    const std::function<bool(const RootPair&)>& visit);

/// Returns the upper tree of the same body cut at depth 0: its only root is the whole body.
[[nodiscard]] TreeTop whole_body(const TreeTop& top);

/// Returns an upper bound on the distance in the world of two bodies' nearest triangles: every box
/// of an upper tree holds a triangle, so the bound is the least of the greatest distances of two
/// boxes. May be infinite.
[[nodiscard]] double distance_bound(const TreeTop& a, const TreeTop& b, const PosePair& poses);

/// Returns the distinct roots of body A in a list of pairs, ascending.
[[nodiscard]] std::vector<RootIndex> roots_of_a(std::span<const RootPair> pairs);
[[nodiscard]] std::vector<RootIndex> roots_of_b(std::span<const RootPair> pairs);

} // namespace cd
