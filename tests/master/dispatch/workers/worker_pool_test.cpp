// Proves which slots workers get, in which order they are listed, and which of them is reserved.
#include "master/dispatch/workers/worker_pool.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(WorkerPool, ALostWorkersSlotGoesToTheNext) {
    WorkerPool pool;
    pool.add(WorkerId{5}, {});
    pool.add(WorkerId{3}, {});
    pool.remove(WorkerId{5});
    EXPECT_EQ(pool.slots_taken(), (std::vector<bool>{false, true}));
    const WorkerProxy& next = pool.add(WorkerId{4}, {});
    EXPECT_EQ(next.slot(), 0u);
    ASSERT_EQ(pool.in_order().size(), 2u);
    EXPECT_EQ(pool.in_order().back(), &next);
    pool.check();
}

TEST(WorkerPool, TheReservedWorkerIsTheFirstThatTakesWork) {
    WorkerPool pool;
    pool.add(WorkerId{1}, {}).set_draining();
    EXPECT_EQ(pool.first_that_takes_work(), nullptr);
    const WorkerProxy& second = pool.add(WorkerId{2}, {});
    pool.add(WorkerId{3}, {});
    EXPECT_EQ(pool.first_that_takes_work(), &second);
}

} // namespace
} // namespace cd::tests
