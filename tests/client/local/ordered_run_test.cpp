// Proves that scenarios handed out in batches return once each, in order, with their digests, and
// that no more run ahead than allowed.
#include "client/local/ordered_run.hpp"

#include "common/core/limits/client.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <latch>
#include <memory>
#include <thread>

namespace cd::tests {

namespace {

class Ordered : public testing::Test {
  protected:
    /// Positions range from far apart to deep inside each other: some take a hundred times as long
    /// as others.
    [[nodiscard]] std::vector<Scenario> make_scenarios(std::uint64_t first, std::uint64_t count) {
        std::vector<Scenario> list(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            list[i].index = first + i;
            list[i].poses.b = make_pose(random_, (first + i) % 7 == 0 ? 0.1 : 20.0);
        }
        return list;
    }

    /// Takes the remaining results and checks each.
    static void take_all(OrderedRun& run, std::uint64_t end, std::uint64_t& taken) {
        while (taken < end) {
            const DoneBlock block = run.take(std::chrono::milliseconds(100), false);
            ASSERT_TRUE(block.for_each([&](const DoneScenario& done) {
                EXPECT_EQ(done.result.index, taken++);
                EXPECT_EQ(done.digest, digest_of(done.result));
                return Status(Done{});
            }));
        }
    }

    std::mt19937_64 random_{3};
    ThreadPool pool_{3};
    ObbTree a_ = build_tree(share(make_torus(1.0, 0.4, 24, 12)), {}, pool_);
    ObbTree b_ = build_tree(share(make_sphere(2)), {}, pool_);
    Query query_;
    std::atomic<bool> ended_ = false;
    ScenarioRunner runner_{a_, b_, query_};
};

} // namespace

TEST_F(Ordered, ResultsComeInOrderWhateverTheyCost) {
    constexpr std::uint64_t scenarios = 2000;
    OrderedRun run(runner_, ended_, pool_);
    std::uint64_t taken = 0;
    for (std::uint64_t added = 0; added < scenarios; added += 100) {
        run.add(make_scenarios(added, 100));
    }
    take_all(run, scenarios, taken);
    EXPECT_TRUE(run.take(std::chrono::milliseconds(0), false).empty());
    EXPECT_GT(run.statistics().search.box_tests, scenarios / 7);
}

TEST_F(Ordered, NoMoreIsWantedThanMayRunAhead) {
    OrderedRun run(runner_, ended_, pool_);
    std::uint64_t added = 0;
    std::uint64_t taken = 0;
    while (added < limits::run_scenarios_ahead_max) {
        const std::uint64_t wanted = run.wanted();
        run.add(make_scenarios(added, wanted));
        added += wanted;
        std::this_thread::yield();
    }
    EXPECT_EQ(added, limits::run_scenarios_ahead_max);
    EXPECT_EQ(run.wanted(), 0u);
    take_all(run, added, taken);
    EXPECT_GT(run.wanted(), 0u);
}

TEST_F(Ordered, DestructionEndsTheRunAndFreesEveryThreadOfThePool) {
    {
        OrderedRun run(runner_, ended_, pool_);
        run.add(make_scenarios(0, 5000));
    }
    EXPECT_TRUE(ended_) << "the stop check of scenarios that run";
    const auto all_threads = std::make_shared<std::latch>(pool_.size() + 1);
    for (unsigned i = 0; i < pool_.size(); ++i) {
        pool_.post([all_threads] { all_threads->arrive_and_wait(); });
    }
    all_threads->arrive_and_wait();
}

} // namespace cd::tests
