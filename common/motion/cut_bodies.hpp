// Two cut bodies: their upper trees, and the subtrees of some of their roots.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/search/subtree_pair.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/subtree.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace cd {

/// Finds the pairs of subtrees that one pose of a motion needs. The whole motion needs many more.
class CutBodies {
  public:
    struct Body {
        const TreeTop& top;
        /// Returns the subtree of a root. Returns null only for a root that is out of reach of the
        /// other body during the whole motion.
        std::function<const Subtree*(RootIndex)> subtree;
    };

    /// The upper trees and the subtrees outlive this object.
    CutBodies(Body a, Body b) : a_(std::move(a)), b_(std::move(b)) {}

    /// Returns the subtrees of a pair of roots; empty if one of them is out of reach.
    [[nodiscard]] std::optional<SubtreePair> subtrees(const RootPair& roots) const;

    /// Calls `visit` for pairs of roots until it returns false. Each pair of triangles that is at
    /// most `distance` apart in the world is under exactly one of these pairs. Skips roots that are
    /// out of reach. Returns the number of box pairs that were tested.
    std::uint64_t
    visit_within(const PosePair& poses,
                 double distance,
                 const std::function<bool(const RootPair&, const SubtreePair&)>& visit) const;

  private:
    Body a_;
    Body b_;
};

} // namespace cd
