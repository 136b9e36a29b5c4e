// Proves the order in which a stack of pairs of nodes looks at siblings.
#include "common/tree/planes/plane_stack.hpp"

#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace cd::tests {
namespace {

TEST(PlaneStack, LooksFirstAtTheSiblingsThatOverlapMost) {
    ObbTree tree = make_tree(make_torus(1, 0.4, 96, 48));
    tree.prepare_planes();
    const WideView view = tree.view().wide;
    const PlaneBody body(view);
    const PosePair poses{Pose{}, Pose::from_quaternion({}, Vec3(1.9, 0.3, 0.2))};
    const PlanePose pose = plane_pose(relative_pose(poses), view.support, view.support);
    PlaneStack stack;
    stack.reset(pose, view, view, false);
    stack.push_roots();
    ASSERT_EQ(stack.next(), (WidePair{0, 0}));
    const WideNode& root = view.nodes[0];
    std::vector<WidePair> pairs;
    for (std::uint32_t a = 0; a < root.count; ++a) {
        for (std::uint32_t b = 0; b < root.count; ++b) {
            pairs.push_back({root.first + a, root.first + b});
        }
    }
    // The normal that the stack has from the roots.
    PlaneNormal normal = first_normal(pose);
    ASSERT_EQ(separate(pose, body, 0, body, 0, 3, normal), 0);
    std::vector<PlaneTrial> trials(pairs.size());
    separate_siblings(pose, body, body, pairs, 2, normal, trials);
    const auto least =
        std::ranges::min_element(trials, {}, [](const PlaneTrial& trial) { return trial.slack; });
    ASSERT_LT(least->slack, 0);
    ASSERT_FALSE(least->is_apart);

    stack.push_children(pairs);

    EXPECT_EQ(stack.size(), std::ranges::count(trials, false, &PlaneTrial::is_apart));
    EXPECT_EQ(stack.next(), pairs[static_cast<std::size_t>(least - trials.begin())]);
}

} // namespace
} // namespace cd::tests
