// Proves who holds which blocks, and which are under way.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr TreeId tree{1};
const std::vector<RootIndex> both = {0, 2};

TEST(WorkerPool, ABlockIsMissingOnceAndAgainAfterItsEviction) {
    DispatchStage stage;
    stage.open("best-match");
    WorkerProxy& one = stage.join(1);
    EXPECT_EQ(stage.pool.hold(one, tree, both).bytes, 2u * 6400);
    EXPECT_TRUE(stage.pool.hold(one, tree, both).roots.empty());
    EXPECT_EQ(one.held_triangles(), 200u);
    EXPECT_TRUE(stage.pool.tree(tree).coming.any());
    stage.pool.arrived(one, tree, both);
    EXPECT_FALSE(stage.pool.tree(tree).coming.any());
    stage.pool.release(one, tree, std::vector<RootIndex>{2});
    EXPECT_EQ(stage.pool.hold(one, tree, both).roots, std::vector<RootIndex>{2});
    stage.pool.check();
}

TEST(WorkerPool, ALostWorkersSlotIsFreeAndHoldsNothing) {
    DispatchStage stage;
    stage.open("best-match");
    stage.pool.hold(stage.join(1), tree, both);
    stage.pool.remove(WorkerId{1});
    const WorkerProxy& next = stage.join(2);
    EXPECT_EQ(next.slot(), 0u);
    EXPECT_EQ(stage.pool.tree(tree).held.roots_of(0), 0u);
    stage.pool.check();
}

TEST(WorkerPool, TheReservedWorkerIsTheFirstThatTakesWork) {
    DispatchStage stage;
    stage.join(1).set_draining();
    EXPECT_EQ(stage.pool.first_that_takes_work(), nullptr);
    const WorkerProxy& second = stage.join(2);
    stage.join(3);
    EXPECT_EQ(stage.pool.first_that_takes_work(), &second);
}

} // namespace
} // namespace cd::tests
