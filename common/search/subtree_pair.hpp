// Two subtrees that a search descends together.
#pragma once

#include "common/tree/obb_tree.hpp"

namespace cd {

/// The two subtrees below a colliding pair of distribution roots, or two whole trees.
struct SubtreePair {
    TreeView a;
    TreeView b;
};

} // namespace cd
