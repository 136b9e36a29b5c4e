// Proves that results come back in order, whatever order their pieces were added in.
#include "client/local/result_queue.hpp"

#include "common/core/limits/client.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

DoneBlock results(std::uint64_t first, std::uint64_t count) {
    DoneBlock block;
    ScenarioResult result;
    for (std::uint64_t i = 0; i < count; ++i) {
        result.index = first + i;
        block.add(result);
    }
    return block;
}

TEST(ResultQueue, ResultsComeBackInOrder) {
    for (SeededRandom random : seeds(100)) {
        const std::uint64_t first = random() % 1000;
        std::vector<std::pair<std::uint64_t, std::uint64_t>> pieces; // First index and count.
        std::uint64_t end = first;
        while (pieces.size() < 30) {
            pieces.emplace_back(end, random() % 10);
            end += pieces.back().second;
        }
        std::ranges::shuffle(pieces, random);
        ResultQueue queue(first);
        std::uint64_t taken = first;
        for (const auto& [begin, count] : pieces) {
            queue.add(results(begin, count));
            while (queue.is_next_here()) {
                const DoneBlock block = queue.take();
                ASSERT_EQ(block.first(), taken);
                taken += block.size();
                ASSERT_EQ(queue.next(), taken);
            }
            EXPECT_TRUE(queue.take().empty());
        }
        EXPECT_EQ(taken, end);
    }
}

TEST(ResultQueue, TakenResultsCountUntilTheyAreReleased) {
    ResultQueue queue(0);
    ScenarioResult large;
    large.kind = ScenarioClass::Failed;
    large.failure.resize(limits::run_bytes_ahead_max);
    DoneBlock one;
    one.add(large);
    queue.add(std::move(one));
    EXPECT_TRUE(queue.is_full());
    EXPECT_EQ(queue.take().size(), 1u);
    EXPECT_TRUE(queue.is_full());
    queue.release_taken();
    EXPECT_FALSE(queue.is_full());
}

} // namespace

} // namespace cd::tests
