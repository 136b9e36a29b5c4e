// Proves that a worker's buffers keep order, sums and counts.
#include "master/dispatch/workers/worker_buffers.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace cd::tests {
namespace {

constexpr JobId one{1};
constexpr JobId other{2};

using List = std::vector<std::uint64_t>;

TEST(WorkerBuffers, EveryChangeKeepsTheSums) {
    WorkerBuffers buffers;
    buffers.add(one, 5, {100, 3});
    buffers.add(one, 6, {200, 4});
    buffers.add(one, 7, {300, 5});
    buffers.add(other, 5, {10, 1});
    EXPECT_EQ(buffers.count(), 4u);
    EXPECT_EQ(buffers.cost_ns(), 13u);
    buffers.remove(one, 6, {200, 4});
    EXPECT_EQ(buffers.of(one).scenarios, (List{5, 7}));
    EXPECT_EQ(buffers.of(one).bytes, 400u);
    buffers.remove_first(one, 1, {100, 3});
    EXPECT_EQ(buffers.of(one).cost_ns, 5u);
    EXPECT_EQ(buffers.cost_ns(), 6u);
    EXPECT_EQ(buffers.take(other).scenarios, List{5});
    EXPECT_EQ(buffers.count(), 1u);
}

TEST(WorkerBuffers, AnEmptyBufferIsGone) {
    WorkerBuffers buffers;
    EXPECT_TRUE(buffers.of(one).scenarios.empty());
    buffers.add(one, 5, {100, 3});
    buffers.remove(one, 5, {100, 3});
    EXPECT_TRUE(buffers.all().empty());
    EXPECT_TRUE(buffers.take(one).scenarios.empty());
}

TEST(WorkerBuffers, SortsStably) {
    WorkerBuffers buffers;
    for (const std::uint64_t scenario : {12, 21, 11, 22}) {
        buffers.add(one, scenario, {});
    }
    buffers.sort(one,
                 [](std::uint64_t left, std::uint64_t right) { return left / 10 > right / 10; });
    EXPECT_EQ(buffers.of(one).scenarios, (List{21, 22, 12, 11}));
}

TEST(WorkerBuffers, ABufferIsFullAtQScenariosOrAboveVKilobytes) {
    ClusterOptions options;
    options.q = 2;
    options.v_kb = 1;
    EXPECT_FALSE((ScenarioBuffer{{1}, 1000}).is_full(options));
    EXPECT_TRUE((ScenarioBuffer{{1}, 1001}).is_full(options));
    EXPECT_TRUE((ScenarioBuffer{{1, 2}, 0}).is_full(options));
}

} // namespace
} // namespace cd::tests
