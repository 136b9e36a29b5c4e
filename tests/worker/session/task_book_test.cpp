// Proves that a session's book of tasks knows its jobs and tasks, each once.
#include "worker/session/task_book.hpp"

#include "tests/worker/session/parts.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

struct Tasks : testing::Test {
    Tasks() {
        EXPECT_TRUE(cache.add_tree(bodies().a.add(tree_a)));
        EXPECT_TRUE(cache.add_tree(bodies().b.add(tree_b)));
        EXPECT_TRUE(book.add_job(add_job(), cache));
    }

    SubtreeCache cache{unlimited};
    TaskBook book;
};

TEST_F(Tasks, AreOfKnownJobsAndComeOnce) {
    EXPECT_THAT(book.add_job(add_job(), cache).error().detail, HasSubstr("added already"));
    const WorkUnit batch = make_batch(TaskId{1}, make_scenarios(0, 3));
    ASSERT_TRUE(book.add(batch, cache));
    EXPECT_THAT(book.add(batch, cache).error().detail, HasSubstr("task 1 came twice"));
    EXPECT_THAT(book.add(make_range(TaskId{1}, make_scenarios(0, 1)), cache).error().detail,
                HasSubstr("task 1 came twice"));
    book.remove_job(JobId{1});
    EXPECT_EQ(book.job(JobId{1}), nullptr);
    EXPECT_THAT(book.add(make_range(TaskId{2}, make_scenarios(0, 1)), cache).error().detail,
                HasSubstr("task 2 names a job that is not here"));
    EXPECT_EQ(book.find(TaskId{2}), nullptr);
}

TEST_F(Tasks, AreCountedAndNamedInAnInventory) {
    EXPECT_TRUE(book.add(make_batch(TaskId{1}, make_scenarios(0, 3)), cache));
    EXPECT_TRUE(book.add(make_range(TaskId{2}, make_scenarios(3, 4)), cache));
    EXPECT_EQ(book.unanswered(), 7u);
    book.at(TaskId{1}).drop();
    book.at(TaskId{1}).give_back(2);
    EXPECT_EQ(book.unanswered(), 6u);
    Inventory inventory;
    book.add_to(inventory);
    EXPECT_EQ(inventory.jobs, std::vector{JobId{1}});
    ASSERT_EQ(inventory.tasks.size(), 2u);
    EXPECT_EQ(inventory.tasks[0].scenarios, std::vector<std::uint64_t>{2});
    EXPECT_EQ(inventory.tasks[1].kept, 4u);
    book.remove_jobs_of(tree_b);
    EXPECT_EQ(book.job(JobId{1}), nullptr);
    EXPECT_TRUE(book.has_tasks()) << "they end by themselves";
}

} // namespace
} // namespace cd::tests
