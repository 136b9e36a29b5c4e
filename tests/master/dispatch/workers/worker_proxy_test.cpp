// Proves how much work a worker may have, and when it runs dry.
#include "master/dispatch/workers/worker_proxy.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr JobId job{1};

WorkerProxy proxy_of(std::uint32_t threads) {
    return {WorkerId{1}, 0, {"w", threads}};
}

ClusterOptions options_of(std::uint32_t q) {
    ClusterOptions options;
    options.q = q;
    return options;
}

TEST(WorkerProxy, HasATaskThatWaitsAndAsManyAsItsThreadsNeed) {
    EXPECT_EQ(proxy_of(8).tasks_max(options_of(20)), 2u);
    EXPECT_EQ(proxy_of(8).tasks_max(options_of(3)), 4u);
    WorkerProxy proxy = proxy_of(1);
    proxy.tasks.start(TaskId{1}, {job, PositionRange{1, 1}});
    EXPECT_TRUE(proxy.has_room_for_task(job, options_of(20)));
    proxy.tasks.start(TaskId{2}, {job, PositionRange{2, 1}});
    EXPECT_FALSE(proxy.has_room_for_task(job, options_of(20)));
    EXPECT_TRUE(proxy.has_room_for_task(JobId{2}, options_of(20)));
    proxy.tasks.start(TaskId{3}, {JobId{2}, PositionRange{2, 1}, true, true});
    EXPECT_FALSE(proxy.has_room_for_task(JobId{3}, options_of(20))); // It is claimed.
}

TEST(WorkerProxy, RunsDryBelowQScenariosTwiceItsThreadsOrABatch) {
    WorkerProxy proxy = proxy_of(2);
    proxy.tasks.start(TaskId{1}, {job, PositionRange{1, 3}, true, false, 50});
    EXPECT_TRUE(proxy.would_run_dry(options_of(1)));
    EXPECT_FALSE(proxy.would_run_dry_by_time());
    proxy.batch.set(51, false);
    EXPECT_TRUE(proxy.would_run_dry_by_time());
    proxy.tasks.start(TaskId{2}, {job, PositionRange{4, 1}});
    EXPECT_FALSE(proxy.would_run_dry(options_of(4)));
    EXPECT_TRUE(proxy.would_run_dry(options_of(5)));
}

TEST(WorkerProxy, CountsWhatIsBufferedAndWhatIsSent) {
    WorkerProxy proxy = proxy_of(2);
    EXPECT_TRUE(proxy.is_idle());
    proxy.buffers.add(job, 7, {100, 20});
    proxy.tasks.start(TaskId{1}, {job, PositionRange{1, 3}, true, false, 50});
    EXPECT_EQ(proxy.scenarios(), 4u);
    EXPECT_EQ(proxy.backlog_ns(), 70u);
    const WorkerStatus status = proxy.status();
    EXPECT_EQ(status.buffered, 1u);
    EXPECT_EQ(status.working, 3u);
    EXPECT_EQ(status.tasks, 1u);
    proxy.set_draining();
    EXPECT_FALSE(proxy.takes_work());
    EXPECT_TRUE(proxy.status().draining);
}

} // namespace
} // namespace cd::tests
