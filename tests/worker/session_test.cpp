// Proves that a worker's session, over a real connection to a master that the test plays, answers
// what it is given exactly as one process does on whole trees; asks only for what it lacks; frees
// what is removed; and ends in every way that it may end without losing or inventing a result.
#include "worker/session.hpp"

#include "common/core/limits.hpp"
#include "common/job/packed_records.hpp"
#include "tests/proto/loopback.hpp"
#include "tests/proto/sample_messages.hpp"
#include "tests/worker/cut_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <latch>
#include <map>
#include <numeric>
#include <set>

namespace cd::tests {
namespace {

constexpr TreeId tree_a{3};
constexpr TreeId tree_b{4};
/// So that several heartbeats come soon; nothing hangs on how soon.
constexpr SessionTimes quick_times{std::chrono::milliseconds(10), patience};
constexpr std::uint64_t unlimited = std::uint64_t{1} << 40;

struct Bodies {
    CutBody a = cut_body(make_torus(1, 0.4, 40, 20), 5);
    CutBody b = cut_body(make_sphere(3), 4);
};

const Bodies& bodies() {
    static const Bodies made;
    return made;
}

std::vector<Scenario> make_scenarios(std::uint64_t first, std::uint64_t count) {
    std::vector<Scenario> scenarios;
    for (std::uint64_t index = first; index < first + count; ++index) {
        std::mt19937_64 random(index);
        Scenario scenario;
        scenario.index = index;
        scenario.poses.b = make_pose(random, 1.5);
        scenarios.push_back(scenario);
    }
    return scenarios;
}

Batch make_batch(TaskId task, std::span<const Scenario> scenarios) {
    Batch batch;
    batch.task = task;
    batch.job = JobId{1};
    batch.scenarios = pack_scenarios(scenarios);
    batch.pair_offsets = {0};
    for (const Scenario& scenario : scenarios) {
        const auto pairs = colliding_roots(bodies().a.top, bodies().b.top, scenario.poses).value();
        batch.pairs.insert(batch.pairs.end(), pairs.begin(), pairs.end());
        batch.pair_offsets.push_back(static_cast<std::uint32_t>(batch.pairs.size()));
    }
    return batch;
}

ScenarioRange make_range(TaskId task, std::span<const Scenario> scenarios) {
    return {task, JobId{1}, 0, scenarios.size(), pack_scenarios(scenarios)};
}

/// What one process says, before `inside` is settled: that takes whole bodies.
Bytes expected_record(const Scenario& scenario) {
    const std::vector<SubtreePair> whole{{bodies().a.tree.view(), bodies().b.tree.view()}};
    return encode_result(run_on_subtrees(whole, scenario, Query{}).result);
}

/// Plays the master: sends what is wanted, and keeps what comes.
class FakeMaster {
  public:
    explicit FakeMaster(std::shared_ptr<Channel> to_worker) : channel(std::move(to_worker)) {}

    void add_job(std::optional<Bytes> grid = std::nullopt) {
        channel->send(bodies().a.add(tree_a));
        channel->send(bodies().b.add(tree_b));
        channel->send(AddJob{JobId{1}, tree_a, tree_b, {}, std::move(grid)});
    }

    /// Serves until so many tasks have ended, or the connection has.
    asio::awaitable<void> serve_until_ended(std::size_t tasks) {
        while (ended.size() < tasks) {
            Result<Message> message = co_await channel->receive(patience);
            if (!message) {
                end = message.error().detail;
                break;
            }
            std::visit([this](auto& content) { on(content); }, message.value());
        }
    }

    void on(const WantSubtrees& want) {
        const CutBody& body = want.tree == tree_a ? bodies().a : bodies().b;
        Subtrees subtrees;
        subtrees.tree = want.tree;
        for (const RootIndex root : want.roots) {
            bytes_sent += body.blocks[root].compressed.size();
            EXPECT_TRUE(held.insert({want.tree, root}).second) << "asked for what it holds";
            given.insert({want.tree, root});
            subtrees.blocks.push_back(body.blocks[root]);
            ++subtrees_sent;
        }
        channel->send(subtrees);
    }
    void on(const Evicted& evicted) {
        for (const RootIndex root : evicted.roots) {
            EXPECT_EQ(held.erase({evicted.tree, root}), 1u) << "let go what it never held";
            ++subtrees_evicted;
        }
    }
    void on(const Held& now_held) {
        for (const RootIndex root : now_held.roots) {
            const SubtreeKey key{now_held.tree, root};
            EXPECT_TRUE(held.contains(key) || given.contains(key)) << "it was not given that";
        }
    }
    void on(const Results& results) {
        EXPECT_FALSE(ended.contains(results.task));
        ++results_messages;
        traffic += results.traffic;
        tasks_of_results.insert(results.task);
        if (acknowledges) {
            channel->send(ResultsKept{{results.sequence}});
        }
        const Bytes bytes = unpack_records(results.records, limits::results_bytes_max).value();
        ByteReader in(bytes);
        for (std::uint32_t i = 0; i < results.count; ++i) {
            const auto size = in.get<std::uint32_t>();
            const auto characters = in.get_array<std::uint8_t>(size);
            Bytes record(characters.size());
            std::memcpy(record.data(), characters.data(), characters.size());
            const ScenarioResult result = decode_result(record).value();
            EXPECT_TRUE(records.emplace(result.index, record).second) << "answered twice";
        }
        EXPECT_TRUE(in.complete());
    }
    void on(const EndOfTask& end_of_task) { EXPECT_TRUE(ended.insert(end_of_task.task).second); }
    void on(const Holding& holding) { cuts_held = holding.cuts; }
    void on(const Standing& now) { standing = now; }
    void on(const Recalled& back) { recalled.push_back(back); }
    void on(const Heartbeat& heartbeat) {
        ++heartbeats;
        last_traffic = heartbeat.traffic;
    }
    void on(const Drain&) { worker_drains = true; }
    void on(const Failure& failure) { complaint = failure.detail; }
    template <class T>
    void on(const T&) {
        ADD_FAILURE() << "a message that no worker sends";
    }

    std::shared_ptr<Channel> channel;
    std::set<SubtreeKey> held;
    /// Also over connections of before: a block that came shortly before the end counts later.
    std::set<SubtreeKey> given;
    std::map<std::uint64_t, Bytes> records;
    std::set<TaskId> ended;
    std::set<TaskId> tasks_of_results;
    std::vector<Sha256> cuts_held; ///< That it named at its start.
    std::optional<Standing> standing;
    std::vector<Recalled> recalled;
    bool acknowledges = true;
    std::size_t subtrees_sent = 0;
    std::size_t subtrees_evicted = 0;
    std::size_t results_messages = 0;
    std::size_t heartbeats = 0;
    std::uint64_t bytes_sent = 0; ///< Of blocks.
    BlockTraffic traffic;         ///< As the results told.
    CacheTraffic last_traffic;    ///< As the last heartbeat did.
    bool worker_drains = false;
    std::string complaint;
    std::string end;
};

asio::awaitable<void> run_session(std::shared_ptr<Session> session,
                                  std::optional<SessionEnd>& how) {
    how = co_await session->run();
    if (how == SessionEnd::Lost) {
        session->leave();
    }
}

/// A session with its threads, and the master that the test plays.
struct Stage {
    std::shared_ptr<Session> session;
    FakeMaster master;
    std::optional<SessionEnd>& how;
    Executor& executor;
};

using Play = std::function<asio::awaitable<void>(Stage&)>;

asio::awaitable<void> play_on(asio::io_context& context,
                              Executor& executor,
                              std::uint64_t cache_bytes,
                              const Play& play,
                              bool adds_job,
                              const std::shared_ptr<WorkerKeep>& keep,
                              std::optional<SessionEnd>& how) {
    Ends ends = co_await connect_greeted_ends();
    Stage stage{std::make_shared<Session>(
                    std::move(ends.left), executor, cache_bytes, PeerParts{}, keep, quick_times),
                FakeMaster(std::move(ends.right)),
                how,
                executor};
    spawn(context.get_executor(), "session", run_session(stage.session, how));
    if (adds_job) {
        stage.master.add_job();
    }
    co_await play(stage);
    stage.master.channel->close();
}

/// Runs to the end of the play and of the session; says how the session ended.
std::optional<SessionEnd> perform(std::uint64_t cache_bytes,
                                  unsigned threads,
                                  const Play& play,
                                  bool adds_job = true,
                                  const std::shared_ptr<WorkerKeep>& keep = nullptr) {
    asio::io_context context;
    Executor executor(context.get_executor(), threads);
    std::optional<SessionEnd> how;
    asio::co_spawn(context,
                   play_on(context, executor, cache_bytes, play, adds_job, keep, how),
                   [](const std::exception_ptr& thrown) { EXPECT_FALSE(thrown); });
    context.run_for(patience);
    EXPECT_TRUE(context.stopped()) << "something is still under way";
    return how;
}

void expect_all_right(const FakeMaster& master, std::span<const Scenario> scenarios) {
    EXPECT_EQ(master.records.size(), scenarios.size());
    std::size_t contacts = 0;
    for (const Scenario& scenario : scenarios) {
        const auto record = master.records.find(scenario.index);
        if (record == master.records.end()) {
            ADD_FAILURE() << "no result of scenario " << scenario.index;
            continue;
        }
        EXPECT_EQ(record->second, expected_record(scenario)) << scenario.index;
        contacts += decode_result(record->second).value().pair_count == 0 ? 0u : 1u;
    }
    EXPECT_GT(contacts, scenarios.size() / 10);
}

TEST(Session, AnswersBatchesAsWholeTreesDo) {
    const auto how = perform(unlimited, 2, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        const auto scenarios = make_scenarios(0, 60);
        master.channel->send(make_batch(TaskId{1}, std::span(scenarios).first(20)));
        master.channel->send(make_batch(TaskId{2}, std::span(scenarios).subspan(20, 20)));
        co_await master.serve_until_ended(2);
        master.channel->send(make_batch(TaskId{3}, std::span(scenarios).subspan(40)));
        co_await master.serve_until_ended(3);
        expect_all_right(master, scenarios);
        EXPECT_EQ(master.subtrees_evicted, 0u);
        EXPECT_GE(master.heartbeats, 1u);
        // Bulk: far fewer messages than scenarios.
        EXPECT_LT(master.results_messages, 20u);
    });
    EXPECT_EQ(how, SessionEnd::Lost);
}

TEST(Session, ACacheTooSmallForAScenarioStillGivesEveryResult) {
    perform(1, 2, [](Stage& stage) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(100, 20);
        stage.master.channel->send(make_batch(TaskId{1}, scenarios));
        co_await stage.master.serve_until_ended(1);
        expect_all_right(stage.master, scenarios);
        EXPECT_GT(stage.master.subtrees_evicted, 0u);
    });
}

TEST(Session, AnswersRangesAsWholeTreesDoWithCachesColdWarmOrTooSmall) {
    for (const std::uint64_t cache_bytes : {unlimited, std::uint64_t{1}}) {
        perform(cache_bytes, 2, [](Stage& stage) -> asio::awaitable<void> {
            FakeMaster& master = stage.master;
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

TEST(Session, ResultsTellWhatTheirJobCostTheNetwork) {
    perform(unlimited, 2, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        const auto scenarios = make_scenarios(0, 120);
        master.channel->send(make_batch(TaskId{1}, std::span(scenarios).first(40)));
        co_await master.serve_until_ended(1);
        EXPECT_GT(master.traffic.misses, 0u);
        EXPECT_EQ(master.traffic.misses, master.subtrees_sent);
        const Batch again = make_batch(TaskId{2}, std::span(scenarios).first(40));
        std::uint64_t needs = 0;
        for (std::size_t i = 0; i < 40; ++i) {
            const auto pairs = std::span(again.pairs)
                                   .subspan(again.pair_offsets[i],
                                            again.pair_offsets[i + 1] - again.pair_offsets[i]);
            needs += roots_of_a(pairs).size() + roots_of_b(pairs).size();
        }
        // In a range, too, each scenario counts.
        const std::uint64_t hits_before = master.traffic.hits;
        master.records.clear();
        master.channel->send(make_range(TaskId{2}, std::span(scenarios).first(40)));
        co_await master.serve_until_ended(2);
        EXPECT_EQ(master.traffic.hits, hits_before + needs);
        master.channel->send(make_range(TaskId{3}, std::span(scenarios).subspan(40)));
        co_await master.serve_until_ended(3);
        EXPECT_EQ(master.traffic.misses, master.subtrees_sent);
        EXPECT_EQ(master.traffic.master_bytes, master.bytes_sent);
        EXPECT_EQ(master.traffic.peer_bytes, 0u);
        EXPECT_EQ(master.traffic.evictions, 0u);
    });
}

TEST(Session, EvictionsCountForTheJobWhoseTreeTheyAreOf) {
    perform(1, 1, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        const auto scenarios = make_scenarios(100, 20);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        co_await master.serve_until_ended(1);
        EXPECT_GT(master.traffic.evictions, 0u);
        EXPECT_LE(master.traffic.evictions, master.subtrees_evicted);
        EXPECT_EQ(master.traffic.master_bytes, master.bytes_sent);
    });
}

TEST(Session, ARangeOfAGridNeedsNoPoses) {
    Grid grid;
    grid.position[0] = {-1.5, 1.5, 9};
    grid.position[1] = {-1, 1, 5};
    grid.rotation[2] = rotation_axis({0, 90, 3}, 2);
    const auto play = [&](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        master.add_job(encode_grid(grid));
        master.channel->send(ScenarioRange{TaskId{1}, JobId{1}, 5, 100, {}});
        co_await master.serve_until_ended(1);
        std::vector<Scenario> scenarios;
        for (std::uint64_t place = 5; place < 105; ++place) {
            scenarios.push_back(scenario_on(grid, place));
        }
        expect_all_right(master, scenarios);
    };
    perform(unlimited, 2, play, false);
}

TEST(Session, WhatWaitsForARemovedJobIsDroppedAndItsTreesStay) {
    perform(unlimited, 1, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        const auto scenarios = make_scenarios(600, 400);
        master.channel->send(make_range(TaskId{1}, scenarios));
        master.channel->send(RemoveJob{JobId{1}});
        master.channel->send(AddJob{JobId{1}, tree_a, tree_b, {}, {}});
        co_await master.serve_until_ended(1);
        EXPECT_LT(master.records.size(), scenarios.size());
        master.records.clear();
        master.channel->send(make_range(TaskId{2}, std::span(scenarios).first(30)));
        co_await master.serve_until_ended(2);
        expect_all_right(master, std::span(scenarios).first(30));
    });
}

TEST(Session, StopHandsBackTheRestOfARange) {
    const auto how = perform(unlimited, 1, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        const auto scenarios = make_scenarios(500, 3000);
        master.channel->send(make_range(TaskId{1}, scenarios));
        while (master.results_messages == 0) {
            Result<Message> message = co_await master.channel->receive(patience);
            std::visit([&](auto& content) { master.on(content); }, message.value());
        }
        stage.session->stop();
        co_await master.serve_until_ended(2);
        EXPECT_TRUE(master.ended.contains(TaskId{1}));
        for (const auto& [index, record] : master.records) {
            EXPECT_EQ(record, expected_record(scenarios[index - 500]));
        }
    });
    EXPECT_EQ(how, SessionEnd::Drained);
}

TEST(Session, RemovedTreesAreFreedAndMayComeAgain) {
    perform(unlimited, 1, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        const auto scenarios = make_scenarios(200, 10);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        co_await master.serve_until_ended(1);
        const std::size_t sent_before = master.subtrees_sent;
        EXPECT_GT(sent_before, 0u);

        master.channel->send(RemoveTree{tree_a});
        master.channel->send(RemoveTree{tree_b});
        master.add_job();
        master.held.clear();
        master.records.clear();
        master.channel->send(make_batch(TaskId{2}, scenarios));
        co_await master.serve_until_ended(2);
        expect_all_right(master, scenarios);
        EXPECT_EQ(master.subtrees_sent, 2 * sent_before) << "nothing of it was kept";
    });
}

TEST(Session, WhatWaitsForARemovedTreeIsDroppedWithIt) {
    perform(unlimited, 1, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        const auto scenarios = make_scenarios(300, 10);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        master.channel->send(RemoveTree{tree_b});
        // Its wants are not served: the removal comes first.
        while (!master.ended.contains(TaskId{1})) {
            Result<Message> message = co_await master.channel->receive(patience);
            EXPECT_TRUE(message);
            if (!message) {
                break;
            }
            if (const auto* ended = std::get_if<EndOfTask>(&message.value())) {
                master.on(*ended);
            }
        }
        EXPECT_LT(master.records.size(), scenarios.size());
    });
}

TEST(Session, WhatIsNotAcknowledgedIsSentAgainAndSubtreesAreKept) {
    const auto keep = std::make_shared<WorkerKeep>(unlimited);
    keep->enter(some_hash(1));
    const auto scenarios = make_scenarios(600, 30);
    std::map<std::uint64_t, Bytes> first_time;
    const Play first = [&](Stage& stage) -> asio::awaitable<void> {
        stage.master.acknowledges = false;
        stage.master.channel->send(make_batch(TaskId{1}, scenarios));
        co_await stage.master.serve_until_ended(1);
        EXPECT_TRUE(stage.master.cuts_held.empty());
        first_time = stage.master.records;
    };
    perform(unlimited, 1, first, true, keep);
    keep->enter(some_hash(1));

    const auto more = make_scenarios(630, 10);
    const Play second = [&](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        for (RootIndex root = 0; root < bodies().a.blocks.size(); ++root) {
            master.held.insert({tree_a, root}); // So that asking for one is an error.
        }
        for (RootIndex root = 0; root < bodies().b.blocks.size(); ++root) {
            master.held.insert({tree_b, root});
        }
        master.channel->send(make_batch(TaskId{1}, scenarios));
        // The results of before come first, and count for no task of now.
        while (master.records.size() < scenarios.size()) {
            Result<Message> message = co_await master.channel->receive(patience);
            EXPECT_TRUE(message);
            if (!message) {
                co_return;
            }
            std::visit([&](auto& content) { master.on(content); }, message.value());
        }
        EXPECT_EQ(master.records, first_time);
        EXPECT_EQ(master.tasks_of_results, std::set<TaskId>{TaskId{0}});
        EXPECT_EQ(master.cuts_held.size(), 2u);
        master.records.clear();
        co_await master.serve_until_ended(1);
        expect_all_right(master, scenarios);
        EXPECT_EQ(master.subtrees_sent, 0u);
    };
    perform(unlimited, 1, second, true, keep);
    keep->enter(some_hash(1));
    EXPECT_TRUE(keep->results.empty()) << "all were acknowledged";
    EXPECT_EQ(keep->cache.parked().size(), 2u);
    keep->enter(some_hash(2));
    EXPECT_TRUE(keep->cache.parked().empty()) << "of another cluster";
}

/// A session that outlives its connections. The master, which the test plays, keeps what it heard.
asio::awaitable<void>
lose_the_connection_again_and_again(asio::io_context& context, Executor& executor, int losses) {
    Ends ends = co_await connect_greeted_ends();
    const auto session = std::make_shared<Session>(
        std::move(ends.left), executor, unlimited, PeerParts{}, nullptr, quick_times);
    FakeMaster master(std::move(ends.right));
    master.acknowledges = false;
    const auto scenarios = make_scenarios(700, 200);
    master.add_job();
    for (std::uint64_t task = 1; task <= 4; ++task) {
        const auto part = std::span(scenarios).subspan(50 * (task - 1), 50);
        task % 2 == 0 ? master.channel->send(make_batch(TaskId{task}, part))
                      : master.channel->send(make_range(TaskId{task}, part));
    }
    std::map<std::uint64_t, Bytes> records;
    std::set<TaskId> standing{TaskId{1}, TaskId{2}, TaskId{3}, TaskId{4}};
    for (int connection = 0; connection <= losses; ++connection) {
        std::optional<SessionEnd> how;
        const auto serve = [](std::shared_ptr<Session> of,
                              std::shared_ptr<Channel> over,
                              std::optional<SessionEnd>& end) -> asio::awaitable<void> {
            if (over == nullptr) {
                end = co_await of->run();
            } else {
                end = co_await of->resume(over);
            }
        };
        std::shared_ptr<Channel> over;
        if (connection != 0) {
            Ends next = co_await connect_greeted_ends();
            over = std::move(next.left);
            master.channel = std::move(next.right);
            master.records.clear();
            master.ended.clear();
            master.held.clear(); // What it awaits it asks for again.
            master.standing.reset();
        }
        spawn(context.get_executor(), "session", serve(session, std::move(over), how));
        // Some messages later the connection breaks, but for the last one.
        const bool is_last = connection == losses;
        for (int heard = 0; is_last ? !standing.empty() : heard < 12 + 5 * connection; ++heard) {
            Result<Message> message = co_await master.channel->receive(patience);
            EXPECT_TRUE(message);
            if (!message) {
                co_return;
            }
            std::visit([&](auto& content) { master.on(content); }, message.value());
            for (const TaskId task : master.ended) {
                standing.erase(task);
            }
            if (const auto* now = std::get_if<Standing>(&message.value())) {
                EXPECT_EQ(now->trees.size(), 2u);
                EXPECT_EQ(now->jobs, std::vector<JobId>{JobId{1}});
                standing.clear(); // What is not named has ended; its results came before.
                for (const Recalled& task : now->tasks) {
                    standing.insert(task.task);
                }
            }
        }
        for (const auto& [index, record] : master.records) {
            const auto [place, is_new] = records.emplace(index, record);
            EXPECT_EQ(place->second, record);
        }
        EXPECT_EQ(master.tasks_of_results.count(TaskId{0}), 0u) << "tasks are those of before";
        master.channel->close();
        while (!how) {
            co_await asio::post(executor.home(), asio::use_awaitable);
        }
        EXPECT_EQ(how, SessionEnd::Lost);
    }
    master.records = records;
    expect_all_right(master, scenarios);
    session->leave();
}

TEST(Session, OutlivesItsConnectionAndDoesNothingTwice) {
    for (const int losses : {1, 4}) {
        asio::io_context context;
        Executor executor(context.get_executor(), 2);
        asio::co_spawn(context,
                       lose_the_connection_again_and_again(context, executor, losses),
                       [](const std::exception_ptr& thrown) { EXPECT_FALSE(thrown); });
        context.run_for(patience);
        EXPECT_TRUE(context.stopped()) << "something is still under way";
    }
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
        stage.master.channel->send(make_batch(TaskId{1}, make_scenarios(0, 2)));
        while (stage.master.heartbeats < 3) {
            Result<Message> message = co_await stage.master.channel->receive(patience);
            EXPECT_TRUE(message);
            if (!message) {
                break;
            }
            std::visit([&](auto& content) { stage.master.on(content); }, message.value());
        }
        EXPECT_TRUE(stage.master.records.empty());
        released.count_down();
        co_await stage.master.serve_until_ended(1);
    });
}

TEST(Session, ADroppedScenarioIsNotAnsweredAndTheOthersAre) {
    for (const bool is_range : {false, true}) {
        perform(unlimited, 1, [is_range](Stage& stage) -> asio::awaitable<void> {
            FakeMaster& master = stage.master;
            const auto scenarios = make_scenarios(0, 40);
            master.channel->send(DropScenario{JobId{1}, 7});
            master.channel->send(DropScenario{JobId{99}, 8}); // Of no job: nothing happens.
            if (is_range) {
                master.channel->send(make_range(TaskId{1}, scenarios));
            } else {
                master.channel->send(make_batch(TaskId{1}, scenarios));
            }
            co_await master.serve_until_ended(1);
            EXPECT_EQ(master.records.size(), 39u);
            EXPECT_FALSE(master.records.contains(7));
        });
    }
}

/// Nothing begins as long as the one thread is held.
template <class Then>
asio::awaitable<void> with_a_held_thread(Stage& stage, bool is_range, Then then) {
    std::latch released(1);
    stage.executor.submit([&released] {
        released.wait();
        return Executor::Continuation([] {});
    });
    const auto scenarios = make_scenarios(0, 40);
    if (is_range) {
        stage.master.channel->send(make_range(TaskId{1}, scenarios));
    } else {
        stage.master.channel->send(make_batch(TaskId{1}, scenarios));
    }
    Recall of_no_task;
    of_no_task.task = TaskId{99};
    stage.master.channel->send(of_no_task); // Nothing happens.
    then();
    while (stage.master.recalled.empty()) {
        Result<Message> message = co_await stage.master.channel->receive(patience);
        EXPECT_TRUE(message);
        if (!message) {
            break;
        }
        std::visit([&](auto& content) { stage.master.on(content); }, message.value());
    }
    EXPECT_TRUE(stage.master.records.empty());
    released.count_down();
    co_await stage.master.serve_until_ended(1);
}

TEST(Session, WhatIsRecalledAndHasNotBegunIsGivenBackAndNotAnswered) {
    for (const bool is_range : {false, true}) {
        perform(unlimited, 1, [is_range](Stage& stage) -> asio::awaitable<void> {
            FakeMaster& master = stage.master;
            std::vector<std::uint64_t> wanted(20);
            std::iota(wanted.begin(), wanted.end(), 10);
            const auto ask = [&] { master.channel->send(Recall{TaskId{1}, wanted, 10}); };
            co_await with_a_held_thread(stage, is_range, ask);
            EXPECT_EQ(master.recalled.size(), 1u);
            EXPECT_EQ(master.recalled[0].task, TaskId{1});
            EXPECT_EQ(master.recalled[0].scenarios,
                      is_range ? std::vector<std::uint64_t>{} : wanted);
            EXPECT_EQ(master.recalled[0].places, is_range ? 10u : 0u);
            EXPECT_EQ(master.records.size(), is_range ? 10u : 20u);
            EXPECT_TRUE(master.records.contains(9));
            EXPECT_FALSE(master.records.contains(10));
        });
    }
}

TEST(Session, WhatAnotherWorkerHasAnsweredIsDroppedInItsTaskAlone) {
    for (const bool is_range : {false, true}) {
        perform(unlimited, 1, [is_range](Stage& stage) -> asio::awaitable<void> {
            FakeMaster& master = stage.master;
            const auto drop = [&] {
                master.channel->send(DropScenario{JobId{1}, 7, TaskId{1}});
                master.channel->send(DropScenario{JobId{1}, 8, TaskId{99}});
                master.channel->send(Recall{TaskId{1}, {}, 40});
            };
            co_await with_a_held_thread(stage, is_range, drop);
            EXPECT_EQ(master.records.size(), 39u);
            EXPECT_FALSE(master.records.contains(7));
            master.channel->send(make_batch(TaskId{2}, make_scenarios(7, 1)));
            co_await master.serve_until_ended(2);
            EXPECT_TRUE(master.records.contains(7)) << "in another task it is done";
        });
    }
}

/// What it was asked for then goes at once, since no scenario needs it and the cache is full.
TEST(Session, WhatCameForWhatWasGivenBackIsAskedForAgain) {
    perform(1, 1, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        std::uint64_t index = 0;
        while (make_batch(TaskId{1}, make_scenarios(index, 1)).pairs.empty()) {
            ++index; // Until it needs blocks.
        }
        const auto scenarios = make_scenarios(index, 1);
        Recall recall;
        recall.task = TaskId{1};
        recall.scenarios.push_back(index);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        while (master.ended.empty()) {
            Result<Message> message = co_await master.channel->receive(patience);
            EXPECT_TRUE(message);
            if (!message) {
                co_return;
            }
            if (std::holds_alternative<WantSubtrees>(message.value())) {
                master.channel->send(recall); // It is there before the blocks.
            }
            std::visit([&](auto& content) { master.on(content); }, message.value());
        }
        EXPECT_TRUE(master.records.empty());
        master.channel->send(make_batch(TaskId{2}, scenarios));
        co_await master.serve_until_ended(2);
        EXPECT_EQ(master.records.size(), 1u);
    });
}

TEST(Session, DrainAnswersAllThenCloses) {
    const auto how = perform(unlimited, 2, [](Stage& stage) -> asio::awaitable<void> {
        const auto scenarios = make_scenarios(400, 20);
        stage.master.channel->send(make_batch(TaskId{1}, scenarios));
        stage.master.channel->send(Drain{});
        co_await stage.master.serve_until_ended(2);
        expect_all_right(stage.master, scenarios);
        EXPECT_EQ(stage.master.ended.size(), 1u);
        EXPECT_FALSE(stage.master.end.empty()) << "it closed";
    });
    EXPECT_EQ(how, SessionEnd::Drained);
}

TEST(Session, StopHandsBackWhatItHasNotBegun) {
    const auto how = perform(unlimited, 1, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        const auto scenarios = make_scenarios(500, 300);
        master.channel->send(make_batch(TaskId{1}, scenarios));
        // Some results first, so that it is in the middle of its work.
        while (master.results_messages == 0) {
            Result<Message> message = co_await master.channel->receive(patience);
            std::visit([&](auto& content) { master.on(content); }, message.value());
        }
        stage.session->stop();
        co_await master.serve_until_ended(2);
        EXPECT_TRUE(master.worker_drains);
        EXPECT_TRUE(master.ended.contains(TaskId{1}));
        for (const auto& [index, record] : master.records) {
            EXPECT_EQ(record, expected_record(scenarios[index - 500]));
        }
    });
    EXPECT_EQ(how, SessionEnd::Drained);
}

TEST(Session, TheConnectionIsServedWhileBlocksWaitForAThreadToOpenThem) {
    perform(unlimited, 1, [](Stage& stage) -> asio::awaitable<void> {
        FakeMaster& master = stage.master;
        std::latch released(1);
        stage.executor.submit([&released] {
            released.wait(); // The only thread opens nothing meanwhile.
            return Executor::Continuation([] {});
        });
        Subtrees wrong;
        wrong.tree = tree_a;
        wrong.blocks = {bodies().a.blocks[0]};
        wrong.blocks[0].hash.bytes[0] ^= std::byte{1};
        master.channel->send(wrong);
        master.channel->send(make_batch(TaskId{1}, make_scenarios(0, 2)));
        // Whoever opened the block where the connection is served would complain before it read on.
        bool wants = false;
        while (!wants && master.complaint.empty()) {
            Result<Message> message = co_await master.channel->receive(patience);
            EXPECT_TRUE(message);
            if (!message) {
                break;
            }
            wants = std::holds_alternative<WantSubtrees>(message.value());
            std::visit([&](auto& content) { master.on(content); }, message.value());
        }
        EXPECT_TRUE(wants);
        EXPECT_EQ(master.complaint, "");
        released.count_down();
        co_await master.serve_until_ended(1);
        EXPECT_THAT(master.complaint, testing::HasSubstr("hash"));
    });
}

TEST(Session, TerminateEndsAtOnce) {
    const auto how = perform(unlimited, 1, [](Stage& stage) -> asio::awaitable<void> {
        stage.master.channel->send(Terminate{"enough"});
        co_await stage.master.serve_until_ended(1);
    });
    EXPECT_EQ(how, SessionEnd::Terminated);
}

/// What the session says of it before it closes.
std::string complaint_about(const Message& message) {
    std::string complaint;
    const auto how = perform(unlimited, 1, [&](Stage& stage) -> asio::awaitable<void> {
        stage.master.channel->send(message);
        co_await stage.master.serve_until_ended(1);
        complaint = stage.master.complaint;
    });
    EXPECT_EQ(how, SessionEnd::Disagreed);
    return complaint;
}

TEST(Session, DisagreementEndsTheConnectionWithAReason) {
    const auto scenarios = make_scenarios(0, 2);
    EXPECT_THAT(complaint_about(AddJob{JobId{2}, tree_a, TreeId{99}, {}, {}}),
                testing::HasSubstr("tree that is not here"));
    EXPECT_THAT(complaint_about(AddJob{JobId{1}, tree_a, tree_b, {}, {}}),
                testing::HasSubstr("already"));
    Batch unknown_job = make_batch(TaskId{1}, scenarios);
    unknown_job.job = JobId{99};
    EXPECT_THAT(complaint_about(unknown_job), testing::HasSubstr("job that is not here"));
    EXPECT_THAT(complaint_about(ScenarioRange{TaskId{1}, JobId{99}, 0, 1, {}}),
                testing::HasSubstr("job that is not here"));

    Batch unknown_root = make_batch(TaskId{1}, std::span(scenarios).first(1));
    unknown_root.pairs = {{0, 1u << 30}};
    unknown_root.pair_offsets = {0, 1};
    EXPECT_THAT(complaint_about(unknown_root), testing::HasSubstr("root"));

    Batch few_offsets = make_batch(TaskId{1}, scenarios);
    few_offsets.pairs = {};
    few_offsets.pair_offsets = {0};
    EXPECT_THAT(complaint_about(few_offsets), testing::HasSubstr("number of scenarios"));

    EXPECT_NE(complaint_about(AddTree{TreeId{9}, SubtreeForm::Wide, {}, {ObbNode{}, ObbNode{}}}),
              "");
    EXPECT_NE(complaint_about(bodies().a.add(tree_a)), "") << "twice";
    EXPECT_THAT(complaint_about(Accepted{JobId{1}}), testing::HasSubstr("accepted"));

    Subtrees wrong;
    wrong.tree = tree_a;
    wrong.blocks = {bodies().a.blocks[0]};
    wrong.blocks[0].hash.bytes[0] ^= std::byte{1};
    EXPECT_THAT(complaint_about(wrong), testing::HasSubstr("hash"));
}

} // namespace
} // namespace cd::tests
