// Proves that scenarios are taken once each, lowest index first, also those that come back.
#include "client/local/waiting_scenarios.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cd::tests {

namespace {

std::vector<Scenario> scenarios(std::uint64_t first, std::uint64_t count) {
    std::vector<Scenario> list(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        list[i].index = first + i;
    }
    return list;
}

TEST(WaitingScenarios, PiecesAreJoinedToBlocks) {
    WaitingScenarios waiting(10);
    for (std::uint64_t i = 0; i < 6; ++i) {
        waiting.add(scenarios(4 * i, 4));
    }
    waiting.add({});
    EXPECT_EQ(waiting.size(), 24u);
    EXPECT_EQ(waiting.take(100), scenarios(0, 8));
    EXPECT_EQ(waiting.take(3), scenarios(8, 3));
    EXPECT_EQ(waiting.take(100), scenarios(11, 5));
    EXPECT_EQ(waiting.first(), 16u);
    EXPECT_EQ(waiting.take(8), scenarios(16, 8));
    EXPECT_TRUE(waiting.empty());
}

TEST(WaitingScenarios, EachIsTakenOnceLowestFirst) {
    for (SeededRandom random : seeds(200)) {
        WaitingScenarios waiting(1 + random() % 50);
        std::uint64_t added = 0;
        std::set<std::uint64_t> left;
        std::vector<std::vector<Scenario>> held; // By threads.
        for (int step = 0; step < 200; ++step) {
            const auto choice = random() % 4;
            if (choice == 0) {
                const std::uint64_t count = random() % 30;
                waiting.add(scenarios(added, count));
                for (std::uint64_t i = 0; i < count; ++i) {
                    left.insert(added++);
                }
            } else if (choice == 1 && !held.empty()) {
                std::swap(held[random() % held.size()], held.back());
                const std::vector<Scenario>& taken = held.back();
                const std::size_t ran = random() % (taken.size() + 1);
                std::vector<Scenario> back(taken.begin() + static_cast<std::ptrdiff_t>(ran),
                                           taken.end());
                for (const Scenario& scenario : back) {
                    left.insert(scenario.index);
                }
                held.pop_back();
                waiting.give_back(std::move(back));
            } else if (!waiting.empty()) {
                ASSERT_EQ(waiting.first(), *left.begin());
                const std::size_t wanted = 1 + random() % 40;
                held.push_back(waiting.take(wanted));
                ASSERT_GE(held.back().size(), 1u);
                ASSERT_LE(held.back().size(), wanted);
                for (const Scenario& scenario : held.back()) {
                    ASSERT_EQ(scenario.index, *left.begin());
                    left.erase(left.begin());
                }
            }
            ASSERT_EQ(waiting.size(), left.size());
        }
    }
}

} // namespace

} // namespace cd::tests
