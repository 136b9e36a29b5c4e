// Proves which blocks each worker has by the plan, and which are under way.
#include "master/dispatch/blocks/block_plan.hpp"

#include "common/core/limits/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using Roots = std::vector<RootIndex>;

constexpr TreeId tree{1};
constexpr TreeId other{2};
const Roots both = {0, 2};

/// Two workers, in the slots 0 and 1, and two trees.
class BlockPlans : public testing::Test {
  protected:
    BlockPlans() {
        plan_.join(0);
        plan_.add_tree({tree, {100, 200, 300}, {6400, 6400, 6401}});
        plan_.add_tree({other, {7}});
        plan_.join(1);
    }
    void TearDown() override { plan_.check(taken_); }

    BlockPlan plan_;
    std::vector<bool> taken_ = {true, true};
};

TEST_F(BlockPlans, ABlockIsMissingOnceAndAgainAfterItsEviction) {
    const BlockPlan::Missing missing = plan_.hold(0, tree, both);
    EXPECT_EQ(missing.roots, both);
    EXPECT_EQ(missing.bytes, 6400u + 6464u) << "rounded up to 64 bytes";
    EXPECT_EQ(plan_.held_triangles(0), 400u);
    EXPECT_TRUE(plan_.hold(0, tree, both).roots.empty());
    EXPECT_EQ(plan_.hold(1, tree, both).roots, both) << "each worker has its own blocks";
    plan_.release(0, tree, Roots{2, 1, 3});
    EXPECT_EQ(plan_.held_triangles(0), 100u);
    EXPECT_EQ(plan_.hold(0, tree, both).roots, Roots{2});
}

TEST_F(BlockPlans, ABlockComesUntilItIsReportedOrAScenarioWithItIsAnswered) {
    plan_.hold(0, tree, both);
    plan_.arrived(0, tree, Roots{0, 3});
    EXPECT_FALSE(plan_.tree(tree).coming.holds(0, 0));
    EXPECT_TRUE(plan_.tree(tree).coming.holds(0, 2));
    plan_.arrived(0, tree, std::vector<WeightedRoot>{{2, 300}});
    EXPECT_FALSE(plan_.tree(tree).coming.any());
    EXPECT_EQ(plan_.tree(tree).held.roots_of(0), 2u);
}

TEST_F(BlockPlans, AReportedBlockIsHeldEvenIfNoScenarioNeededIt) {
    plan_.arrived(0, tree, both);
    EXPECT_EQ(plan_.held_triangles(0), 400u);
    EXPECT_FALSE(plan_.tree(tree).coming.any());
    EXPECT_TRUE(plan_.hold(0, tree, both).roots.empty());
}

TEST_F(BlockPlans, AFreedSlotHoldsNothing) {
    plan_.hold(1, tree, both);
    plan_.leave(1);
    plan_.check({true, false});
    plan_.join(1);
    EXPECT_EQ(plan_.held_triangles(1), 0u);
    EXPECT_EQ(plan_.tree(tree).held.roots_of(1), 0u);
    plan_.join(2);
    taken_.push_back(true);
    EXPECT_EQ(plan_.hold(2, tree, both).roots, both);
}

TEST_F(BlockPlans, ATreeLeavesWithItsTriangles) {
    plan_.hold(0, tree, both);
    plan_.hold(0, other, Roots{0});
    plan_.add_tree({tree, {1}}); // Another job has it too.
    plan_.remove_tree(tree);
    EXPECT_EQ(plan_.held_triangles(0), 7u);
    plan_.release(0, tree, both);
    plan_.arrived(0, tree, both);
    plan_.remove_tree(tree);
    EXPECT_EQ(plan_.held_triangles(0), 7u);
}

TEST_F(BlockPlans, UnknownSizesAreEstimatedFromTheTriangles) {
    EXPECT_EQ(plan_.tree(other).bytes_total, 7 * limits::block_bytes_per_triangle);
    EXPECT_EQ(plan_.tree(other).bytes_of(0), 128u);
    EXPECT_EQ(plan_.tree(tree).bytes_total, 19'201u);
    EXPECT_EQ(plan_.tree(tree).triangles_total, 600u);
}

} // namespace
} // namespace cd::tests
