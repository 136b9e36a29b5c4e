// Proves that a pool runs every function exactly once, in order if it has one thread, and that
// parallel_for returns only after every call.
#include "common/core/host/thread_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>

namespace cd::tests {

TEST(ThreadPool, HasTheThreadsAskedForAndAtLeastOne) {
    EXPECT_EQ(ThreadPool(3).size(), 3u);
    EXPECT_GE(ThreadPool(0).size(), 1u);
}

TEST(ThreadPool, RunsWhatWasPostedBeforeItEnds) {
    std::atomic<int> runs{0};
    {
        ThreadPool pool(4);
        for (int i = 0; i < 1000; ++i) {
            pool.post([&] { ++runs; });
        }
    }
    EXPECT_EQ(runs, 1000);
}

TEST(ThreadPool, OneThreadKeepsTheOrderOfPosting) {
    std::vector<int> order;
    {
        ThreadPool pool(1);
        for (int i = 0; i < 100; ++i) {
            pool.post([&order, i] { order.push_back(i); });
        }
    }
    std::vector<int> expected(100);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(order, expected);
}

TEST(ThreadPool, APostedFunctionMayPost) {
    std::atomic<int> runs{0};
    {
        ThreadPool pool(2);
        pool.post([&] {
            ++runs;
            pool.post([&] { ++runs; });
        });
    }
    EXPECT_EQ(runs, 2);
}

TEST(ParallelFor, CallsEachIndexOnce) {
    for (const unsigned threads : {1u, 2u, 5u}) {
        ThreadPool pool(threads);
        for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
            std::vector<std::atomic<int>> calls(count);
            parallel_for(pool, count, [&](std::size_t i) { ++calls[i]; });
            for (const std::atomic<int>& call : calls) {
                EXPECT_EQ(call, 1) << threads << " threads, " << count;
            }
        }
    }
}

} // namespace cd::tests
