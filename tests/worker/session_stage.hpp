// A worker's session over a real connection, a master played by the test, and the results of one
// process for the same scenarios.
#pragma once

#include "common/job/packed_scenarios.hpp"
#include "common/job/query_roots.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/proto/loopback.hpp"
#include "tests/proto/sample_messages.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/worker/cut_body.hpp"
#include "worker/session/session.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

namespace cd::tests {

inline constexpr TreeId tree_a{3};
inline constexpr TreeId tree_b{4};
/// Several heartbeats come soon; no result depends on their timing.
inline constexpr SessionTimes quick_times{std::chrono::milliseconds(10), patience};
inline constexpr std::uint64_t unlimited = std::uint64_t{1} << 40;

struct Bodies {
    CutBody a = cut_body(make_torus(1, 0.4, 40, 20), 5);
    CutBody b = cut_body(make_sphere(3), 4);
};

inline const Bodies& bodies() {
    static const Bodies made;
    return made;
}

inline std::vector<Scenario> make_scenarios(std::uint64_t first, std::uint64_t count) {
    std::vector<Scenario> scenarios;
    for (std::uint64_t index = first; index < first + count; ++index) {
        std::mt19937_64 random(index);
        scenarios.push_back(make_scenario({Pose{}, make_pose(random, 1.5)}, index));
    }
    return scenarios;
}

/// A unit of work as the master analyses it.
inline WorkUnit
make_batch(TaskId task, std::span<const Scenario> scenarios, const Query& query = {}) {
    WorkUnit batch;
    batch.task = task;
    batch.job = JobId{1};
    batch.count = scenarios.size();
    batch.scenarios = pack_scenarios(scenarios);
    batch.pair_offsets = {0};
    for (const Scenario& scenario : scenarios) {
        const auto pairs =
            query_roots(bodies().a.top, bodies().b.top, scenario, query).value().pairs;
        batch.pairs.insert(batch.pairs.end(), pairs.begin(), pairs.end());
        batch.pair_offsets.push_back(static_cast<std::uint32_t>(batch.pairs.size()));
    }
    return batch;
}

/// A unit of work that is not analysed.
inline WorkUnit make_range(TaskId task, std::span<const Scenario> scenarios) {
    return {task, JobId{1}, 0, scenarios.size(), pack_scenarios(scenarios), {}, {}};
}

/// Returns the result of one process before `inside` is settled, which takes whole bodies.
inline Bytes expected_record(const Scenario& scenario, const Query& query = {}) {
    const std::vector<SubtreePair> whole{{bodies().a.tree.view(), bodies().b.tree.view()}};
    return encode_result(run_on_subtrees(whole, scenario, query).result);
}

/// Plays the master: sends requested blocks, and records what it receives.
class FakeMaster {
  public:
    explicit FakeMaster(std::shared_ptr<Channel> to_worker) : channel(std::move(to_worker)) {}

    void add_job(std::optional<Bytes> grid = std::nullopt) {
        channel->send(bodies().a.add(tree_a));
        channel->send(bodies().b.add(tree_b));
        channel->send(AddJob{JobId{1}, {tree_a, tree_b}, {}, std::move(grid)});
    }

    /// Takes one message; returns it, or nothing if the connection has ended.
    asio::awaitable<std::optional<Message>> serve_one() {
        Result<Message> message = co_await channel->receive(patience);
        if (!message) {
            end = message.error().detail;
            co_return std::nullopt;
        }
        std::visit([this](auto& content) { on(content); }, message.value());
        co_return std::move(message.value());
    }
    /// Serves until the condition holds or the connection has ended.
    asio::awaitable<void> serve_until(std::function<bool()> is_enough) {
        while (!is_enough()) {
            const std::optional<Message> message = co_await serve_one();
            if (!message) {
                break;
            }
        }
    }
    asio::awaitable<void> serve_until_ended(std::size_t tasks) {
        const std::function<bool()> have_ended = [this, tasks] { return ended.size() >= tasks; };
        co_await serve_until(have_ended);
    }

    void on(const WantSubtrees& want) {
        const CutBody& body = want.tree == tree_a   ? bodies().a
                              : want.tree == tree_b ? bodies().b
                                                    : *other_body;
        Subtrees subtrees;
        subtrees.tree = want.tree;
        for (const RootIndex root : want.roots) {
            bytes_sent += body.block(root).compressed.size();
            EXPECT_TRUE(held.insert({want.tree, root}).second) << "asked for what it holds";
            given.insert({want.tree, root});
            subtrees.blocks.push_back(body.block(root));
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
        Bytes unpacked;
        ByteReader in(received_records(results.records, results.are_packed, unpacked).value());
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
    void on(const Inventory& now) { inventory = now; }
    void on(const Recalled& back) { recalled.push_back(back); }
    void on(const Heartbeat& heartbeat) {
        ++heartbeats;
        last_traffic = heartbeat.traffic;
        last_longest = heartbeat.longest;
    }
    void on(const Drain&) {
        worker_drains = true;
        channel->send(Drain{});
    }
    void on(const Failure& failure) { complaint = failure.detail; }
    template <class T>
    void on(const T&) {
        ADD_FAILURE() << "a message that no worker sends";
    }

    std::shared_ptr<Channel> channel;
    std::set<SubtreeKey> held;
    /// Spans earlier connections: a block sent shortly before the end counts later.
    std::set<SubtreeKey> given;
    std::map<std::uint64_t, Bytes> records;
    std::set<TaskId> ended;
    std::set<TaskId> tasks_of_results;
    std::vector<Sha256> cuts_held; ///< Cuts the worker named at its start.
    std::optional<Inventory> inventory;
    std::vector<Recalled> recalled;
    bool acknowledges = true;
    const CutBody* other_body = nullptr; ///< For trees other than tree_a and tree_b.
    std::size_t subtrees_sent = 0;
    std::size_t subtrees_evicted = 0;
    std::size_t results_messages = 0;
    std::size_t heartbeats = 0;
    std::uint64_t bytes_sent = 0; ///< Bytes of blocks.
    BlockTraffic traffic;         ///< Sum over the results.
    CacheTraffic last_traffic;    ///< From the last heartbeat.
    std::optional<RunningScenario> last_longest;
    bool worker_drains = false;
    std::string complaint;
    std::string end;
};

inline asio::awaitable<void> run_session(std::shared_ptr<Session> session,
                                         std::optional<SessionEnd>& how) {
    how = co_await session->run();
    if (how == SessionEnd::Lost) {
        session->leave();
    }
}

/// A master played by the test, with a session and its threads.
struct Stage : FakeMaster {
    Stage(Ends ends, Executor& threads, const std::shared_ptr<CarryOver>& keep)
        : FakeMaster(std::move(ends.right)),
          session(std::make_shared<Session>(
              std::move(ends.left), threads, keep, PeerParts{}, quick_times)),
          executor(threads) {}

    std::shared_ptr<Session> session;
    Executor& executor;
};

using Play = std::function<asio::awaitable<void>(Stage&)>;

inline asio::awaitable<void> play_on(asio::io_context& context,
                                     Executor& executor,
                                     const Play& play,
                                     bool adds_job,
                                     const std::shared_ptr<CarryOver>& keep,
                                     std::optional<SessionEnd>& how) {
    Ends ends = co_await connect_greeted_ends();
    Stage stage(std::move(ends), executor, keep);
    spawn(context.get_executor(), "session", run_session(stage.session, how));
    if (adds_job) {
        stage.add_job();
    }
    co_await play(stage);
    stage.channel->close();
}

/// Runs the play and the session to their ends; returns how the session ended.
inline std::optional<SessionEnd> perform(std::uint64_t cache_bytes,
                                         unsigned threads,
                                         const Play& play,
                                         bool adds_job = true,
                                         std::shared_ptr<CarryOver> keep = nullptr) {
    if (keep == nullptr) {
        keep = std::make_shared<CarryOver>(cache_bytes);
    }
    asio::io_context context;
    Executor executor(context.get_executor(), threads);
    std::optional<SessionEnd> how;
    asio::co_spawn(context,
                   play_on(context, executor, play, adds_job, keep, how),
                   [](const std::exception_ptr& thrown) { EXPECT_FALSE(thrown); });
    context.run_for(patience);
    EXPECT_TRUE(context.stopped()) << "something is still under way";
    return how;
}

inline void expect_all_right(const FakeMaster& master, std::span<const Scenario> scenarios) {
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

} // namespace cd::tests
