// Proves that every end of a child process becomes an answer or a word for it, and that no process
// is left behind.
#include "client/import/foreign/child_call.hpp"

#include "tests/support/memory_bound.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <vector>

namespace cd::tests {

namespace {

constexpr ChildLimits limits{64u << 20, std::chrono::seconds(1), std::chrono::seconds(600)};

ChildEnd end_of(const std::function<Bytes()>& work, const StopCheck& is_stopped = {}) {
    const auto answer = call_in_child(work, limits, is_stopped);
    EXPECT_TRUE(answer) << answer.error().detail;
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD); // There is no zombie.
    return answer ? answer.value().end : ChildEnd::Crashed;
}

[[noreturn]] Bytes run_for_ever() {
    for (std::atomic<std::uint64_t> i = 0;;) {
        ++i;
    }
}

} // namespace

TEST(ChildCall, AnswersWithAllBytes) {
    const Bytes large(3'000'000, std::byte{7});
    const auto answer = call_in_child([&] { return large; }, limits, {});
    ASSERT_TRUE(answer) << answer.error().detail;
    EXPECT_EQ(answer.value().end, ChildEnd::Answered);
    EXPECT_EQ(answer.value().bytes, large);
    EXPECT_EQ(end_of([] { return Bytes(); }), ChildEnd::Answered);
}

TEST(ChildCall, ACrashEndsOnlyTheChild) {
    EXPECT_EQ(end_of([]() -> Bytes { std::abort(); }), ChildEnd::Crashed);
    EXPECT_EQ(end_of([]() -> Bytes {
                  std::signal(SIGSEGV, SIG_DFL);
                  std::raise(SIGSEGV);
                  return {};
              }),
              ChildEnd::Crashed);
    EXPECT_EQ(end_of([]() -> Bytes { throw std::runtime_error("why"); }), ChildEnd::Crashed);
}

TEST(ChildCall, AnEndlessLoopIsEnded) {
    EXPECT_EQ(end_of(run_for_ever), ChildEnd::OutOfTime);
}

TEST(ChildCall, MemoryIsBounded) {
    if (!MemoryBound::is_enforced) {
        GTEST_SKIP() << "memory cannot be bounded under sanitizers";
    }
    EXPECT_EQ(end_of([] { return Bytes(1u << 30); }), ChildEnd::OutOfMemory);
}

TEST(ChildCall, IsStoppedFromOutsideAndBySignals) {
    EXPECT_EQ(end_of(run_for_ever, [] { return true; }), ChildEnd::Stopped);
    EXPECT_EQ(end_of([]() -> Bytes {
                  std::raise(SIGINT);
                  return {};
              }),
              ChildEnd::Stopped);
}

TEST(ChildCall, WorksWhileOtherThreadsTakeMemory) {
    std::atomic<bool> done = false;
    std::vector<std::thread> threads;
    for (int i = 0; i < 2; ++i) {
        threads.emplace_back([&] {
            while (!done) {
                const std::vector<int> some(1000, 1);
                EXPECT_EQ(some.back(), 1);
            }
        });
    }
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(end_of([] { return Bytes(1000, std::byte{1}); }), ChildEnd::Answered) << i;
    }
    done = true;
    for (std::thread& thread : threads) {
        thread.join();
    }
}

} // namespace cd::tests
