// Proves the bookkeeping of simulated workers, and the bounds of the simulated master's messages.
#include "bench/cluster/model/simulated_master.hpp"
#include "bench/cluster/model/worker_model.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/scenario.hpp"
#include "tests/bench/cluster/synthetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace cd::tests {
namespace {

using namespace cd::bench;

/// Answers requests of one worker.
std::vector<Subtrees> answers(const Messages& wanted) {
    std::vector<Subtrees> answers;
    for (const Message& message : wanted) {
        const auto& want = std::get<WantSubtrees>(message);
        Subtrees& blocks = answers.emplace_back(Subtrees{want.tree, {}});
        for (const RootIndex root : want.roots) {
            blocks.blocks.push_back({root, {}, {}});
        }
    }
    return answers;
}

TEST(ClusterModels, OneWantIsAnsweredInMessagesOfBoundedSize) {
    Workload workload = make_synthetic_workload(1, 10);
    for (BlockCost& block : workload.trees[0]) {
        block.bytes = 300'000;
    }
    SimulatedMaster master(workload, {});
    (void)master.start(std::vector<std::uint32_t>{1});
    WantSubtrees wanted{tree_id(0), {}};
    for (RootIndex root = 0; root < 40; ++root) {
        wanted.roots.push_back(root);
    }
    const auto letters = master.take(WorkerId{1}, wanted);
    std::size_t blocks = 0;
    for (const Letter& letter : letters) {
        EXPECT_LT(letter.bytes, 1'500'000u);
        blocks += std::get<Subtrees>(letter.content).blocks.size();
    }
    EXPECT_EQ(blocks, wanted.roots.size());
    EXPECT_EQ(letters.size(), 10u); // Four blocks each.
}

WorkUnit unit_of(const std::vector<std::uint64_t>& indices) {
    std::vector<Scenario> scenarios(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        scenarios[i].index = indices[i];
    }
    WorkUnit unit;
    unit.task = TaskId{7};
    unit.count = indices.size();
    unit.scenarios = pack_scenarios(scenarios);
    return unit;
}

/// The number of results in the worker's messages, and whether they end the task.
std::pair<std::size_t, bool> results_in(const Messages& messages) {
    std::pair<std::size_t, bool> found{0, false};
    for (const Message& message : messages) {
        const auto* results = std::get_if<Results>(&message);
        found.first += results == nullptr ? 0 : results->count;
        found.second |= std::holds_alternative<EndOfTask>(message);
    }
    return found;
}

TEST(ClusterModels, ResultsLeaveWithTheirTaskOrWhenTheyAreOld) {
    const Workload workload = make_synthetic_workload(2, 3);
    WorkerModel worker(WorkerId{1}, workload);
    const Messages wanted = worker.take(unit_of({0, 1, 2}));
    EXPECT_EQ(worker.ready_count(), 0u);
    for (const Subtrees& blocks : answers(wanted)) {
        EXPECT_EQ(worker.opened(blocks).size(), 1u);
    }
    ASSERT_EQ(worker.ready_count(), 3u);
    for (const Subtrees& blocks : answers(wanted)) {
        EXPECT_TRUE(worker.opened(blocks).empty()) << "they are here";
    }
    ASSERT_EQ(worker.ready_count(), 3u);

    worker.ran(worker.next(), 1.0, 0.25);
    EXPECT_TRUE(worker.due(1.5, 1).empty());
    EXPECT_EQ(results_in(worker.due(2.0, 1)), std::pair(std::size_t{1}, false));
    worker.ran(worker.next(), 3.0, 0.5);
    worker.ran(worker.next(), 3.0, 0.25);
    const Messages last = worker.due(3.0, 1);
    EXPECT_EQ(results_in(last), std::pair(std::size_t{2}, true));
    EXPECT_EQ(std::get<Results>(last.front()).compute_seconds, 0.75);
    EXPECT_TRUE(worker.due(9.0, 1).empty());
}

TEST(ClusterModels, AWorkerThatTakesTurnsRequestsBlocksScenarioByScenario) {
    const Workload workload = make_synthetic_workload(2, 4);
    WorkerModel worker(WorkerId{1}, workload);
    worker.take_turns();
    EXPECT_TRUE(worker.take(unit_of({0, 1, 2, 3})).empty());
    std::set<BlockId> here;
    for (std::uint64_t scenario = 0; scenario < 4; ++scenario) {
        std::set<BlockId> missing;
        for (const BlockId& block : workload.scenario(scenario).blocks) {
            if (here.insert(block).second) {
                missing.insert(block);
            }
        }
        std::set<BlockId> requested;
        for (const Subtrees& blocks : answers(worker.proceed())) {
            for (const SubtreeBlock& block : blocks.blocks) {
                requested.insert(block_id(blocks.tree, block.root));
            }
            (void)worker.opened(blocks);
        }
        EXPECT_EQ(requested, missing);
        ASSERT_EQ(worker.ready_count(), 1u);
        EXPECT_EQ(worker.next(), scenario);
        EXPECT_TRUE(worker.proceed().empty()) << "the scenario before runs";
        worker.ran(scenario, 1.0 + static_cast<double>(scenario), 1);
    }
    EXPECT_TRUE(worker.proceed().empty());
    EXPECT_EQ(results_in(worker.due(9.0, 1)), std::pair(std::size_t{4}, true));
}

TEST(ClusterModels, AWorkerAsksOnceForWhatItIsHinted) {
    const Workload workload = make_synthetic_workload(2, 4);
    const auto all = answers(WorkerModel(WorkerId{1}, workload).take(unit_of({0, 1, 2, 3})));
    const RootIndex first = all.front().blocks.front().root;
    const Hint hint{{}, all.front().tree, {first}};
    const std::uint64_t bytes = workload.block(block_id(hint.tree, first)).memory_bytes;
    for (const std::uint64_t cache_bytes : {std::uint64_t{0}, bytes, bytes - 1}) {
        WorkerModel worker(WorkerId{1}, workload, cache_bytes);
        worker.take(hint);
        worker.take(hint);
        const auto hinted = answers(worker.ahead());
        EXPECT_EQ(!hinted.empty(), cache_bytes != bytes - 1) << "there has to be room";
        for (const Subtrees& blocks : hinted) {
            EXPECT_EQ(std::get<Held>(worker.opened(blocks).front()).roots, hint.roots);
        }
        const auto wanted = answers(worker.take(unit_of({0, 1, 2, 3})));
        EXPECT_EQ(wanted.front().blocks.size(), all.front().blocks.size() - hinted.size());
        worker.take(Hint{{}, all.back().tree, {all.back().blocks.back().root}});
        EXPECT_TRUE(worker.ahead().empty()) << "something is needed at once";
        for (const Subtrees& blocks : wanted) {
            (void)worker.opened(blocks);
        }
        EXPECT_EQ(worker.ready_count(), 4u);
        EXPECT_TRUE(worker.ahead().empty()) << "it is here";
    }
}

TEST(ClusterModels, AWorkerGivesBackWhatItHasNotBegun) {
    const Workload workload = make_synthetic_workload(2, 4);
    WorkerModel worker(WorkerId{1}, workload);
    const auto wanted = answers(worker.take(unit_of({0, 1, 2, 3})));
    EXPECT_EQ(worker.take(Recall{TaskId{7}, {3}})->scenarios, (std::vector<std::uint64_t>{3}));
    for (const Subtrees& blocks : wanted) {
        (void)worker.opened(blocks);
    }
    ASSERT_EQ(worker.ready_count(), 3u);
    const std::uint64_t begun = worker.next();
    EXPECT_EQ(begun, 0u);
    const Recalled gave = worker.take(Recall{TaskId{7}, {0, 2}}).value();
    EXPECT_EQ(gave.scenarios, (std::vector<std::uint64_t>{2, 3})) << "all so far";
    EXPECT_FALSE(worker.take(DropScenario{{}, 1, TaskId{7}})) << "it does not run";
    EXPECT_EQ(worker.ready_count(), 0u);
    EXPECT_TRUE(worker.take(DropScenario{{}, 0, TaskId{7}}));
    worker.ran(begun, 1.0, 0.5);
    EXPECT_EQ(results_in(worker.due(1.0, 1)), std::pair(std::size_t{0}, true));
    EXPECT_FALSE(worker.take(Recall{TaskId{7}, {0}}).has_value()) << "its end is on the way";
}

/// The range [first, first + count) as the task 9.
WorkUnit range_of(std::uint64_t first, std::uint64_t count) {
    WorkUnit unit;
    unit.task = TaskId{9};
    unit.first = first;
    unit.count = count;
    return unit;
}

TEST(ClusterModels, ARangeWaitsForTheUpperTreesAndThenForItsBlocks) {
    const Workload workload = make_synthetic_workload(2, 4);
    WorkerModel worker(WorkerId{1}, workload);
    const Messages tops = worker.take(range_of(1, 3));
    ASSERT_EQ(tops.size(), 2u) << "one of each body";
    for (const Message& message : tops) {
        EXPECT_EQ(std::get<WantSubtrees>(message).roots, (std::vector<RootIndex>{top_root}));
    }
    const auto answered = answers(tops);
    EXPECT_EQ(worker.opened(answered[0]).size(), 1u) << "it says what it holds";
    Messages wanted = worker.opened(answered[1]);
    ASSERT_EQ(worker.ready_count(), 0u);
    ASSERT_TRUE(std::holds_alternative<Held>(wanted.front()));
    wanted.erase(wanted.begin());
    for (const Subtrees& blocks : answers(wanted)) {
        (void)worker.opened(blocks);
    }
    EXPECT_EQ(worker.ready_count(), 3u);
}

TEST(ClusterModels, ARangeKeepsItsFirstScenariosAndThoseThatHaveBegun) {
    const Workload workload = make_synthetic_workload(2, 6);
    WorkerModel worker(WorkerId{1}, workload);
    const Messages tops = worker.take(range_of(0, 6));
    EXPECT_TRUE(worker.take(Recall{TaskId{9}, {}, 1})->scenarios.empty()) << "no upper tree";
    Messages asked;
    for (const Subtrees& top : answers(tops)) {
        asked = worker.opened(top);
    }
    asked.erase(asked.begin());
    for (const Subtrees& blocks : answers(asked)) {
        (void)worker.opened(blocks);
    }
    ASSERT_EQ(worker.ready_count(), 6u);
    const std::uint64_t first = worker.next();
    const std::uint64_t second = worker.next();
    for (const std::uint64_t kept : {std::uint64_t{4}, std::uint64_t{0}}) {
        std::vector<std::uint64_t> returned;
        for (std::uint64_t position = kept; position < 6; ++position) {
            if (position != first && position != second) {
                returned.push_back(position);
            }
        }
        EXPECT_EQ(worker.take(Recall{TaskId{9}, {}, kept})->scenarios, returned);
        EXPECT_EQ(worker.ready_count(), 4 - returned.size());
    }
}

} // namespace
} // namespace cd::tests
