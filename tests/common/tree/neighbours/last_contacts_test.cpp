// Proves that the noted places lie above the contacts, and when they are forgotten.
#include "common/tree/neighbours/last_contacts.hpp"

#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace cd::tests {

namespace {

RelativePose moved(const Vec3& translation, double turn = 0) {
    const Quaternion about_z{std::cos(turn / 2), 0, 0, std::sin(turn / 2)};
    return relative_pose({Pose{}, Pose::from_quaternion(about_z, translation)});
}

LastContacts near_zero(const WideView& tree) {
    LastContacts last;
    last.move_to(moved({0, 0, 0}), tree, tree);
    last.add(tree, tree, {0, 0});
    EXPECT_TRUE(last.places().empty()) << "the pose is not near another one";
    last.move_to(moved({0, 0, 0}), tree, tree);
    EXPECT_TRUE(last.is_near());
    return last;
}

TEST(LastContacts, PlacesAreTheParentsOfLeaves) {
    const ObbTree tree = make_tree(make_torus(1, 0.3, 90, 45));
    const WideView& view = tree.view().wide;
    std::uint32_t leaves = 0;
    for (std::uint32_t node = 0; node < view.nodes.size(); ++node) {
        const WideNode& parent = view.nodes[node];
        for (std::uint32_t i = parent.first; !parent.is_leaf && i < parent.first + parent.count;
             ++i) {
            if (view.nodes[i].is_leaf) {
                ++leaves;
                LastContacts last = near_zero(view);
                const std::uint32_t slot = view.nodes[i].first * block_size;
                last.add(view, view, {slot, slot + view.nodes[i].count - 1});
                ASSERT_EQ(last.places().size(), 1u);
                EXPECT_EQ(last.places()[0], (WidePair{node, node}));
            }
        }
    }
    EXPECT_GT(leaves, 100u);
}

TEST(LastContacts, TheLastPlacesAreKeptLatestFirst) {
    const ObbTree tree = make_tree(make_torus(1, 0.3, 90, 45));
    const WideView& view = tree.view().wide;
    LastContacts last = near_zero(view);
    const auto blocks = static_cast<std::uint32_t>(view.triangles.vertex_begin.size() - 1);
    const auto add = [&](std::uint32_t block) {
        last.add(view, view, {block * block_size, block * block_size});
        return last.places()[0];
    };
    const WidePair first = add(0);
    const WidePair middle = add(blocks / 2);
    EXPECT_EQ(last.places().size(), 2u);
    EXPECT_EQ(add(0), first);
    EXPECT_EQ(last.places()[1], middle);
    const WidePair end = add(blocks - 1);
    EXPECT_EQ(last.places().size(), 2u);
    EXPECT_EQ(last.places()[0], end);
    EXPECT_EQ(last.places()[1], first);
}

TEST(LastContacts, PosesAreNearIfNoPointMovesFar) {
    const ObbTree a = make_tree(make_torus(1, 0.3, 30, 15));
    const ObbTree b = make_tree(make_gridded_box(Vec3(1, 0.5, 0.25), 3));
    const ObbTree other = make_tree(make_gridded_box(Vec3(1, 0.5, 0.25), 4));
    const ObbTree twin = make_tree(make_gridded_box(Vec3(1, 0.5, 0.25), 3));
    const WideView& of_a = a.view().wide;
    const WideView& of_b = b.view().wide;
    LastContacts last;
    const auto is_near_after = [&](const RelativePose& pose, const WideView& now) {
        last.move_to(pose, of_a, now);
        if (!last.is_near()) {
            EXPECT_TRUE(last.places().empty());
        }
        last.add(of_a, now, {0, 0});
        EXPECT_EQ(last.places().empty(), !last.is_near());
        return last.is_near();
    };
    last.move_to(moved({5, 0, 0}), of_a, of_b);
    EXPECT_FALSE(last.is_near());
    const double diagonal = std::hypot(1, 0.5, 0.25);
    EXPECT_TRUE(is_near_after(moved({5 + 0.35 * diagonal, 0, 0}), of_b));
    EXPECT_FALSE(is_near_after(moved({5 + 0.8 * diagonal, 0, 0}), of_b));
    EXPECT_TRUE(is_near_after(moved({5 + 0.8 * diagonal, 0, 0}, 0.1), of_b));
    EXPECT_FALSE(is_near_after(moved({5 + 0.8 * diagonal, 0, 0}, 0.1 + std::numbers::pi), of_b));
    EXPECT_TRUE(is_near_after(moved({5 + 0.8 * diagonal, 0, 0}, 0.1 + std::numbers::pi), of_b));
    ASSERT_EQ(twin.view().wide.nodes.size(), of_b.nodes.size());
    EXPECT_FALSE(
        is_near_after(moved({5 + 0.8 * diagonal, 0, 0}, 0.1 + std::numbers::pi), twin.view().wide));
    EXPECT_FALSE(is_near_after(moved({5 + 0.8 * diagonal, 0, 0}, 0.1 + std::numbers::pi),
                               other.view().wide));
    EXPECT_FALSE(
        is_near_after(moved({std::numeric_limits<double>::quiet_NaN(), 0, 0}), other.view().wide));
    EXPECT_FALSE(is_near_after(moved({0, 0, 0}), other.view().wide));
}

TEST(LastContacts, ANearPoseExpectsTheLastAnswerAndAnotherOneMostAnswers) {
    const ObbTree tree = make_tree(make_torus(1, 0.3, 30, 15));
    const WideView& view = tree.view().wide;
    LastContacts last;
    EXPECT_TRUE(last.expects_contact());
    double x = 0;
    const auto expects_after = [&](bool touches, double step) {
        last.note_answer(touches);
        last.move_to(moved({x += step, 0, 0}), view, view);
        return last.expects_contact();
    };
    last.move_to(moved({x, 0, 0}), view, view);
    EXPECT_FALSE(expects_after(false, 0.01));
    EXPECT_TRUE(expects_after(true, 0.01));
    EXPECT_TRUE(expects_after(false, 5)) << "most answers are contacts";
    for (int i = 0; i < 10; ++i) {
        last.note_answer(false);
    }
    EXPECT_FALSE(expects_after(true, 5)) << "most answers are none";
    EXPECT_TRUE(expects_after(true, 0.01));
}

} // namespace

} // namespace cd::tests
