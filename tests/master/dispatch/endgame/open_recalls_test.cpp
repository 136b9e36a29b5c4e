// Proves that OpenRecalls finds a recall by the worker that was asked and by its helper.
#include "master/dispatch/endgame/open_recalls.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr WorkerId slow{1};
constexpr WorkerId slower{2};
constexpr WorkerId idle{3};
constexpr WorkerId other{4};

TEST(Recalls, AreFoundByBothWorkers) {
    OpenRecalls recalls;
    EXPECT_EQ(recalls.find(slow), nullptr);
    EXPECT_FALSE(recalls.is_awaited_by(idle, 0));
    recalls.add(slow, {TaskId{7}, idle, 10});
    recalls.add(slower, {TaskId{8}, idle, 20});
    ASSERT_NE(recalls.find(slow), nullptr);
    EXPECT_EQ(recalls.find(slow)->task, TaskId{7});
    EXPECT_TRUE(recalls.is_awaited_by(idle, 19));
    EXPECT_FALSE(recalls.is_awaited_by(idle, 20));
    EXPECT_FALSE(recalls.is_awaited_by(slow, 0));
    recalls.remove(slower);
    EXPECT_TRUE(recalls.is_awaited_by(idle, 9));
    EXPECT_FALSE(recalls.is_awaited_by(idle, 10));
    recalls.remove(slow);
    EXPECT_FALSE(recalls.is_awaited_by(idle, 0));
    EXPECT_TRUE(recalls.all().empty());
}

TEST(Recalls, ANewOneTakesThePlaceOfTheWorkersLast) {
    OpenRecalls recalls;
    recalls.add(slow, {TaskId{7}, idle, 10});
    recalls.add(slow, {TaskId{8}, other, 20});
    EXPECT_FALSE(recalls.is_awaited_by(idle, 0));
    EXPECT_TRUE(recalls.is_awaited_by(other, 0));
    EXPECT_EQ(recalls.all().size(), 1u);
}

} // namespace
} // namespace cd::tests
