// Proves that a session's record stays while results of it may arrive, and that a worker that
// reconnects repeatedly does not make the list grow.
#include "master/workers/worker_sessions.hpp"

#include "common/core/limits/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr auto is_needed_by_none = [](WorkerId) { return false; };

TEST(WorkerSessions, KnowsTheProcessAndTheHolderOfEach) {
    WorkerSessions sessions;
    sessions.joined(WorkerId{3}, 70, "w1");
    sessions.joined(WorkerId{4}, 71, "");
    sessions.joined(WorkerId{9}, 70, "w1");
    EXPECT_EQ(sessions.process_of(WorkerId{9}), 70u);
    EXPECT_EQ(sessions.holder_of(WorkerId{3}), "w1");
    EXPECT_EQ(sessions.holder_of(WorkerId{4}), "");
    EXPECT_EQ(sessions.all_of(70), (std::set{WorkerId{3}, WorkerId{9}}));
    EXPECT_EQ(sessions.process_of(WorkerId{5}), 0u);
}

TEST(WorkerSessions, GiveOneNumberToEachProcessOfAnEarlierLife) {
    WorkerSessions sessions;
    EXPECT_EQ(sessions.earlier(70, WorkerId{1}), WorkerId{1});
    EXPECT_EQ(sessions.earlier(71, WorkerId{2}), WorkerId{2});
    EXPECT_EQ(sessions.earlier(70, WorkerId{3}), WorkerId{1});
    sessions.joined(WorkerId{3}, 70, "");
    EXPECT_TRUE(sessions.is_earlier(WorkerId{2}));
    EXPECT_FALSE(sessions.is_earlier(WorkerId{3}));
    EXPECT_EQ(sessions.all_of(70), (std::set{WorkerId{1}, WorkerId{3}}));
}

TEST(WorkerSessions, ForgetsAllButTheNeededWhenNoResultIsOnItsWay) {
    WorkerSessions sessions;
    for (std::uint64_t id = 1; id <= 5; ++id) {
        sessions.joined(WorkerId{id}, id, "");
    }
    sessions.forget([](WorkerId worker) { return worker == WorkerId{4}; }, true);
    EXPECT_EQ(sessions.size(), 1u);
    EXPECT_EQ(sessions.process_of(WorkerId{4}), 4u);
}

TEST(WorkerSessions, AreNotMoreThanNeededHoweverOftenOneComes) {
    WorkerSessions sessions;
    const auto is_needed = [](WorkerId worker) { return worker.value % 1000 == 1; };
    const std::uint64_t comings = 20 * limits::worker_sessions_kept;
    for (std::uint64_t id = 1; id <= comings; ++id) {
        sessions.joined(WorkerId{id}, 70, "w1");
        if (sessions.are_many()) {
            sessions.forget(is_needed, false);
        }
        ASSERT_LE(sessions.size(), 2 * (limits::worker_sessions_kept + comings / 1000 + 1));
        EXPECT_EQ(sessions.process_of(WorkerId{id}), 70u);
    }
    EXPECT_EQ(sessions.process_of(WorkerId{1}), 70u) << "one that is needed";
    EXPECT_EQ(sessions.process_of(WorkerId{2}), 0u);
    EXPECT_EQ(sessions.process_of(WorkerId{comings - limits::worker_sessions_kept + 1}), 70u)
        << "its results may be on their way";
    sessions.forget(is_needed_by_none, true);
    EXPECT_EQ(sessions.size(), 0u);
}

TEST(WorkerSessions, WaitsLongerWhenMoreAreNeeded) {
    WorkerSessions sessions;
    for (std::uint64_t id = 1; !sessions.are_many(); ++id) {
        sessions.joined(WorkerId{id}, 70, "");
    }
    sessions.forget([](WorkerId) { return true; }, false);
    EXPECT_FALSE(sessions.are_many()) << "each that joins would look through all";
}

} // namespace
} // namespace cd::tests
