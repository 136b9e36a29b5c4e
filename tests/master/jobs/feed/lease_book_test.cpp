// Proves that leases are found by worker and task, and forgotten with their worker.
#include "master/jobs/feed/lease_book.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr WorkerId first{1};
constexpr WorkerId second{2};

class LeaseBookTest : public testing::Test {
  protected:
    LeaseBookTest() {
        book_.add(first, TaskId{10}, {});
        book_.add(first, TaskId{11}, {});
        book_.add(second, TaskId{12}, {});
        book_.add(second, TaskId{13}, {});
    }

    LeaseBook book_;
};

TEST_F(LeaseBookTest, ATaskIsFoundOnlyAtItsWorker) {
    EXPECT_NE(book_.find(first, TaskId{10}), nullptr);
    EXPECT_TRUE(book_.has(first, TaskId{10}));
    EXPECT_EQ(book_.find(second, TaskId{10}), nullptr);
    EXPECT_EQ(book_.find(first, TaskId{9}), nullptr);
    book_.remove(first, TaskId{10});
    EXPECT_FALSE(book_.has(first, TaskId{10}));
    EXPECT_EQ(book_.size(), 3u);
}

TEST_F(LeaseBookTest, TheInventoryTellsWhichTasksAreMissing) {
    const std::vector<Recalled> present{{TaskId{11}, {}, 0}, {TaskId{13}, {}, 0}};
    EXPECT_THAT(book_.missing(first, present), ElementsAre(TaskId{10}));
    EXPECT_THAT(book_.missing(second, present), ElementsAre(TaskId{12}));
    EXPECT_THAT(book_.missing(WorkerId{3}, present), IsEmpty());
}

TEST_F(LeaseBookTest, AWorkerIsForgottenWithAllItsTasks) {
    book_.forget(first);
    EXPECT_THAT(book_.missing(first, {}), IsEmpty());
    EXPECT_THAT(book_.missing(second, {}), ElementsAre(TaskId{12}, TaskId{13}));
}

} // namespace
} // namespace cd::tests
