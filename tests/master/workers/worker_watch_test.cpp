// Proves when a worker counts as alive, silent, lost and forgotten: events and times in, states
// out, without a clock.
#include "master/workers/worker_watch.hpp"

#include "common/core/limits/master.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using Change = WorkerWatch::Change;
using Changes = std::vector<Change>;
using Time = WorkerWatch::Time;

constexpr WorkerId one{1};
constexpr WorkerId two{2};
constexpr FailureTimes times{2s, 15s, 15s, 600s};
const Change silent{one, WorkerState::Silent};
const Change lost{one, WorkerState::Lost};
const Change forgotten{one, std::nullopt};

Time at(std::chrono::milliseconds since_start) {
    return Time(since_start);
}

TEST(WorkerWatch, SilenceMakesAWorkerSilentThenLostThenForgotten) {
    WorkerWatch watch(times);
    watch.joined(one, at(0s));
    EXPECT_EQ(watch.time_is(at(5999ms)), Changes{});
    EXPECT_EQ(watch.state(one), WorkerState::Alive);
    EXPECT_EQ(watch.time_is(at(6s)), Changes{silent});
    EXPECT_EQ(watch.time_is(at(14'999ms)), Changes{});
    EXPECT_EQ(watch.state(one), WorkerState::Silent);
    EXPECT_EQ(watch.time_is(at(15s)), Changes{lost});
    EXPECT_EQ(watch.time_is(at(599s)), Changes{});
    EXPECT_EQ(watch.state(one), WorkerState::Lost);
    EXPECT_EQ(watch.time_is(at(600s)), Changes{forgotten});
    EXPECT_EQ(watch.state(one), std::nullopt);
    EXPECT_EQ(watch.size(), 0u);
}

TEST(WorkerWatch, AWordMakesASilentWorkerAliveAndALostOneNot) {
    WorkerWatch watch(times);
    watch.joined(one, at(0s));
    EXPECT_FALSE(watch.heard(one, at(3s))) << "it was alive";
    EXPECT_EQ(watch.time_is(at(8s)), Changes{});
    EXPECT_EQ(watch.time_is(at(9s)), Changes{silent});
    EXPECT_TRUE(watch.heard(one, at(10s)));
    EXPECT_EQ(watch.time_is(at(15s)), Changes{});
    EXPECT_EQ(watch.time_is(at(25s)), Changes{lost}) << "a leap over silence";
    EXPECT_FALSE(watch.heard(one, at(26s)));
    EXPECT_EQ(watch.state(one), WorkerState::Lost);
}

TEST(WorkerWatch, ABrokenConnectionIsSilenceAtOnceAndLostOnlyInTime) {
    FailureTimes short_wait = times;
    short_wait.return_within = 4s;
    WorkerWatch watch(short_wait);
    watch.joined(one, at(0s));
    EXPECT_TRUE(watch.detached(one, at(1s)));
    EXPECT_FALSE(watch.detached(one, at(1s)));
    EXPECT_EQ(watch.state(one), WorkerState::Silent);
    EXPECT_EQ(watch.time_is(at(4999ms)), Changes{});
    EXPECT_TRUE(watch.heard(one, at(4999ms))) << "it came back";
    EXPECT_EQ(watch.time_is(at(10s)), Changes{});
    EXPECT_TRUE(watch.detached(one, at(10s)));
    EXPECT_EQ(watch.time_is(at(14s)), Changes{lost});
    EXPECT_FALSE(watch.detached(one, at(14s)));
}

TEST(WorkerWatch, AnUnreadConnectionIsNotSilent) {
    WorkerWatch watch(times);
    watch.joined(one, at(0s));
    watch.joined(two, at(0s));
    watch.unheard(one);
    EXPECT_EQ(watch.time_is(at(100s)), (Changes{{two, WorkerState::Lost}}));
    EXPECT_EQ(watch.state(one), WorkerState::Alive);
    EXPECT_FALSE(watch.heard(one, at(100s)));
    EXPECT_EQ(watch.time_is(at(106s)), Changes{silent}) << "from then on it counts again";
    watch.unheard(one);
    EXPECT_FALSE(watch.detached(one, at(107s)));
    EXPECT_EQ(watch.time_is(at(122s)), Changes{lost}) << "without a connection it counts, too";
}

TEST(WorkerWatch, ADepartedWorkerIsForgottenAndAGoneOneIsLost) {
    WorkerWatch watch(times);
    watch.joined(one, at(0s));
    watch.left(one);
    EXPECT_EQ(watch.time_is(at(1000s)), Changes{});
    watch.joined(one, at(1000s));
    watch.lost(one);
    EXPECT_EQ(watch.state(one), WorkerState::Lost);
    EXPECT_EQ(watch.time_is(at(1600s)), Changes{forgotten});
    EXPECT_FALSE(watch.heard(one, at(1601s)));
    EXPECT_FALSE(watch.detached(one, at(1601s)));
}

TEST(WorkerWatch, OnlySoManyLostWorkersAreRemembered) {
    WorkerWatch watch(times);
    const std::size_t most = limits::lost_workers_kept_max;
    for (std::uint64_t id = 1; id <= most + 3; ++id) {
        watch.joined(WorkerId{id}, at(0s));
    }
    EXPECT_EQ(watch.time_is(at(15s)).size(), most + 3 + 3);
    EXPECT_EQ(watch.size(), most);
    EXPECT_EQ(watch.state(WorkerId{3}), std::nullopt);
    EXPECT_EQ(watch.state(WorkerId{4}), WorkerState::Lost);
}

TEST(WorkerWatch, WhateverHappensStatesFollowFromTheLastWord) {
    for (SeededRandom random : seeds(200)) {
        WorkerWatch watch(times);
        watch.joined(one, at(0s));
        Time now = at(0s);
        Time last = now; // Time of its last message while it has a connection.
        bool is_lost = false;
        for (int step = 0; step < 300 && !is_lost; ++step) {
            now += std::chrono::milliseconds(random() % 2500);
            const Changes changes = watch.time_is(now);
            is_lost = now - last >= 15s;
            const WorkerState expected = is_lost            ? WorkerState::Lost
                                         : now - last >= 6s ? WorkerState::Silent
                                                            : WorkerState::Alive;
            ASSERT_EQ(watch.state(one), expected);
            ASSERT_LE(changes.size(), 1u);
            if (random() % 4 == 0 && !is_lost) {
                ASSERT_EQ(watch.heard(one, now), expected == WorkerState::Silent);
                last = now;
            }
        }
    }
}

} // namespace
} // namespace cd::tests
