// Proves which buffered scenarios move to a worker that runs dry.
#include "tests/master/dispatch/dispatch_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class Rebalancing : public testing::Test, protected DispatchStage {
  protected:
    /// Puts scenarios of 10 ms into the worker's buffer.
    void fill(WorkerProxy& proxy, std::uint64_t count) {
        queue.set_paused(false); // Nothing is flushed for want of more.
        add(job_, count, 10'000'000);
        for (; !job_.waiting.empty(); job_.waiting.pop_front()) {
            DispatchScenario& scenario = job_.at(job_.waiting.front());
            scenario.where = Whereabouts::Buffered;
            scenario.at.worker = proxy.id();
            proxy.buffers.add(job_.id, job_.waiting.front(), scenario.weight);
        }
    }

    DispatchJob& job_ = open("earliest-finish");
    WorkerProxy& one_ = join(1);
    WorkerProxy& two_ = join(2);
};

TEST_F(Rebalancing, AnIdleWorkerTakesTheLastOfTheFullestBufferUpToTwoBatches) {
    two_.batch.set(15'000'000, false);
    one_.batch.set(1'000'000'000, false);
    fill(one_, 10);
    rebalancer.rebalance(actions);
    EXPECT_EQ(last<SendUnit>().worker, two_.id());
    EXPECT_EQ(last<SendUnit>().positions, (PositionRange{8, 2}));
    EXPECT_EQ(two_.buffers.of(job_.id).scenarios, std::vector<std::uint64_t>{7});
    EXPECT_EQ(one_.buffers.count(), 7u);
}

TEST_F(Rebalancing, AScenarioMovesOnlyIfItEndsEarlier) {
    two_.batch.set(1'000'000'000, false);
    one_.batch.set(1'000'000'000, false);
    pace.add_transfer(two_, 1, 1); // Blocks of 6,464 bytes take two hours.
    fill(one_, 10);
    rebalancer.rebalance(actions);
    EXPECT_EQ(one_.buffers.count(), 10u);
    EXPECT_TRUE(actions.empty());
}

TEST_F(Rebalancing, AWorkerThatTakesNoWorkGetsNone) {
    two_.batch.set(1'000'000'000, false);
    two_.set_draining();
    fill(one_, 10);
    rebalancer.rebalance(actions);
    EXPECT_EQ(one_.buffers.count(), 10u);
}

} // namespace
} // namespace cd::tests
