// Proves that a worker's session, over a real connection to a master played by the test, answers
// its scenarios exactly as one process does on whole trees, and that every way of ending it neither
// loses nor invents a result.
#include "common/job/packed_scenarios.hpp"
#include "tests/worker/session_stage.hpp"

#include <gmock/gmock.h>

#include <latch>

namespace cd::tests {
namespace {

TEST(Session, AnswersBatchesAsWholeTreesDo) {
    const auto how = perform(unlimited, 2, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(0, 60);
        const auto send = [&](std::uint64_t task, std::size_t first) {
            WorkUnit batch = make_batch(TaskId{task}, std::span(scenarios).subspan(first, 20));
            batch.results_wait_ms = 1000;
            master.channel->send(std::move(batch));
        };
        send(1, 0);
        send(2, 20);
        co_await master.serve_until_ended(2);
        send(3, 40);
        co_await master.serve_until_ended(3);
        expect_all_right(master, scenarios);
        EXPECT_EQ(master.subtrees_evicted, 0u);
        EXPECT_GE(master.heartbeats, 1u);
        // Results are batched: far fewer messages than scenarios.
        EXPECT_LT(master.results_messages, 20u);
    });
    EXPECT_EQ(how, SessionEnd::Lost);
}

TEST(Session, ACacheTooSmallForAScenarioStillGivesEveryResult) {
    perform(1, 2, [](Stage& master) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(100, 20);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        co_await master.serve_until_ended(1);
        expect_all_right(master, scenarios);
        EXPECT_GT(master.subtrees_evicted, 0u);
    });
}

TEST(Session, AnswersRangesAsWholeTreesDoWithCachesColdWarmOrTooSmall) {
    for (const std::uint64_t cache_bytes : {unlimited, std::uint64_t{1}}) {
        perform(cache_bytes, 2, [](Stage& master) -> asio::awaitable<void> {
            const auto scenarios = make_scenarios(0, 120);
            master.channel->send(make_range(TaskId{1}, std::span(scenarios).first(50)));
            master.channel->send(make_batch(TaskId{2}, std::span(scenarios).subspan(50, 20)));
            co_await master.serve_until_ended(2);
            master.channel->send(make_range(TaskId{3}, std::span(scenarios).subspan(70)));
            co_await master.serve_until_ended(3);
            expect_all_right(master, scenarios);
        });
    }
}

TEST(Session, ARangeOfAGridNeedsNoPoses) {
    Grid grid;
    grid.position[0] = {-1.5, 1.5, 9};
    grid.position[1] = {-1, 1, 5};
    grid.rotation[2] = rotation_axis({0, 90, 3}, 2);
    const auto play = [&](Stage& master) -> asio::awaitable<void> {
        master.add_job(encode_grid(grid));
        master.channel->send(WorkUnit{TaskId{1}, JobId{1}, 5, 100, {}, {}, {}});
        co_await master.serve_until_ended(1);
        std::vector<Scenario> scenarios;
        for (std::uint64_t place = 5; place < 105; ++place) {
            scenarios.push_back(scenario_on(grid, place));
        }
        expect_all_right(master, scenarios);
    };
    perform(unlimited, 2, play, false);
}

TEST(Session, HeartbeatsComeWhileEveryThreadIsBusyAndSayForHowLong) {
    perform(unlimited, 2, [](Stage& stage) -> asio::awaitable<void> {
        std::latch released(1);
        for (int thread = 0; thread < 2; ++thread) {
            stage.executor.submit([&released] {
                released.wait();
                return Executor::Continuation([] {});
            });
        }
        stage.channel->send(make_batch(TaskId{1}, make_scenarios(0, 2)));
        const std::function<bool()> beats = [&] { return stage.heartbeats >= 3; };
        co_await stage.serve_until(beats);
        EXPECT_TRUE(stage.records.empty());
        released.count_down();
        co_await stage.serve_until_ended(1);
    });
}

/// The session is in the middle of its work when the master says Drain, or the worker stops.
TEST(Session, WhatHasNotBegunIsHandedBackWhenItDrains) {
    for (const bool is_range : {true, false}) {
        for (const bool is_asked : {true, false}) {
            const Play play = [&](Stage& master) -> asio::awaitable<void> {
                const auto scenarios = make_scenarios(500, is_range ? 3000 : 300);
                master.channel->send(is_range ? make_range(TaskId{1}, scenarios)
                                              : make_batch(TaskId{1}, scenarios));
                const std::function<bool()> has_begun = [&] {
                    return master.results_messages != 0;
                };
                co_await master.serve_until(has_begun);
                if (is_asked) {
                    master.channel->send(Drain{});
                } else {
                    master.session->stop();
                }
                co_await master.serve_until_ended(2);
                EXPECT_TRUE(master.worker_drains);
                EXPECT_TRUE(master.ended.contains(TaskId{1}));
                if (is_range) {
                    EXPECT_LT(master.records.size(), scenarios.size());
                }
                for (const auto& [index, record] : master.records) {
                    EXPECT_EQ(record, expected_record(scenarios[index - 500]));
                }
                EXPECT_FALSE(master.end.empty()) << "it closed";
            };
            EXPECT_EQ(perform(unlimited, 1, play), SessionEnd::Drained);
        }
    }
}

/// Waits until a thread is inside scenario 0 of job 2, which takes long: half a million near
/// contacts.
asio::awaitable<void> begin_what_takes_long(FakeMaster& master, const CutBody& dense) {
    master.other_body = &dense;
    const TreeId tree{7};
    master.channel->send(dense.add(tree));
    master.channel->send(AddJob{JobId{2}, {tree, tree}, {}, std::nullopt});
    WorkUnit batch;
    batch.task = TaskId{1};
    batch.job = JobId{2};
    batch.count = 1;
    std::vector<Scenario> scenario(1);
    batch.scenarios = pack_scenarios(scenario);
    batch.pairs = colliding_roots(dense.top, dense.top, scenario.front().poses).value().pairs;
    batch.pair_offsets = {0, static_cast<std::uint32_t>(batch.pairs.size())};
    master.channel->send(batch);
    const std::function<bool()> runs = [&] { return master.last_longest.has_value(); };
    co_await master.serve_until(runs);
}

TEST(Session, WhatTakesTooLongIsHandedBackTooWhenItHasToEnd) {
    const CutBody dense = cut_body(make_sphere(7), 1);
    const auto play = [&](Stage& master) -> asio::awaitable<void> {
        co_await begin_what_takes_long(master, dense);
        master.session->stop();
        master.session->hand_back();
        co_await master.serve_until_ended(2); // Until the connection ends.
        EXPECT_TRUE(master.ended.contains(TaskId{1}));
        EXPECT_TRUE(master.records.empty());
    };
    EXPECT_EQ(perform(unlimited, 1, play), SessionEnd::Drained);
}

TEST(Session, WhatIsCancelledInsideItsRunStopsThereAndItsThreadIsFree) {
    const CutBody dense = cut_body(make_sphere(7), 1);
    const std::vector<Message> cancels{DropScenario{JobId{2}, 0}, RemoveJob{JobId{2}}};
    for (const Message& cancel : cancels) {
        perform(unlimited, 1, [&](Stage& master) -> asio::awaitable<void> {
            co_await begin_what_takes_long(master, dense);
            master.channel->send(cancel);
            const auto scenarios = make_scenarios(100, 30);
            master.channel->send(make_batch(TaskId{2}, scenarios));
            co_await master.serve_until_ended(2);
            expect_all_right(master, scenarios); // And no others.
        });
    }
}

TEST(Session, TerminateEndsAtOnce) {
    const auto how = perform(unlimited, 1, [](Stage& master) -> asio::awaitable<void> {
        master.channel->send(Terminate{"enough"});
        co_await master.serve_until_ended(1);
    });
    EXPECT_EQ(how, SessionEnd::Terminated);
}

/// Returns the session's error report before it closes.
std::string complaint_about(const Message& message) {
    std::string complaint;
    const auto how = perform(unlimited, 1, [&](Stage& master) -> asio::awaitable<void> {
        master.channel->send(message);
        co_await master.serve_until_ended(1);
        complaint = master.complaint;
    });
    EXPECT_EQ(how, SessionEnd::Disagreed);
    return complaint;
}

TEST(Session, DisagreementEndsTheConnectionWithAReason) {
    const auto scenarios = make_scenarios(0, 2);
    EXPECT_THAT(complaint_about(AddJob{JobId{2}, {tree_a, TreeId{99}}, {}, {}}),
                testing::HasSubstr("tree that is not here"));
    EXPECT_THAT(complaint_about(AddJob{JobId{1}, {tree_a, tree_b}, {}, {}}),
                testing::HasSubstr("already"));
    WorkUnit unknown_job = make_batch(TaskId{1}, scenarios);
    unknown_job.job = JobId{99};
    EXPECT_THAT(complaint_about(unknown_job), testing::HasSubstr("job that is not here"));

    WorkUnit unknown_root = make_batch(TaskId{1}, std::span(scenarios).first(1));
    unknown_root.pairs = {{0, 1u << 30}};
    unknown_root.pair_offsets = {0, 1};
    EXPECT_THAT(complaint_about(unknown_root), testing::HasSubstr("root"));

    EXPECT_THAT(complaint_about(Hint{JobId{1}, TreeId{99}, {0}}), testing::HasSubstr("hint"));
    EXPECT_THAT(complaint_about(Hint{JobId{99}, tree_a, {0}}), testing::HasSubstr("hint"));
    EXPECT_THAT(complaint_about(Hint{JobId{1}, tree_a, {0, 1u << 30}}),
                testing::HasSubstr("does not exist"));

    WorkUnit few = make_batch(TaskId{1}, scenarios);
    few.count = 1;
    few.pairs = {};
    few.pair_offsets = {0, 0};
    EXPECT_THAT(complaint_about(few), testing::HasSubstr("2 of them, and at most 1"));

    AddTree no_tree = bodies().a.add(TreeId{9});
    no_tree.roots = 0;
    EXPECT_THAT(complaint_about(no_tree), testing::HasSubstr("impossible number of roots"));
    no_tree.roots = no_tree.triangles + 1;
    EXPECT_THAT(complaint_about(no_tree), testing::HasSubstr("impossible number of roots"));
    EXPECT_NE(complaint_about(bodies().a.add(tree_a)), "") << "twice";
    EXPECT_THAT(complaint_about(Accepted{JobId{1}}), testing::HasSubstr("accepted"));

    Subtrees wrong;
    wrong.tree = tree_a;
    wrong.blocks = {bodies().a.blocks[0]};
    wrong.blocks[0].hash.bytes[0] ^= std::byte{1};
    EXPECT_THAT(complaint_about(wrong), testing::HasSubstr("hash"));
    EXPECT_THAT(complaint_about(Subtrees{tree_a, {bodies().b.top_block}}),
                testing::HasSubstr("an upper tree of 16 roots"));
}

} // namespace
} // namespace cd::tests
