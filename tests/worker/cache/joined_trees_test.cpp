// Proves that a tree whose blocks are all cached is joined after enough descents and gets support
// points later; that unused joined trees are dropped if memory is short; and that a joined tree
// belongs to one set of blocks.
#include "worker/cache/joined_trees.hpp"

#include "common/core/limits/worker.hpp"
#include "tests/worker/execution/walks.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

namespace cd::tests {
namespace {

constexpr std::uint64_t unlimited = std::uint64_t{1} << 40;

class JoinedTreesTest : public testing::Test {
  protected:
    [[nodiscard]] JoinedTrees::Blocks blocks_without(std::optional<RootIndex> missing) const {
        auto some = std::make_shared<PartialObbTree>(held(body_));
        if (missing) {
            some->empty(*missing);
        }
        return some;
    }
    /// Counts descents until a step is due, and returns their number; 0 if none is due in time.
    std::uint32_t wait_for_step(const JoinedTrees::Blocks& blocks, std::uint64_t room = unlimited) {
        for (std::uint32_t i = 1; i <= 2 * limits::points_descents_min; ++i) {
            step_ = trees_.count(blocks, room);
            if (step_) {
                return i;
            }
        }
        return 0;
    }

    CutBody body_ = cut_body(make_sphere(3), 3);
    JoinedTrees trees_;
    std::optional<JoinedTrees::Step> step_;
};

TEST_F(JoinedTreesTest, ATreeIsJoinedAndLaterGetsSupportPoints) {
    const auto blocks = blocks_without({});
    EXPECT_EQ(wait_for_step(blocks), limits::join_descents_min);
    EXPECT_FALSE(trees_.count(blocks, unlimited)) << "the step is under way";
    EXPECT_EQ(trees_.find(blocks), nullptr);
    trees_.end(*step_, step_->run());
    const auto joined = trees_.find(blocks);
    ASSERT_NE(joined, nullptr);
    EXPECT_TRUE(joined->view().support.sets.empty());
    EXPECT_EQ(trees_.bytes(), joined->memory_bytes());
    EXPECT_EQ(wait_for_step(blocks), limits::points_descents_min - limits::join_descents_min - 1);
    trees_.end(*step_, step_->run());
    EXPECT_FALSE(trees_.find(blocks)->view().support.sets.empty());
    EXPECT_EQ(wait_for_step(blocks), 0u) << "nothing is left to do";
}

TEST_F(JoinedTreesTest, AMissingBlockAnOtherFormOrTooLittleRoomLeaveATreeAsItIs) {
    EXPECT_EQ(wait_for_step(blocks_without(1)), 0u);
    PartialObbTree no_top(body_.top.root_count());
    for (RootIndex root = 0; root < body_.top.root_count(); ++root) {
        fill(no_top, body_, root);
    }
    EXPECT_EQ(wait_for_step(std::make_shared<const PartialObbTree>(no_top)), 0u);
    const CutBody binary = cut_body(make_sphere(3), 3, SubtreeForm::Binary);
    EXPECT_EQ(wait_for_step(std::make_shared<const PartialObbTree>(held(binary))), 0u);
    EXPECT_EQ(wait_for_step(blocks_without({}), 1000), 0u);
}

TEST_F(JoinedTreesTest, OtherBlocksHaveNoJoinedTree) {
    auto blocks = blocks_without({});
    ASSERT_NE(wait_for_step(blocks), 0u);
    const auto other = blocks_without({});
    EXPECT_FALSE(trees_.count(other, unlimited));
    trees_.end(*step_, step_->run());
    EXPECT_EQ(trees_.find(other), nullptr);
    EXPECT_NE(trees_.find(blocks), nullptr);
}

TEST_F(JoinedTreesTest, AJoinedTreeThatIsUsedNoMoreMakesRoomForAnother) {
    const auto first = blocks_without({});
    ASSERT_NE(wait_for_step(first), 0u);
    trees_.end(*step_, step_->run());
    const auto second = blocks_without({});
    std::uint64_t room_for_one = 0;
    for (RootIndex root = 0; root < second->root_count(); ++root) {
        room_for_one += second->at(root)->memory_bytes();
    }
    for (std::uint64_t i = 1; i < limits::joined_unused_descents; ++i) {
        ASSERT_FALSE(trees_.count(second, room_for_one));
    }
    EXPECT_NE(trees_.find(first), nullptr);
    EXPECT_TRUE(trees_.count(second, room_for_one));
    EXPECT_EQ(trees_.find(first), nullptr);
}

TEST_F(JoinedTreesTest, JoinedTreesGoWithTheirBlocksAndForLackOfRoom) {
    auto blocks = blocks_without({});
    ASSERT_NE(wait_for_step(blocks), 0u);
    trees_.end(*step_, step_->run());
    step_.reset();
    trees_.keep_within(trees_.bytes());
    EXPECT_NE(trees_.find(blocks), nullptr);
    trees_.keep_within(trees_.bytes() - 1);
    EXPECT_EQ(trees_.find(blocks), nullptr);
    ASSERT_NE(wait_for_step(blocks), 0u);
    trees_.end(*step_, step_->run());
    step_.reset();
    EXPECT_GT(trees_.bytes(), 0u);
    blocks.reset();
    trees_.keep_within(unlimited);
    EXPECT_EQ(trees_.bytes(), 0u);
}

} // namespace
} // namespace cd::tests
