// Proves for cuts at several depths that a joined tree is a valid wide tree with all triangles, and
// that searches of it find the same pairs as searches of the body's own tree.
#include "common/tree/build/wide_join.hpp"

#include "common/search/contact_search.hpp"
#include "common/tree/subtree.hpp"
#include "common/tree/wide/wide_check.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

WideTree joined_at(const ObbTree& tree, std::uint32_t depth) {
    std::vector<Subtree> parts;
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        parts.push_back(extract_subtree(tree, node, SubtreeForm::Wide));
    }
    std::vector<WideView> views;
    std::ranges::transform(
        parts, std::back_inserter(views), [](const Subtree& part) { return part.view().wide; });
    return join_subtrees(cut_tree(tree, depth), views);
}

TreeView view_of(const WideTree& wide) {
    TreeView view;
    view.wide = wide.view();
    return view;
}

/// Returns all pairs within the distance, sorted, with their classes.
std::vector<ContactPair>
pairs_within(const TreeView& a, const TreeView& b, const PosePair& poses, double distance) {
    const auto search = make_search(a, b, poses, {}, {.keep_pairs = true, .clearance = distance});
    search->collect(a, b);
    search->contacts().sort();
    return search->contacts().take_pairs();
}

bool are_near(const TreeView& a, const TreeView& b, const PosePair& poses, double distance) {
    return make_search(a, b, poses, {}, {.clearance = distance})->any_near(a, b) != Nearness::Far;
}

} // namespace

TEST(WideJoin, AnswersAsTheWholeTreeAtEveryDepth) {
    std::uint64_t found = 0;
    for (SeededRandom random : seeds(12)) {
        const double size = std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
        const std::vector<Mesh> meshes{scaled(make_sphere(4), size),
                                       scaled(make_torus(1, 0.3, 40, 20), size),
                                       scaled(make_triangle_soup(random, 3000), size),
                                       scaled(make_degenerate_soup(random, 300), size)};
        const ObbTree a = make_tree(meshes[random() % meshes.size()]);
        const ObbTree b = make_tree(meshes[random() % meshes.size()]);
        for (const std::uint32_t depth : {0u, 1u, 3u, 6u, 9u}) {
            const WideTree joined_a = joined_at(a, depth);
            const WideTree joined_b = joined_at(b, depth / 2).with_support();
            ASSERT_TRUE(check_wide_tree(joined_a.view(), a.mesh().triangles().size()));
            ASSERT_TRUE(check_wide_tree(joined_b.view(), b.mesh().triangles().size()));
            const PosePair poses{make_pose(random, 0.2 * size), make_pose(random, 1.5 * size)};
            const double distance = uniform(random, 0, 0.1) * size;
            const auto pairs = pairs_within(view_of(joined_a), view_of(joined_b), poses, distance);
            EXPECT_EQ(pairs, pairs_within(a.view(), b.view(), poses, distance));
            EXPECT_EQ(are_near(view_of(joined_a), view_of(joined_b), poses, distance),
                      !pairs.empty());
            found += pairs.size();
        }
    }
    EXPECT_GT(found, 1000u);
}

TEST(WideJoin, MixesFloatsAndDoubles) {
    // One triangle has coordinates that floats cannot hold, so its subtree has doubles.
    const Mesh sphere = make_sphere(4);
    std::vector<Vec3> vertices(sphere.vertices().begin(), sphere.vertices().end());
    for (Vec3& vertex : vertices) {
        vertex = vertex.cast<float>().cast<double>();
    }
    vertices.front().x() += 0x1p-40;
    const ObbTree a = make_tree(
        make_mesh(std::move(vertices), {sphere.triangles().begin(), sphere.triangles().end()}));
    std::size_t doubles = 0;
    const auto nodes = cut_nodes(a, 4);
    for (const std::uint32_t node : nodes) {
        const Subtree part = extract_subtree(a, node, SubtreeForm::Wide);
        doubles += part.view().wide.triangles.floats.empty() ? 1 : 0;
    }
    ASSERT_GT(doubles, 0u);
    ASSERT_LT(doubles, nodes.size());
    const WideTree joined = joined_at(a, 4);
    ASSERT_TRUE(check_wide_tree(joined.view(), a.mesh().triangles().size()));
    EXPECT_TRUE(joined.view().triangles.floats.empty());
    const ObbTree b = make_tree(make_sphere(3));
    const PosePair poses{Pose{}, Pose::from_quaternion({}, Vec3(1.2, 0.3, 0.1))};
    const auto pairs = pairs_within(view_of(joined), b.view(), poses, 0);
    EXPECT_FALSE(pairs.empty());
    EXPECT_EQ(pairs, pairs_within(a.view(), b.view(), poses, 0));
}

} // namespace cd::tests
