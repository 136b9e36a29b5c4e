// Proves how ranges of positions are sent: to workers that run out of work, sized to last a batch's
// time at the measured rate, two per worker, smaller at the end. Every position is sent once
// (except speculative copies at the end) and every task ends once, whatever workers do or return.
// Also proves what is measured for the choice between ranges and analysis.
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"
#include "master/dispatch/dispatcher.hpp"
#include "master/jobs/place_queue.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <numeric>
#include <random>

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

std::vector<SendRange> ranges_in(const Actions& actions) {
    std::vector<SendRange> sent;
    for (const Action& action : actions) {
        if (const auto* range = std::get_if<SendRange>(&action)) {
            sent.push_back(*range);
        }
    }
    return sent;
}

class DispatcherRanges : public testing::Test {
  protected:
    void open(JobId job, std::uint64_t trees) {
        (void)dispatcher_.job_opened(job, {}, tree(trees, 10), tree(trees + 1, 10));
    }
    void TearDown() override { dispatcher_.check_invariants(); }

    Dispatcher dispatcher_;
};

TEST_F(DispatcherRanges, EachWorkerGetsTwoRangesAndAnotherWhenItAnswers) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    const auto first = ranges_in(dispatcher_.places_given(job_1, {0, 10'000}, 0));
    // Unmeasured defaults: a scenario takes 1 ms, a batch lasts 0.1 s.
    ASSERT_EQ(first.size(), 1u);
    EXPECT_EQ(first[0].places, (PlaceRange{0, 100}));
    EXPECT_EQ(dispatcher_.places_unsent(job_1), 9900u);
    // The worker is twice as fast as the default.
    const auto second = ranges_in(dispatcher_.places_answered(slow, first[0].task, 50, 0.025));
    ASSERT_EQ(second.size(), 1u);
    EXPECT_EQ(second[0].places, (PlaceRange{100, 200}));
    // The worker already has two ranges.
    EXPECT_TRUE(ranges_in(dispatcher_.places_answered(slow, first[0].task, 50, 0.025)).empty());
    EXPECT_EQ(dispatcher_.worker_status(slow).working, 200u);
    const auto third = ranges_in(dispatcher_.task_ended(slow, first[0].task));
    EXPECT_TRUE(third.empty()) << "it has enough to do";
}

TEST_F(DispatcherRanges, UnlikeWorkersGetUnlikeShares) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    (void)dispatcher_.worker_joined(fast, {"fast", 4});
    const auto first = ranges_in(dispatcher_.places_given(job_1, {0, 10'000}, 0));
    ASSERT_EQ(first.size(), 2u);
    EXPECT_EQ(first[0].places.count, 100u);
    EXPECT_EQ(first[1].places.count, 400u);
    // The measured rate is per thread.
    (void)dispatcher_.places_answered(slow, first[0].task, 100, 0.1);
    const auto next = ranges_in(dispatcher_.places_answered(fast, first[1].task, 400, 0.1));
    ASSERT_EQ(next.size(), 1u);
    EXPECT_EQ(next[0].worker, fast);
    EXPECT_EQ(next[0].places.count, 1600u);
}

TEST_F(DispatcherRanges, TowardsTheEndRangesShrink) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    (void)dispatcher_.worker_joined(fast, {"fast", 1});
    auto sent = ranges_in(dispatcher_.places_given(job_1, {0, 300}, 0));
    std::uint64_t next = 0;
    std::uint64_t last = 300;
    for (std::size_t i = 0; i < sent.size(); ++i) {
        EXPECT_EQ(sent[i].places.first, next);
        EXPECT_LE(sent[i].places.count, last);
        last = sent[i].places.count;
        next = sent[i].places.end();
        for (const SendRange& more : ranges_in(dispatcher_.places_answered(
                 sent[i].worker, sent[i].task, last, 1e-3 * static_cast<double>(last)))) {
            sent.push_back(more);
        }
        for (const SendRange& more :
             ranges_in(dispatcher_.task_ended(sent[i].worker, sent[i].task))) {
            sent.push_back(more);
        }
    }
    EXPECT_EQ(next, 300u);
    EXPECT_EQ(sent.front().places.count, 75u);
    EXPECT_EQ(last, 1u);
}

TEST_F(DispatcherRanges, RangesOfALostWorkerCountAsLostAndThoseOfADrainingWorkerDoNot) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    const auto sent = ranges_in(dispatcher_.places_given(job_1, {0, 1000}, 0));
    ASSERT_EQ(sent.size(), 1u);
    (void)dispatcher_.worker_joined(fast, {"fast", 1});
    (void)dispatcher_.worker_draining(slow);
    const RangeEnded handed_back{sent[0].task, job_1, sent[0].places, std::nullopt};
    const auto after = dispatcher_.task_ended(slow, sent[0].task);
    EXPECT_NE(std::find(after.begin(), after.end(), Action(handed_back)), after.end());
    EXPECT_EQ(dispatcher_.worker_status(fast).working, 100u);
    const auto lost = dispatcher_.worker_lost(fast);
    ASSERT_EQ(lost.size(), 1u);
    EXPECT_TRUE(std::get<RangeEnded>(lost[0]).lost_with);
}

TEST_F(DispatcherRanges, UnsentPositionsCanBeTakenBack) {
    open(job_1, 1);
    (void)dispatcher_.places_given(job_1, {0, 700}, 300);
    (void)dispatcher_.places_given(job_1, {700, 300}, 0);
    EXPECT_EQ(dispatcher_.places_unsent(job_1), 1000u);
    const std::vector<PlaceRange> expected{{0, 700}, {700, 300}};
    EXPECT_EQ(dispatcher_.take_places(job_1), expected);
    EXPECT_EQ(dispatcher_.places_unsent(job_1), 0u);
    EXPECT_TRUE(dispatcher_.worker_joined(slow, {"slow", 1}).empty());
}

TEST_F(DispatcherRanges, SeveralJobsTakeTurns) {
    open(job_1, 1);
    open(job_2, 3);
    (void)dispatcher_.places_given(job_1, {0, 5000}, 0);
    (void)dispatcher_.places_given(job_2, {0, 5000}, 0);
    const auto sent = ranges_in(dispatcher_.worker_joined(slow, {"slow", 1}));
    ASSERT_EQ(sent.size(), 1u);
    const auto next = ranges_in(dispatcher_.places_answered(slow, sent[0].task, 60, 0.06));
    ASSERT_EQ(next.size(), 1u);
    EXPECT_NE(next[0].job, sent[0].job);
}

TEST_F(DispatcherRanges, AClosedJobsTasksEndWithoutAnswers) {
    open(job_1, 1);
    (void)dispatcher_.worker_joined(slow, {"slow", 1});
    const auto sent = ranges_in(dispatcher_.places_given(job_1, {0, 1000}, 0));
    (void)dispatcher_.job_closed(job_1);
    EXPECT_EQ(dispatcher_.worker_status(slow).working, 0u);
    dispatcher_.check_invariants();
    EXPECT_TRUE(dispatcher_.places_answered(slow, sent[0].task, 5, 0.1).empty());
    EXPECT_EQ(dispatcher_.task_ended(slow, sent[0].task).size(), 1u);
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

/// Simulates workers that join, leave, answer and return work, and handles their tasks' ends.
TEST_F(DispatcherRanges, EveryPlaceIsAnsweredWhateverWorkersDo) {
    std::uint64_t copied_all = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        std::mt19937_64 random(seed);
        Dispatcher dispatcher;
        (void)dispatcher.job_opened(job_1, {}, tree(1, 4), tree(2, 4));
        constexpr std::uint64_t total = 5000;
        std::vector<int> answered(total, 0);
        struct Under {
            SendRange sent;
            std::uint64_t done = 0;
        };
        std::map<TaskId, Under> tasks;
        std::map<WorkerId, bool> workers; // True: draining.
        std::vector<PlaceRange> again;
        std::uint64_t copied = 0;
        std::uint64_t worker_last = 0;
        double now = 0;
        const auto give_again = [&](const PlaceRange& places) {
            std::vector<PlaceRange> runs{places};
            for (const auto& [id, task] : tasks) {
                runs = without(runs, task.sent.places);
            }
            for (std::uint64_t place = places.first; place < places.end(); ++place) {
                runs = answered[place] != 0 ? without(runs, {place, 1}) : runs;
            }
            again.insert(again.end(), runs.begin(), runs.end());
        };
        std::function<void(const Actions&)> act;
        // The worker has begun the positions after the answered ones, sometimes more.
        const auto give_back = [&](const AskBack& ask) {
            const auto task = tasks.find(ask.task);
            if (task == tasks.end() || random() % 4 == 0) {
                return;
            }
            PlaceRange& places = task->second.sent.places;
            const std::uint64_t begun = std::min(places.count, task->second.done + random() % 3);
            const PlaceRange kept{places.first, std::max(begun, ask.places)};
            const PlaceRange given{kept.end(), places.count - kept.count};
            places = kept;
            const Recalled answer{ask.task, {}, kept.count};
            const Actions more = dispatcher.task_recalled(ask.worker, answer);
            if (given.count != 0) {
                const GivenBack expected{ask.task, job_1, 0, given};
                ASSERT_NE(std::ranges::find(more, Action(expected)), more.end());
            }
            act(more);
        };
        act = [&](const Actions& actions) {
            for (const Action& action : actions) {
                if (const auto* sent = std::get_if<SendRange>(&action)) {
                    ASSERT_TRUE(tasks.emplace(sent->task, Under{*sent}).second);
                    ASSERT_TRUE(workers.contains(sent->worker));
                    ASSERT_FALSE(workers.at(sent->worker));
                    copied += sent->copy_of == TaskId{} ? 0 : sent->places.count;
                } else if (const auto* ask = std::get_if<AskBack>(&action)) {
                    give_back(*ask);
                } else if (const auto* given = std::get_if<GivenBack>(&action)) {
                    give_again(given->places);
                } else if (const auto* ended = std::get_if<RangeEnded>(&action)) {
                    const auto task = tasks.extract(ended->task);
                    ASSERT_FALSE(task.empty());
                    ASSERT_EQ(task.mapped().sent.places, ended->places);
                    give_again(ended->places);
                }
            }
        };
        act(dispatcher.places_given(job_1, {0, total}, 0));
        const auto is_done = [&] {
            return std::ranges::none_of(answered, [](int times) { return times == 0; });
        };
        for (int step = 0; step < 20'000 && !is_done(); ++step) {
            dispatcher.time_is(now += 0.01);
            const std::uint64_t dice = random() % 100;
            if (workers.size() < 2 || dice < 2) {
                const WorkerId id{++worker_last};
                workers.emplace(id, false);
                act(dispatcher.worker_joined(id,
                                             {"w", 1 + static_cast<std::uint32_t>(random() % 4)}));
            } else if (dice < 4) {
                const WorkerId id =
                    std::next(workers.begin(),
                              static_cast<std::ptrdiff_t>(random() % workers.size()))
                        ->first;
                act(dispatcher.worker_lost(id));
                workers.erase(id);
            } else if (dice < 5) {
                auto& [id, draining] = *workers.begin();
                draining = true;
                act(dispatcher.worker_draining(id));
            } else if (!tasks.empty()) {
                auto& [id, task] =
                    *std::next(tasks.begin(), static_cast<std::ptrdiff_t>(random() % tasks.size()));
                const std::uint64_t left = task.sent.places.count - task.done;
                if (left == 0 || dice > 97) {
                    const TaskId ended = id;
                    act(dispatcher.task_ended(task.sent.worker, ended));
                } else {
                    const std::uint64_t count = 1 + random() % left;
                    for (std::uint64_t i = 0; i < count; ++i) {
                        ++answered[task.sent.places.first + task.done + i];
                    }
                    task.done += count;
                    act(dispatcher.places_answered(
                        task.sent.worker, id, count, 1e-4 * static_cast<double>(count)));
                }
            }
            for (const PlaceRange& places : std::exchange(again, {})) {
                act(dispatcher.places_given(job_1, places, 0));
            }
            dispatcher.check_invariants();
        }
        ASSERT_TRUE(is_done()) << "seed " << seed;
        const auto answers = std::accumulate(answered.begin(), answered.end(), std::uint64_t{0});
        ASSERT_LE(answers, total + copied);
        copied_all += copied;
        (void)dispatcher.job_closed(job_1);
        dispatcher.check_invariants();
    }
    EXPECT_GT(copied_all, 0u);
}

} // namespace
} // namespace cd::tests
