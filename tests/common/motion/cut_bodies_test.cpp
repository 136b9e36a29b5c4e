// Proves that the pairs of subtrees found for a pose contain each pair of triangles within the
// distance exactly once, and that they are few if the bodies are near each other in few places.
#include "common/motion/cut_bodies.hpp"

#include "common/search/contact_search.hpp"
#include "tests/support/cut_trees.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cd::tests {

namespace {

using testing::IsEmpty;

/// Returns all pairs of triangles within the distance, sorted.
std::vector<ContactPair>
near_pairs(const std::vector<SubtreePair>& pairs, const PosePair& poses, double distance) {
    if (pairs.empty()) {
        return {};
    }
    const auto search =
        make_search(pairs[0].a, pairs[0].b, poses, {}, {.keep_pairs = true, .clearance = distance});
    for (const SubtreePair& pair : pairs) {
        search->collect(pair.a, pair.b);
    }
    search->contacts().sort();
    return search->contacts().take_pairs();
}

std::vector<SubtreePair> all_within(const CutBodies& cut, const PosePair& poses, double distance) {
    std::vector<SubtreePair> pairs;
    cut.visit_within(poses, distance, [&](const RootPair&, const SubtreePair& pair) {
        pairs.push_back(pair);
        return true;
    });
    return pairs;
}

} // namespace

TEST(CutBodies, HoldEachPairWithinTheDistanceOnce) {
    std::uint64_t within = 0;
    std::uint64_t visited = 0;
    std::uint64_t all = 0;
    for (SeededRandom random : seeds(40)) {
        const double size = std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
        const ObbTree a = make_tree(scaled(make_sphere(2), size));
        const ObbTree b = make_tree(scaled(make_triangle_soup(random, 40), size));
        const CutTrees cut(a, b, 4, random() % 2 == 0 ? SubtreeForm::Wide : SubtreeForm::Binary);
        const PosePair poses{make_pose(random, 0.1 * size), make_pose(random, 3 * size)};
        const double distance = uniform(random, 0, 0.5) * size;
        const std::vector<SubtreePair> pairs = all_within(cut.bodies(), poses, distance);
        const std::vector<ContactPair> found = near_pairs(pairs, poses, distance);
        EXPECT_EQ(found, near_pairs({{a.view(), b.view()}}, poses, distance));
        within += found.size();
        visited += pairs.size();
        all += cut.pair_count();
    }
    EXPECT_GT(within, 50u);
    EXPECT_LT(visited, all / 2);
}

TEST(CutBodies, AVisitEndsThemAndRootsOutOfReachAreLeftOut) {
    const ObbTree box = make_tree(make_gridded_box({1, 1, 1}, 4));
    const PosePair poses{moved_pose(Vec3::Zero()), moved_pose({0.5, 0.5, 0.5})};
    const CutTrees cut(box, box, 3);
    int visits = 0;
    cut.bodies().visit_within(poses, 0, [&](const RootPair&, const SubtreePair&) {
        ++visits;
        return false;
    });
    EXPECT_EQ(visits, 1);

    const TreeTop top = cut_tree(box, 3);
    const Subtree part = extract_subtree(box, cut_nodes(box, 3).back(), SubtreeForm::Wide);
    const auto only_last = [&](RootIndex root) {
        return root + 1 == top.root_count() ? &part : nullptr;
    };
    const CutBodies last({top, only_last}, {top, only_last});
    EXPECT_FALSE(last.subtrees({0, top.root_count() - 1}));
    EXPECT_TRUE(last.subtrees({top.root_count() - 1, top.root_count() - 1}));
    EXPECT_EQ(all_within(last, {poses.a, poses.a}, 0).size(), 1u);
    EXPECT_THAT(all_within(last, {poses.a, moved_pose({9, 0, 0})}, 0), IsEmpty());
}

} // namespace cd::tests
