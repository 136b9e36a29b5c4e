// Proves that a session answers each scenario of its tasks once or returns it, begins nothing while
// it may not, and ends each task after its results. Proves that a scenario that asks
// for the distance fetches subtrees in two steps.
#include "worker/session/task_runner.hpp"

#include "tests/worker/session/parts.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr TaskId task{1};

struct Runner : HubStage {
    explicit Runner(const Query& asked = {})
        : query(asked),
          blocks(*hub, master, keep, {}),
          tasks(*hub, master, blocks, keep->computed) {
        hub->on_settle = [this] { settle(); };
        EXPECT_TRUE(blocks.add_tree(bodies().a.add(tree_a)));
        EXPECT_TRUE(blocks.add_tree(bodies().b.add(tree_b)));
        EXPECT_TRUE(tasks.add_job(add_job(JobId{1}, query)));
    }
    void settle() {
        has_ended_last = tasks.settle(blocks.settle()) || has_ended_last;
        if (serves) {
            serve();
        }
    }
    /// Sends all blocks that were asked for.
    void serve() {
        for (; wants_served < master.sent.size(); ++wants_served) {
            const auto* want = std::get_if<WantSubtrees>(&master.sent[wants_served]);
            Subtrees subtrees;
            for (std::size_t i = 0; want != nullptr && i < want->roots.size(); ++i) {
                const CutBody& body = want->tree == tree_a ? bodies().a : bodies().b;
                subtrees.tree = want->tree;
                subtrees.blocks.push_back(body.block(want->roots[i]));
                wanted.insert({want->tree, want->roots[i]});
            }
            blocks.receive(std::move(subtrees));
        }
    }
    void run_to_the_end() {
        run_until([&] { return has_ended_last; });
        has_ended_last = false;
    }
    /// Adds 40 scenarios as a batch or a range, and begins none.
    void add_unbegun(bool is_range) {
        master.has_room = false;
        const auto scenarios = make_scenarios(0, 40);
        EXPECT_TRUE(is_range ? tasks.add(make_range(task, scenarios))
                             : tasks.add(make_batch(task, scenarios)));
        context.poll();
    }
    void go_on() {
        master.has_room = true;
        hub->settle_soon();
        run_to_the_end();
    }
    /// Scenarios in the results, checked against those of whole trees.
    [[nodiscard]] std::set<std::uint64_t> answered() const {
        std::set<std::uint64_t> indices;
        for (const Results& results : master.all<Results>()) {
            const Bytes bytes = unpack_records(results.records, limits::results_bytes_max).value();
            ByteReader in(bytes);
            for (std::uint32_t i = 0; i < results.count; ++i) {
                const auto found = in.get_bytes(in.get<std::uint32_t>());
                const Bytes record(found.begin(), found.end());
                const std::uint64_t index = decode_result(record).value().index;
                EXPECT_EQ(record, expected_record(make_scenarios(index, 1)[0], query));
                EXPECT_TRUE(indices.insert(index).second) << "answered twice";
            }
        }
        return indices;
    }

    Query query;
    std::shared_ptr<CarryOver> keep = std::make_shared<CarryOver>(unlimited);
    BlockInbox blocks;
    TaskRunner tasks;
    bool serves = true;          ///< False: only calls of `serve` send blocks.
    std::set<SubtreeKey> wanted; ///< Blocks asked for and sent.
    std::size_t wants_served = 0;
    bool has_ended_last = false;
};

struct DistanceRunner : Runner {
    DistanceRunner() : Runner(distance()) {}

    static Query distance() {
        Query query;
        query.level = Level::Any;
        query.question = Question::Distance;
        return query;
    }
    /// Returns some of the scenarios that `answered` knows, whose bodies are apart.
    static std::vector<Scenario> apart(std::size_t count) {
        std::vector<Scenario> scenarios;
        for (std::uint64_t index = 0; scenarios.size() < count; ++index) {
            const Scenario scenario = make_scenarios(index, 1)[0];
            if (decode_result(expected_record(scenario, distance())).value().nearest) {
                scenarios.push_back(scenario);
            }
        }
        return scenarios;
    }
    /// Runs one scenario, and returns how many of the blocks it asked for.
    std::size_t blocks_for(const Scenario& scenario, bool is_range) {
        const std::vector one{scenario};
        EXPECT_TRUE(
            tasks.add(is_range ? make_range(task, one) : make_batch(task, one, distance())));
        run_to_the_end();
        EXPECT_EQ(answered(), std::set{scenario.index});
        return wanted.size();
    }
    /// Runs until blocks are asked for that were not sent.
    void run_until_wanted() {
        run_until([&] {
            return std::any_of(
                master.sent.begin() + static_cast<std::ptrdiff_t>(wants_served),
                master.sent.end(),
                [](const Message& sent) { return std::holds_alternative<WantSubtrees>(sent); });
        });
    }
    /// Adds a scenario whose first look is over, and which waits for its second.
    std::uint64_t add_for_second_look(bool is_range) {
        serves = false;
        const auto scenarios = apart(1);
        EXPECT_TRUE(tasks.add(is_range ? make_range(task, scenarios)
                                       : make_batch(task, scenarios, distance())));
        for (int looks = 0; looks < 2; ++looks) { // The upper trees, then the nearest roots.
            run_until_wanted();
            serve();
        }
        run_until_wanted();
        return scenarios[0].index;
    }
};

TEST_F(Runner, AnswersEachScenarioAndThenEndsTheTask) {
    for (const bool is_range : {false, true}) {
        add_unbegun(is_range);
        EXPECT_THAT(answered(), IsEmpty()) << "the master takes no results";
        EXPECT_EQ(tasks.book().unanswered(), 40u);
        go_on();
        EXPECT_EQ(answered().size(), 40u);
        EXPECT_EQ(std::get<EndOfTask>(master.sent.back()).task, task);
        EXPECT_FALSE(tasks.book().has_tasks());
        master.sent.clear();
        wants_served = 0;
    }
    EXPECT_EQ(keep->computed->load(), 80u);
}

TEST_F(Runner, ResultsDoNotWaitAtAWorkerThatIsIdle) {
    WorkUnit range = make_range(task, make_scenarios(0, 400));
    range.results_wait_ms = 3'600'000;
    EXPECT_TRUE(tasks.add(range));
    run_until([&] {
        master.has_room = keep->computed->load() == 0; // Then no other scenario begins.
        return !master.all<Results>().empty();
    });
    EXPECT_FALSE(answered().empty());
    EXPECT_LT(answered().size(), 400u);
}

TEST_F(Runner, ResultsArePackedUnlessTheMasterRunsOnThisHost) {
    for (const bool is_local : {false, true}) {
        master.is_local = is_local;
        add_unbegun(false);
        go_on();
        const auto results = master.all<Results>();
        ASSERT_FALSE(results.empty());
        EXPECT_TRUE(std::ranges::all_of(
            results, [&](const Results& each) { return each.are_packed == !is_local; }));
        master.sent.clear();
    }
}

TEST_F(Runner, ReturnsRecalledScenariosThatHaveNotBegun) {
    for (const bool is_range : {false, true}) {
        add_unbegun(is_range);
        std::vector<std::uint64_t> wanted(20);
        std::iota(wanted.begin(), wanted.end(), 10);
        tasks.recall({TaskId{99}, wanted, 10}); // An unknown task has ended.
        tasks.recall({task, wanted, 10});
        const auto recalled = master.all<Recalled>();
        ASSERT_EQ(recalled.size(), 1u);
        EXPECT_EQ(recalled[0].scenarios, is_range ? std::vector<std::uint64_t>{} : wanted);
        EXPECT_EQ(recalled[0].kept, is_range ? 10u : 0u);
        go_on();
        const std::set<std::uint64_t> indices = answered();
        EXPECT_EQ(indices.size(), is_range ? 10u : 20u);
        EXPECT_TRUE(indices.contains(9));
        EXPECT_FALSE(indices.contains(10));
        master.sent.clear();
        wants_served = 0;
    }
}

TEST_F(Runner, DropsAScenarioInOneTaskOrInAllOfItsJob) {
    for (const bool is_range : {false, true}) {
        add_unbegun(is_range);
        tasks.drop({JobId{1}, 7, task});
        tasks.drop({JobId{1}, 8, TaskId{99}}); // No effect, as the next one.
        tasks.drop({JobId{99}, 9});
        go_on();
        EXPECT_EQ(answered().size(), 39u);
        EXPECT_FALSE(answered().contains(7));
        master.sent.clear();
        wants_served = 0;
    }
    tasks.drop({JobId{1}, 8});
    add_unbegun(false);
    go_on();
    EXPECT_EQ(answered().size(), 39u);
    EXPECT_FALSE(answered().contains(8));
    EXPECT_TRUE(answered().contains(7));
}

TEST_F(Runner, ReturnsEverythingUnbegunWhenItStops) {
    add_unbegun(false);
    EXPECT_TRUE(tasks.add(make_range(TaskId{2}, make_scenarios(40, 5))));
    tasks.stop();
    tasks.stop();
    EXPECT_EQ(master.all<Drain>().size(), 1u);
    // These were on their way before the master received the Drain.
    EXPECT_TRUE(tasks.add(make_batch(TaskId{3}, make_scenarios(50, 5))));
    EXPECT_TRUE(tasks.add(make_range(TaskId{4}, make_scenarios(60, 5))));
    go_on();
    EXPECT_EQ(master.all<EndOfTask>().size(), 4u);
    EXPECT_THAT(answered(), IsEmpty());
}

TEST_F(Runner, EndsTheTasksOfARemovedJob) {
    add_unbegun(true);
    tasks.remove_job(JobId{1});
    go_on();
    EXPECT_EQ(master.all<EndOfTask>().size(), 1u);
    EXPECT_THAT(answered(), IsEmpty());
    EXPECT_THAT(tasks.add(make_range(TaskId{2}, make_scenarios(0, 1))).error().detail,
                HasSubstr("job that is not here"));
}

TEST_F(DistanceRunner, AsksForFewerBlocksThanAllRootsName) {
    const Scenario scenario = apart(1)[0];
    const WorkUnit named = make_batch(task, std::vector{scenario}, distance());
    const std::size_t all = roots_of_a(named.pairs).size() + roots_of_b(named.pairs).size() + 2;
    const std::size_t asked = blocks_for(scenario, false);
    EXPECT_LT(asked, all);
    EXPECT_TRUE(wanted.contains({tree_a, top_root}));
    master.sent.clear();
    wants_served = 0;
    EXPECT_EQ(blocks_for(scenario, true), asked) << "a range needs the same blocks";
}

TEST_F(DistanceRunner, AnswersEachScenarioAndThenEndsTheTask) {
    for (const bool is_range : {true, false}) {
        const auto scenarios = make_scenarios(0, 40);
        EXPECT_TRUE(tasks.add(is_range ? make_range(task, scenarios)
                                       : make_batch(task, scenarios, distance())));
        run_to_the_end();
        EXPECT_EQ(answered().size(), 40u);
        EXPECT_EQ(std::get<EndOfTask>(master.sent.back()).task, task);
        master.sent.clear();
        wants_served = 0;
    }
    EXPECT_EQ(keep->computed->load(), 80u);
}

TEST_F(DistanceRunner, AnswersWithACacheOfAFewBlocks) {
    blocks.cache() = SubtreeCache(1);
    EXPECT_TRUE(blocks.add_tree(bodies().a.add(tree_a)));
    EXPECT_TRUE(blocks.add_tree(bodies().b.add(tree_b)));
    for (const bool is_range : {true, false}) {
        const auto scenarios = make_scenarios(0, 20);
        EXPECT_TRUE(tasks.add(is_range ? make_range(task, scenarios)
                                       : make_batch(task, scenarios, distance())));
        run_to_the_end();
        EXPECT_EQ(answered().size(), 20u);
        master.sent.clear();
        wants_served = 0;
    }
}

TEST_F(DistanceRunner, ReturnsARecalledScenarioThatWaitsForItsSecondLook) {
    const std::uint64_t index = add_for_second_look(false);
    tasks.recall({task, {index}, 0});
    const auto recalled = master.all<Recalled>();
    ASSERT_EQ(recalled.size(), 1u);
    EXPECT_EQ(recalled[0].scenarios, std::vector{index});
    run_to_the_end();
    EXPECT_THAT(answered(), IsEmpty());
    EXPECT_EQ(master.all<EndOfTask>().size(), 1u);
}

TEST_F(DistanceRunner, ReturnsARecalledScenarioOfARangeThatWaitsForItsSecondLook) {
    const std::uint64_t index = add_for_second_look(true);
    tasks.recall({task, {}, 1});
    tasks.recall({task, {}, 0});
    const auto recalled = master.all<Recalled>();
    ASSERT_EQ(recalled.size(), 2u);
    EXPECT_THAT(recalled[0].scenarios, IsEmpty()) << "the first is kept";
    EXPECT_EQ(recalled[1].scenarios, std::vector{index});
    run_to_the_end();
    EXPECT_THAT(answered(), IsEmpty());
    EXPECT_EQ(master.all<EndOfTask>().size(), 1u);
}

TEST_F(DistanceRunner, ReturnsAScenarioThatWaitsForItsSecondLookWhenItStops) {
    add_for_second_look(true);
    tasks.stop();
    run_to_the_end();
    EXPECT_THAT(answered(), IsEmpty());
    EXPECT_EQ(master.all<EndOfTask>().size(), 1u);
}

TEST_F(DistanceRunner, AnswersAScenarioThatHasWaitedForItsSecondLook) {
    const std::uint64_t index = add_for_second_look(false);
    serves = true;
    serve();
    run_to_the_end();
    EXPECT_EQ(answered(), std::set{index});
}

} // namespace
} // namespace cd::tests
