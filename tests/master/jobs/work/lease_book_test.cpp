// Proves that tasks are found by worker and job, and which of them are forgotten with a worker.
#include "master/jobs/work/lease_book.hpp"

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
        add(TaskId{10}, first, JobId{1});
        add(TaskId{11}, first, JobId{1}, PlaceRange{0, 5});
        add(TaskId{12}, second, JobId{1}, PlaceRange{5, 3});
        add(TaskId{13}, second, JobId{2}, PlaceRange{0, 9});
    }
    void add(TaskId id, WorkerId worker, JobId job, std::optional<PlaceRange> places = {}) {
        auto content = std::make_shared<TaskContent>();
        content->job = job;
        if (places) {
            content->range = RangeContent{*places, nullptr, nullptr};
        }
        Lease task{worker, std::move(content)};
        task.places = places;
        book_.add(id, std::move(task));
    }

    LeaseBook book_;
};

TEST_F(LeaseBookTest, ATaskIsFoundOnlyAtItsWorker) {
    EXPECT_NE(book_.find(TaskId{10}), nullptr);
    EXPECT_EQ(book_.find(TaskId{10}), book_.find(TaskId{10}, first));
    EXPECT_EQ(book_.find(TaskId{10}, second), nullptr);
    EXPECT_EQ(book_.find(TaskId{9}), nullptr);
    EXPECT_EQ(book_.find(TaskId{9}, first), nullptr);
}

TEST_F(LeaseBookTest, ATaskIsTakenOnce) {
    EXPECT_EQ(book_.take(TaskId{12})->worker, second);
    EXPECT_FALSE(book_.take(TaskId{12}));
    EXPECT_THAT(book_.of(second), ElementsAre(TaskId{13}));
}

TEST_F(LeaseBookTest, TheInventoryTellsWhichTasksAreMissing) {
    const std::vector<Recalled> present{{TaskId{11}, {}, 0}, {TaskId{13}, {}, 0}};
    EXPECT_THAT(book_.missing(first, present), ElementsAre(TaskId{10}));
    EXPECT_THAT(book_.missing(second, present), ElementsAre(TaskId{12}));
    EXPECT_THAT(book_.missing(WorkerId{3}, present), IsEmpty());
}

TEST_F(LeaseBookTest, OnlyTheBatchesOfAWorkerAreForgotten) {
    book_.forget_batches(first);
    EXPECT_THAT(book_.of(first), ElementsAre(TaskId{11})) << "its range is returned later";
    EXPECT_THAT(book_.of(second), ElementsAre(TaskId{12}, TaskId{13}));
}

TEST_F(LeaseBookTest, TheRangesOfAJobAreThoseNotReturned) {
    EXPECT_THAT(book_.places_of(JobId{1}), ElementsAre(PlaceRange{0, 5}, PlaceRange{5, 3}));
    book_.find(TaskId{11})->places->count = 2;
    EXPECT_THAT(book_.places_of(JobId{1}), ElementsAre(PlaceRange{0, 2}, PlaceRange{5, 3}));
    EXPECT_THAT(book_.places_of(JobId{3}), IsEmpty());
}

} // namespace
} // namespace cd::tests
