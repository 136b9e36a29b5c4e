// Proves the simulated cluster's bookkeeping without a clock: under every strategy each scenario is
// answered once; a worker gets each block its scenarios touch once, from the master or a holder;
// and the bytes are those of these blocks.
#include "bench/cluster/model/master_model.hpp"
#include "bench/cluster/model/strategies.hpp"
#include "bench/cluster/model/worker_model.hpp"
#include "tests/bench/cluster/synthetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <vector>

namespace cd::tests {
namespace {

using namespace cd::bench;

/// Delivers messages in the order of sending; workers run ready scenarios at once.
class InstantCluster {
  public:
    InstantCluster(const Workload& workload,
                   const ClusterOptions& options,
                   const ComparedStrategy& compared)
        : workload_(workload),
          master_(workload, options, compared.sees_queue ? 0 : 1, compared.peers) {
        for (std::uint64_t id = 1; id <= 5; ++id) {
            workers_.emplace_back(WorkerId{id}, workload);
        }
        threads_.assign(workers_.size(), 1);
    }

    void run() {
        send(master_.start(threads_));
        while (!master_.is_done()) {
            deliver();
            const auto scenario = master_.next_to_analyse();
            if (scenario) {
                send(master_.take(Analysed{*scenario}));
            }
            ASSERT_TRUE(scenario || !letters_.empty() || master_.is_done());
        }
    }

    [[nodiscard]] const MasterCounts& counts() const { return master_.counts(); }
    [[nodiscard]] std::uint64_t from_peers() const { return from_peers_; }
    /// Blocks touched by the batches, by worker.
    [[nodiscard]] const std::map<WorkerId, std::set<BlockId>>& touched() const { return touched_; }
    [[nodiscard]] const std::map<std::uint64_t, int>& given() const { return given_; }

  private:
    void send(std::vector<Letter> letters) {
        std::move(letters.begin(), letters.end(), std::back_inserter(letters_));
    }

    void deliver() {
        while (!letters_.empty()) {
            const Letter letter = letters_.front();
            letters_.pop_front();
            EXPECT_EQ(letter.bytes, bytes_of(letter.content, workload_));
            WorkerModel& worker = workers_[letter.to.value - 1];
            if (const auto* batch = std::get_if<BatchSent>(&letter.content)) {
                note(letter.to, *batch);
                if (const auto wanted = worker.take(*batch)) {
                    send(master_.take(*wanted));
                }
            } else if (const auto* hint = std::get_if<Hinted>(&letter.content)) {
                touched_[letter.to].insert(hint->blocks.begin(), hint->blocks.end());
                worker.take(*hint);
            } else if (const auto* directed = std::get_if<FetchDirected>(&letter.content)) {
                const WorkerModel& source = workers_[directed->source.value - 1];
                EXPECT_TRUE(std::ranges::all_of(
                    directed->blocks, [&](const BlockId& block) { return source.has(block); }));
                from_peers_ += directed->blocks.size();
                send(master_.take(worker.opened(BlocksSent{directed->blocks})));
            } else if (const auto* asked = std::get_if<AskedBack>(&letter.content)) {
                send(master_.take(worker.take(*asked)));
            } else if (const auto* loser = std::get_if<CalledOff>(&letter.content)) {
                EXPECT_FALSE(worker.take(*loser)) << "nothing takes any time here";
            } else {
                send(master_.take(worker.opened(std::get<BlocksSent>(letter.content))));
            }
            if (const auto wanted = worker.ahead()) {
                send(master_.take(*wanted));
            }
            work(worker);
        }
    }

    void note(WorkerId worker, const BatchSent& batch) {
        for (const std::uint64_t scenario : batch.scenarios) {
            ++given_[scenario];
            const auto& blocks = workload_.scenario(scenario).blocks;
            touched_[worker].insert(blocks.begin(), blocks.end());
        }
    }

    void work(WorkerModel& worker) {
        while (worker.ready_count() != 0) {
            worker.ran(worker.next(), 0, 0.1);
            for (const ResultsSent& results : worker.due(0, 1)) {
                send(master_.take(results));
            }
        }
    }

    const Workload& workload_;
    MasterModel master_;
    std::vector<WorkerModel> workers_;
    std::vector<std::uint32_t> threads_;
    std::deque<Letter> letters_;
    std::map<WorkerId, std::set<BlockId>> touched_;
    std::map<std::uint64_t, int> given_;
    std::uint64_t from_peers_ = 0;
};

TEST(ClusterModels, EveryScenarioIsAnsweredOnceAndEachMissingBlockIsSentOnce) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Workload workload = make_synthetic_workload(seed, 90 + seed);
        for (const ComparedStrategy& compared : compared_strategies) {
            for (const bool claims : {false, true}) {
                SCOPED_TRACE(testing::Message()
                             << "seed " << seed << " " << compared.name() << " " << claims);
                ClusterOptions options;
                options.strategy = compared.strategy;
                options.claim = claims;
                options.q = static_cast<std::uint32_t>(1 + seed % 7);
                options.seed = seed;
                InstantCluster cluster(workload, options, compared);
                cluster.run();

                EXPECT_EQ(cluster.counts().answered, workload.count());
                EXPECT_EQ(cluster.counts().answered_again, 0u);
                EXPECT_EQ(cluster.given().size(), workload.count());
                std::uint64_t blocks = 0;
                std::uint64_t bytes = 0;
                for (const auto& [worker, touched] : cluster.touched()) {
                    blocks += touched.size();
                    for (const BlockId& block : touched) {
                        bytes += workload.block(block).bytes;
                    }
                }
                EXPECT_EQ(cluster.counts().blocks + cluster.from_peers(), blocks);
                EXPECT_GT(cluster.counts().sent_bytes, cluster.counts().block_bytes);
                if (compared.peers) {
                    EXPECT_LE(cluster.counts().block_bytes, workload.geometry_bytes);
                } else {
                    EXPECT_EQ(cluster.counts().block_bytes, bytes);
                }
            }
        }
    }
}

TEST(ClusterModels, OneWantIsAnsweredInMessagesOfBoundedSize) {
    Workload workload = make_synthetic_workload(1, 10);
    for (BlockCost& block : workload.trees[0]) {
        block.bytes = 300'000;
    }
    MasterModel master(workload, {}, 1, false);
    (void)master.start(std::vector<std::uint32_t>{1});
    BlocksWanted wanted{WorkerId{1}, {}};
    for (RootIndex root = 0; root < 40; ++root) {
        wanted.blocks.push_back({0, root});
    }
    wanted.blocks.push_back({1, 0});
    const auto letters = master.take(wanted);
    std::size_t blocks = 0;
    for (const Letter& letter : letters) {
        EXPECT_LT(letter.bytes, 1'500'000u);
        blocks += std::get<BlocksSent>(letter.content).blocks.size();
    }
    EXPECT_EQ(blocks, wanted.blocks.size());
    EXPECT_EQ(letters.size(), 11u); // Four blocks each, and the other tree's.
}

TEST(ClusterModels, ResultsLeaveWithTheirTaskOrWhenTheyAreOld) {
    const Workload workload = make_synthetic_workload(2, 3);
    WorkerModel worker(WorkerId{1}, workload);
    const auto wanted = worker.take(BatchSent{TaskId{7}, {0, 1, 2}, true});
    ASSERT_TRUE(wanted);
    EXPECT_EQ(worker.ready_count(), 0u);
    EXPECT_EQ(worker.opened(BlocksSent{wanted->blocks}).blocks, wanted->blocks);
    ASSERT_EQ(worker.ready_count(), 3u);
    EXPECT_TRUE(worker.opened(BlocksSent{wanted->blocks}).blocks.empty()); // No effect.
    ASSERT_EQ(worker.ready_count(), 3u);

    worker.ran(worker.next(), 1.0, 0.25);
    EXPECT_TRUE(worker.due(1.5, 1).empty());
    ASSERT_EQ(worker.due(2.0, 1).size(), 1u);
    worker.ran(worker.next(), 3.0, 0.5);
    worker.ran(worker.next(), 3.0, 0.25);
    const auto last = worker.due(3.0, 1);
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(last[0].scenarios.size(), 2u);
    EXPECT_EQ(last[0].compute_seconds, 0.75);
    EXPECT_TRUE(last[0].ends_task);
    EXPECT_TRUE(worker.due(9.0, 1).empty());
}

TEST(ClusterModels, AWorkerAsksOnceForWhatItIsHinted) {
    const Workload workload = make_synthetic_workload(2, 4);
    const BatchSent batch{TaskId{7}, {0, 1, 2, 3}, true};
    const auto all = WorkerModel(WorkerId{1}, workload).take(batch);
    ASSERT_TRUE(all);
    const Hinted hint{{all->blocks.front()}};
    const std::uint64_t bytes = workload.block(hint.blocks.front()).memory_bytes;
    for (const std::uint64_t cache_bytes : {std::uint64_t{0}, bytes, bytes - 1}) {
        WorkerModel worker(WorkerId{1}, workload, cache_bytes);
        worker.take(hint);
        worker.take(hint);
        const auto hinted = worker.ahead();
        EXPECT_EQ(hinted.has_value(), cache_bytes != bytes - 1) << "there has to be room";
        if (hinted) {
            EXPECT_EQ(worker.opened(BlocksSent{hinted->blocks}).blocks, hint.blocks);
        }
        const auto wanted = worker.take(batch);
        EXPECT_EQ(wanted->blocks.size(), all->blocks.size() - (hinted ? 1 : 0));
        worker.take(Hinted{{all->blocks.back()}});
        EXPECT_FALSE(worker.ahead()) << "something is needed at once";
        (void)worker.opened(BlocksSent{wanted->blocks});
        EXPECT_EQ(worker.ready_count(), 4u);
        EXPECT_FALSE(worker.ahead()) << "it is here";
    }
}

TEST(ClusterModels, AWorkerGivesBackWhatItHasNotBegun) {
    const Workload workload = make_synthetic_workload(2, 4);
    WorkerModel worker(WorkerId{1}, workload);
    const auto wanted = worker.take(BatchSent{TaskId{7}, {0, 1, 2, 3}, true});
    ASSERT_TRUE(wanted);
    EXPECT_EQ(worker.take(AskedBack{TaskId{7}, {3}}).scenarios, (std::vector<std::uint64_t>{3}));
    (void)worker.opened(BlocksSent{wanted->blocks});
    ASSERT_EQ(worker.ready_count(), 3u);
    const std::uint64_t begun = worker.next();
    EXPECT_EQ(begun, 0u);
    const GaveBack gave = worker.take(AskedBack{TaskId{7}, {0, 2}});
    EXPECT_EQ(gave.scenarios, (std::vector<std::uint64_t>{2, 3})) << "all so far";
    EXPECT_FALSE(worker.take(CalledOff{TaskId{7}, 1})) << "it does not run";
    EXPECT_EQ(worker.ready_count(), 0u);
    EXPECT_TRUE(worker.take(CalledOff{TaskId{7}, 0}));
    worker.ran(begun, 1.0, 0.5);
    const auto last = worker.due(1.0, 1);
    ASSERT_EQ(last.size(), 1u);
    EXPECT_TRUE(last[0].scenarios.empty());
    EXPECT_TRUE(last[0].ends_task);
}

} // namespace
} // namespace cd::tests
