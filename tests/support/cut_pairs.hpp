// Two trees cut as for workers.
#pragma once

#include "common/search/subtree_pair.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/subtree.hpp"

#include <cstdint>
#include <vector>

namespace cd::tests {

/// All pairs of subtrees of two trees that are cut at a depth: together they hold all pairs of
/// triangles.
class CutPairs {
  public:
    CutPairs(const ObbTree& a,
             const ObbTree& b,
             std::uint32_t depth,
             SubtreeForm form = SubtreeForm::Wide)
        : parts_a_(parts_of(a, depth, form)), parts_b_(parts_of(b, depth, form)) {
        for (const Subtree& part_a : parts_a_) {
            for (const Subtree& part_b : parts_b_) {
                pairs_.push_back({part_a.view(), part_b.view()});
            }
        }
    }

    [[nodiscard]] const std::vector<SubtreePair>& pairs() const { return pairs_; }

  private:
    static std::vector<Subtree>
    parts_of(const ObbTree& tree, std::uint32_t depth, SubtreeForm form) {
        std::vector<Subtree> parts;
        for (const std::uint32_t node : cut_nodes(tree, depth)) {
            parts.push_back(extract_subtree(tree, node, form));
        }
        return parts;
    }

    std::vector<Subtree> parts_a_;
    std::vector<Subtree> parts_b_;
    std::vector<SubtreePair> pairs_;
};

} // namespace cd::tests
