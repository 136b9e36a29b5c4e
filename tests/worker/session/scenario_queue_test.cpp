// Proves that each scenario is given to a thread once, in order of readiness, or dropped before.
#include "worker/session/scenario_queue.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using Entry = ScenarioQueue::Entry;
using Token = ScenarioQueue::Token;

constexpr TaskId task{1};

bool any(const Entry&) {
    return true;
}

TEST(ScenarioQueue, BeginsScenariosInTheOrderInWhichTheyBecomeReady) {
    ScenarioQueue queue;
    const Token first = queue.add(task, 0);
    const Token second = queue.add(task, 1);
    EXPECT_FALSE(queue.begin_next());
    queue.set_ready(std::vector{second, first});
    EXPECT_EQ(queue.begin_next()->token, second);
    EXPECT_EQ(queue.begin_next()->token, first);
    EXPECT_FALSE(queue.begin_next());
    EXPECT_EQ(queue.size(), 2u);
    EXPECT_EQ(queue.finish(second)->scenario, 1u);
    EXPECT_FALSE(queue.finish(second)) << "it is answered";
    EXPECT_EQ(queue.size(), 1u);
}

TEST(ScenarioQueue, DropsWhatNoThreadHasBegun) {
    ScenarioQueue queue;
    std::vector<Token> tokens;
    for (std::size_t scenario = 0; scenario < 4; ++scenario) {
        tokens.push_back(queue.add(task, scenario));
    }
    queue.set_ready(std::span(tokens).first(3));
    const Entry begun = *queue.begin_next();
    const Entry submitted = *queue.begin_next();
    begun.has_begun->store(true);
    std::vector<Token> dropped;
    for (const Entry& entry : queue.drop_unbegun(any)) {
        dropped.push_back(entry.token);
    }
    EXPECT_EQ(dropped, (std::vector{tokens[1], tokens[2], tokens[3]}));
    EXPECT_TRUE(submitted.has_begun->load()) << "its thread is told";
    EXPECT_FALSE(queue.begin_next());
    EXPECT_FALSE(queue.finish(submitted.token));
    EXPECT_TRUE(queue.finish(begun.token));
}

TEST(ScenarioQueue, DropsOnlyWhatMatches) {
    ScenarioQueue queue;
    const Token kept = queue.add(task, 0);
    (void)queue.add(TaskId{2}, 0);
    const auto dropped = queue.drop_unbegun([](const Entry& entry) { return entry.task != task; });
    EXPECT_EQ(dropped.size(), 1u);
    queue.set_ready(std::vector{kept});
    EXPECT_EQ(queue.begin_next()->token, kept);
}

} // namespace
} // namespace cd::tests
