// Proves how ranges of positions are sent: to workers that run out of work, sized to last a batch's
// time at the measured rate, two per worker, smaller at the end. Every position is sent once,
// except returned ones and speculative copies, whatever workers do or return. Also proves what is
// measured for the choice between ranges and analysis.
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"
#include "master/dispatch/dispatcher.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>
#include <utility>

namespace cd::tests {
namespace {

constexpr JobId job_1{1};
constexpr JobId job_2{2};
constexpr WorkerId slow{1};
constexpr WorkerId fast{2};

DispatchTree tree(std::uint64_t id, std::size_t roots) {
    return {TreeId{id},
            std::vector<std::uint32_t>(roots, 100),
            std::vector<std::uint64_t>(roots, 1280)};
}

std::vector<SendUnit> ranges_in(const Actions& actions) {
    std::vector<SendUnit> sent;
    for (const Action& action : actions) {
        if (const auto* range = std::get_if<SendUnit>(&action)) {
            sent.push_back(*range);
        }
    }
    return sent;
}

class DispatcherRanges : public testing::Test {
  protected:
    void open(JobId job, std::uint64_t trees) {
        (void)dispatcher_.job_opened(job, {}, {tree(trees, 10), tree(trees + 1, 10)});
    }
    void TearDown() override { dispatcher_.check_invariants(); }
    /// The worker answers positions of a task.
    std::vector<SendUnit>
    answer(const SendUnit& sent, const PositionRange& positions, double seconds) {
        return ranges_in(
            dispatcher_.answered({sent.worker, sent.task, sent.job, positions, seconds}));
    }

    Dispatcher dispatcher_;
};

TEST_F(DispatcherRanges, EachWorkerGetsTwoRangesAndAnotherWhenItAnswers) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    const auto first = ranges_in(dispatcher_.positions_given(job_1, {{0, 10'000}}, 0));
    // Unmeasured defaults: a scenario takes 1 ms, a batch lasts 0.1 s.
    ASSERT_EQ(first.size(), 1u);
    EXPECT_EQ(first[0].positions, (PositionRange{0, 100}));
    EXPECT_EQ(dispatcher_.positions_unsent(job_1), 9900u);
    // The worker is twice as fast as the default.
    const auto second = answer(first[0], {0, 50}, 0.025);
    ASSERT_EQ(second.size(), 1u);
    EXPECT_EQ(second[0].positions, (PositionRange{100, 200}));
    // The worker already has two ranges.
    EXPECT_TRUE(answer(first[0], {50, 50}, 0.025).empty());
    EXPECT_EQ(dispatcher_.worker_status(slow).working, 200u);
    const auto third = ranges_in(dispatcher_.task_ended(slow, first[0].task));
    EXPECT_TRUE(third.empty()) << "it has enough to do";
}

TEST(DispatcherOfALargeCluster, GivesANewWorkerARangeBeforeItChecksAllWorkersAgain) {
    Dispatcher dispatcher({.workers_few = 0, .look_seconds_each = 1e6});
    (void)dispatcher.job_opened(job_1, {}, {tree(1, 10), tree(2, 10)});
    (void)dispatcher.worker_joined(slow, {"slow", 1});
    (void)dispatcher.positions_given(job_1, {{0, 10'000}}, 0);
    EXPECT_EQ(ranges_in(dispatcher.worker_joined(fast, {"fast", 1})).size(), 1u);
}

TEST_F(DispatcherRanges, UnlikeWorkersGetUnlikeShares) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    (void)dispatcher_.worker_joined(fast, {"fast", 4});
    const auto first = ranges_in(dispatcher_.positions_given(job_1, {{0, 10'000}}, 0));
    ASSERT_EQ(first.size(), 2u);
    EXPECT_EQ(first[0].positions.count(), 100u);
    EXPECT_EQ(first[1].positions.count(), 400u);
    // The measured rate is per thread.
    (void)answer(first[0], {0, 100}, 0.1);
    const auto next = answer(first[1], {100, 400}, 0.1);
    ASSERT_EQ(next.size(), 1u);
    EXPECT_EQ(next[0].worker, fast);
    EXPECT_EQ(next[0].positions.count(), 1600u);
}

TEST_F(DispatcherRanges, TowardsTheEndRangesShrink) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    (void)dispatcher_.worker_joined(fast, {"fast", 1});
    auto sent = ranges_in(dispatcher_.positions_given(job_1, {{0, 300}}, 0));
    std::uint64_t next = 0;
    std::uint64_t last = 300;
    for (std::size_t i = 0; i < sent.size(); ++i) {
        const PositionRange range = sent[i].positions.runs().front();
        EXPECT_EQ(range.first, next);
        EXPECT_LE(range.count, last);
        last = range.count;
        next = range.end();
        for (const SendUnit& more : answer(sent[i], range, 1e-3 * static_cast<double>(last))) {
            sent.push_back(more);
        }
        for (const SendUnit& more :
             ranges_in(dispatcher_.task_ended(sent[i].worker, sent[i].task))) {
            sent.push_back(more);
        }
    }
    EXPECT_EQ(next, 300u);
    EXPECT_EQ(sent.front().positions.count(), 75u);
    EXPECT_EQ(last, 1u);
}

// The first task takes half a second. If the dispatcher takes that for the round trip, the next
// range has all 40 remaining positions; otherwise it has fewer.
TEST(DispatcherRoundTrip, ATaskWithBlocksOnTheWayTellsNone) {
    const std::vector<RootIndex> roots{0};
    const auto nothing = [](Dispatcher&) {};
    const auto wanted = [&](Dispatcher& one) { one.roots_wanted(slow, TreeId{1}, roots); };
    const auto arrived = [&](Dispatcher& one) { one.roots_arrived(slow, TreeId{1}, roots); };
    const auto next_range = [](const std::function<void(Dispatcher&)>& meanwhile) {
        Dispatcher dispatcher;
        (void)dispatcher.job_opened(job_1, {}, {tree(1, 10), tree(2, 10)});
        (void)dispatcher.worker_joined(slow, {"slow", 1});
        const auto first = ranges_in(dispatcher.positions_given(job_1, {{0, 1}}, 0));
        dispatcher.time_is(0.25);
        meanwhile(dispatcher);
        dispatcher.time_is(0.5);
        (void)dispatcher.answered({slow, first[0].task, job_1, PositionRange{0, 1}, 0.001});
        (void)dispatcher.task_ended(slow, first[0].task);
        return ranges_in(dispatcher.positions_given(job_1, {{1, 40}}, 0))[0].positions.count();
    };
    EXPECT_EQ(next_range(nothing), 40u);
    EXPECT_LT(next_range(wanted), 40u);
    EXPECT_LT(next_range(arrived), 40u);
}

TEST_F(DispatcherRanges, RangesOfALostWorkerCountAsLostAndThoseOfADrainingWorkerDoNot) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    const auto sent = ranges_in(dispatcher_.positions_given(job_1, {{0, 1000}}, 0));
    ASSERT_EQ(sent.size(), 1u);
    (void)dispatcher_.worker_joined(fast, {"fast", 1});
    (void)dispatcher_.worker_draining(slow);
    const auto after = ranges_in(dispatcher_.task_ended(slow, sent[0].task));
    EXPECT_EQ(dispatcher_.worker_status(fast).working, 100u);
    EXPECT_TRUE(after.empty()) << "it has enough to do";
    EXPECT_EQ(dispatcher_.positions_unsent(job_1), 900u) << "the returned ones among them";
    const auto lost = dispatcher_.worker_lost(fast);
    ASSERT_EQ(lost.size(), 1u);
    EXPECT_FALSE(std::get<PositionsLost>(lost[0]).is_analysed);
    EXPECT_EQ(std::get<PositionsLost>(lost[0]).positions, (PositionRange{100, 100}));
}

TEST_F(DispatcherRanges, UnsentPositionsCanBeTakenBack) {
    open(job_1, 1);
    (void)dispatcher_.positions_given(job_1, {{0, 700}}, 300);
    (void)dispatcher_.positions_given(job_1, {{700, 300}}, 0);
    EXPECT_EQ(dispatcher_.positions_unsent(job_1), 1000u);
    const std::vector<PositionRange> expected{{0, 700}, {700, 300}};
    EXPECT_EQ(dispatcher_.take_positions(job_1), expected);
    EXPECT_EQ(dispatcher_.positions_unsent(job_1), 0u);
    EXPECT_TRUE(dispatcher_.worker_joined(slow, {"slow", 1}).empty());
}

TEST_F(DispatcherRanges, SeveralJobsTakeTurns) {
    open(job_1, 1);
    open(job_2, 3);
    (void)dispatcher_.positions_given(job_1, {{0, 5000}}, 0);
    (void)dispatcher_.positions_given(job_2, {{0, 5000}}, 0);
    const auto sent = ranges_in(dispatcher_.worker_joined(slow, {"slow", 1}));
    ASSERT_EQ(sent.size(), 1u);
    const auto next = answer(sent[0], {0, 60}, 0.06);
    ASSERT_EQ(next.size(), 1u);
    EXPECT_NE(next[0].job, sent[0].job);
}

TEST_F(DispatcherRanges, AClosedJobsTasksEndWithoutAnswers) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    const auto sent = ranges_in(dispatcher_.positions_given(job_1, {{0, 1000}}, 0));
    (void)dispatcher_.job_closed(job_1);
    EXPECT_EQ(dispatcher_.worker_status(slow).working, 0u);
    dispatcher_.check_invariants();
    EXPECT_TRUE(answer(sent[0], {0, 5}, 0.1).empty());
    EXPECT_TRUE(dispatcher_.task_ended(slow, sent[0].task).empty());
    EXPECT_TRUE(dispatcher_.tasks_of(slow).empty());
}

TEST_F(DispatcherRanges, MissingBlocksAreMeasured) {
    open(job_1, 1);
    EXPECT_FALSE(dispatcher_.missing_costs(job_1).any);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    (void)dispatcher_.worker_joined(fast, {"fast", 1});
    const double all = dispatcher_.missing_costs(job_1).all;
    EXPECT_NEAR(all,
                2 * (20 * 1280 / limits::link_bytes_per_second_start + 20 * timing::block_seconds),
                1e-9);
    EXPECT_NEAR(
        dispatcher_.missing_costs(job_1).of_byte * limits::link_bytes_per_second_start, 1, 1e-9);
    for (std::uint64_t i = 0; i < 64; ++i) {
        (void)dispatcher_.scenario_analysed(job_1, {i, {1, 2}, {3}, 100, 1000});
    }
    const MissingCosts costs = dispatcher_.missing_costs(job_1);
    ASSERT_TRUE(costs.any && costs.matched);
    EXPECT_LT(*costs.matched, *costs.any) << "best match sends them to where their blocks are";
    EXPECT_LT(costs.all, all);
    // With all blocks on all workers, nothing is missing.
    const std::vector<RootIndex> roots{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    for (const WorkerId worker : {slow, fast}) {
        dispatcher_.roots_wanted(worker, TreeId{1}, roots);
        dispatcher_.roots_wanted(worker, TreeId{2}, roots);
    }
    EXPECT_NEAR(dispatcher_.missing_costs(job_1).all, 0, 1e-12);
    (void)dispatcher_.roots_evicted(slow, TreeId{1}, roots);
    EXPECT_GT(dispatcher_.missing_costs(job_1).all, 0);
}

/// Workers that join, leave, answer in any order and return work. Lost positions come again.
class RangeRun {
  public:
    explicit RangeRun(std::uint64_t seed) : random_(seed) {
        (void)dispatcher_.job_opened(job_1, {}, {tree(1, 4), tree(2, 4)});
    }

    void run() {
        act(dispatcher_.positions_given(job_1, {{0, total}}, 0));
        for (int step = 0; step < 20'000 && answered_.count() != total; ++step) {
            dispatcher_.time_is(now_ += 0.01);
            random_event();
            for (const PositionRange& range : std::exchange(lost_, {})) {
                act(dispatcher_.positions_given(job_1, {range}, 0));
            }
            dispatcher_.check_invariants();
        }
        EXPECT_EQ(answered_.count(), total);
        EXPECT_TRUE(dispatcher_.unanalysed(job_1).is_empty());
        EXPECT_LE(repeated_, copied_);
        (void)dispatcher_.job_closed(job_1);
        dispatcher_.check_invariants();
    }
    [[nodiscard]] std::uint64_t copied() const { return copied_; }
    [[nodiscard]] std::uint64_t recalled() const { return recalled_; }

  private:
    static constexpr std::uint64_t total = 5000;

    struct Task {
        SendUnit sent;
        PositionSet open; ///< Neither answered nor returned nor called off.
    };

    template <class Map>
    auto any_of(Map& map) {
        return std::next(map.begin(), static_cast<std::ptrdiff_t>(random_() % map.size()));
    }
    void random_event() {
        const std::uint64_t dice = random_() % 100;
        if (workers_.size() < 2 || dice < 2) {
            const WorkerId id{++worker_last_};
            workers_.emplace(id, false);
            act(dispatcher_.worker_joined(id,
                                          {"w", 1 + static_cast<std::uint32_t>(random_() % 4)}));
        } else if (dice < 4) {
            const WorkerId id = any_of(workers_)->first;
            std::erase_if(tasks_, [&](const auto& task) { return task.second.sent.worker == id; });
            workers_.erase(id);
            act(dispatcher_.worker_lost(id));
        } else if (dice < 5) {
            auto& [id, draining] = *workers_.begin();
            draining = true;
            act(dispatcher_.worker_draining(id));
        } else if (!tasks_.empty()) {
            const auto task = any_of(tasks_);
            if (task->second.open.is_empty() || dice > 97) {
                end(task->first);
            } else {
                answer(task->first, task->second);
            }
        }
    }
    void answer(TaskId id, Task& task) {
        PositionSet some;
        for (const PositionRange& run : task.open.runs()) {
            const std::uint64_t first = random_() % run.count;
            some.add({run.first + first, 1 + random_() % (run.count - first)});
        }
        task.open.remove(some);
        repeated_ += answered_.common_with(some).count();
        answered_.add(some);
        const double seconds = 1e-4 * static_cast<double>(some.count());
        act(dispatcher_.answered({task.sent.worker, id, job_1, some, seconds}));
    }
    void end(TaskId id) {
        const auto task = tasks_.extract(id);
        act(dispatcher_.task_ended(task.mapped().sent.worker, id));
    }

    void act(const Actions& actions) {
        for (const Action& action : actions) {
            if (const auto* sent = std::get_if<SendUnit>(&action)) {
                ASSERT_TRUE(tasks_.emplace(sent->task, Task{*sent, sent->positions}).second);
                ASSERT_FALSE(workers_.at(sent->worker)) << "it drains";
                ASSERT_TRUE(answered_.common_with(sent->positions).is_empty());
                copied_ += sent->copy_of == TaskId{} ? 0 : sent->positions.count();
            } else if (const auto* ask = std::get_if<AskBack>(&action)) {
                give_back(*ask);
            } else if (const auto* loser = std::get_if<CallOff>(&action)) {
                call_off(*loser);
            } else if (const auto* lost = std::get_if<PositionsLost>(&action)) {
                ASSERT_TRUE(answered_.common_with(lost->positions).is_empty());
                lost_.insert(
                    lost_.end(), lost->positions.runs().begin(), lost->positions.runs().end());
            } else {
                recalled_ += std::get<UnitsReturned>(action).positions;
            }
        }
    }
    /// The worker has begun some more positions than it has answered.
    void give_back(const AskBack& ask) {
        const auto task = tasks_.find(ask.task);
        if (task == tasks_.end() || random_() % 4 == 0) {
            return;
        }
        PositionSet& open = task->second.open;
        const std::uint64_t kept =
            std::min(ask.positions.runs().front().first + random_() % 3, total);
        const PositionRange tail{kept, total - kept};
        open.remove(tail);
        act(dispatcher_.task_recalled(ask.worker, ask.task, tail));
    }
    void call_off(const CallOff& loser) {
        const auto task = tasks_.find(loser.task);
        ASSERT_NE(task, tasks_.end());
        ASSERT_EQ(task->second.sent.worker, loser.worker);
        if (random_() % 2 == 0) { // Otherwise the message comes too late.
            task->second.open.remove(loser.positions);
        }
    }

    std::mt19937_64 random_;
    Dispatcher dispatcher_;
    std::map<TaskId, Task> tasks_;
    std::map<WorkerId, bool> workers_; ///< True: draining.
    std::vector<PositionRange> lost_;
    PositionSet answered_;
    std::uint64_t repeated_ = 0;
    std::uint64_t copied_ = 0;
    std::uint64_t recalled_ = 0;
    std::uint64_t worker_last_ = 0;
    double now_ = 0;
};

TEST(DispatcherRangeRun, EveryPositionIsAnsweredWhateverWorkersDo) {
    std::uint64_t copied = 0;
    std::uint64_t recalled = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        RangeRun run(seed);
        run.run();
        ASSERT_FALSE(testing::Test::HasFailure());
        copied += run.copied();
        recalled += run.recalled();
    }
    EXPECT_GT(copied, 0u);
    EXPECT_GT(recalled, 0u);
}

// Totals over so many workers serve several events. Whatever that does to the sizes of ranges, a
// worker that joins late gets work at once, and no position is left over or sent twice.
TEST_F(DispatcherRanges, ManyWorkersShareAJobToItsEnd) {
    constexpr std::uint64_t workers = 4 * limits::workers_per_event;
    constexpr std::uint64_t count = 100'000;
    open(job_1, 1);
    std::vector<SendUnit> running;
    const auto keep = [&](const Actions& actions) {
        const auto sent = ranges_in(actions);
        running.insert(running.end(), sent.begin(), sent.end());
    };
    for (std::uint64_t i = 1; i <= workers; ++i) {
        keep(dispatcher_.worker_joined(WorkerId{i}, {"w", 1}));
    }
    keep(dispatcher_.positions_given(job_1, {{0, count}}, 0));
    std::map<WorkerId, std::uint64_t> answered;
    PositionSet all;
    for (std::size_t next = 0; next < running.size(); ++next) {
        const SendUnit unit = running[next];
        const PositionSet before = all;
        all.add(unit.positions);
        ASSERT_EQ(all.count() - before.count(), unit.positions.count()) << "sent twice";
        answered[unit.worker] += unit.positions.count();
        keep(dispatcher_.answered({unit.worker,
                                   unit.task,
                                   job_1,
                                   unit.positions,
                                   1e-3 * static_cast<double>(unit.positions.count())}));
        keep(dispatcher_.task_ended(unit.worker, unit.task));
        if (next == workers) {
            const std::size_t sent = running.size();
            keep(dispatcher_.worker_joined(WorkerId{workers + 1}, {"late", 1}));
            ASSERT_GT(running.size(), sent);
            EXPECT_EQ(running[sent].worker, WorkerId{workers + 1});
        }
    }
    EXPECT_EQ(all, PositionSet(PositionRange{0, count}));
    ASSERT_EQ(answered.size(), workers + 1);
    for (const auto& [worker, positions] : answered) {
        EXPECT_GT(positions, count / workers / 2) << worker.value;
        EXPECT_LT(positions, 2 * count / workers) << worker.value;
    }
}

} // namespace
} // namespace cd::tests
