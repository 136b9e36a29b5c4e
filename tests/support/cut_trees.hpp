// Two trees, cut into subtrees as workers receive them.
#pragma once

#include "common/motion/cut_bodies.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/subtree.hpp"

#include <cstdint>
#include <vector>

namespace cd::tests {

/// Two trees that are cut at a depth, with the subtrees of all their roots.
class CutTrees {
  public:
    CutTrees(const ObbTree& a,
             const ObbTree& b,
             std::uint32_t depth,
             SubtreeForm form = SubtreeForm::Wide)
        : a_(cut(a, depth, form)), b_(cut(b, depth, form)) {}

    /// The result is valid while this object lives.
    [[nodiscard]] CutBodies bodies() const { return {body_of(a_), body_of(b_)}; }
    [[nodiscard]] std::uint64_t pair_count() const { return a_.parts.size() * b_.parts.size(); }

  private:
    struct Side {
        TreeTop top;
        std::vector<Subtree> parts;
    };

    static Side cut(const ObbTree& tree, std::uint32_t depth, SubtreeForm form) {
        Side side{cut_tree(tree, depth), {}};
        for (const std::uint32_t node : cut_nodes(tree, depth)) {
            side.parts.push_back(extract_subtree(tree, node, form));
        }
        return side;
    }
    static CutBodies::Body body_of(const Side& side) {
        return {side.top, [&side](RootIndex root) { return &side.parts.at(root); }};
    }

    Side a_;
    Side b_;
};

} // namespace cd::tests
