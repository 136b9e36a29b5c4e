// Proves that a worker's tree knows its empty slots, and that a subtree in use outlives its slot.

#include "common/tree/partial_tree.hpp"

#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

struct Cut {
    ObbTree tree;
    std::vector<std::uint32_t> nodes;
    PartialObbTree partial;
};

Cut make_cut(std::uint32_t depth) {
    ObbTree tree = make_tree(make_sphere(2));
    auto nodes = cut_nodes(tree, depth);
    auto top = std::make_shared<const TreeTop>(cut_tree(tree, depth));
    PartialObbTree partial(top->root_count());
    partial.set_top(std::move(top));
    return {std::move(tree), std::move(nodes), std::move(partial)};
}

std::shared_ptr<const Subtree> subtree_of(const Cut& cut, RootIndex root) {
    return std::make_shared<const Subtree>(extract_subtree(cut.tree, cut.nodes[root]));
}

} // namespace

TEST(PartialObbTree, SlotsAreEmptyUntilFilled) {
    Cut cut = make_cut(3);
    ASSERT_EQ(cut.partial.root_count(), 8u);
    EXPECT_FALSE(cut.partial.at(3));
    cut.partial.fill(3, subtree_of(cut, 3));
    EXPECT_EQ(cut.partial.at(3)->view().triangles.size(), cut.partial.top().triangles_under(3));
    EXPECT_FALSE(cut.partial.at(0));
}

TEST(PartialObbTree, ASubtreeInUseOutlivesItsSlot) {
    Cut cut = make_cut(3);
    cut.partial.fill(3, subtree_of(cut, 3));
    const std::shared_ptr<const Subtree> used = cut.partial.at(3);
    cut.partial.empty(3);
    EXPECT_FALSE(cut.partial.at(3));
    EXPECT_EQ(used->view().triangles.size(), cut.partial.top().triangles_under(3));
}

} // namespace cd::tests
