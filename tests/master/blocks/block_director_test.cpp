// Proves that every wanted block arrives, whatever fails; that a block wanted by all costs the
// master a bounded number of uploads and spreads in logarithmically many rounds; that no worker
// exceeds its serving limit; and that failing sources are avoided.
#include "master/blocks/block_director.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using Time = BlockDirector::Time;

constexpr TreeId tree{1};
constexpr RootIndex hot = 7;

WorkerId worker(std::uint64_t number) {
    return WorkerId{number};
}

/// Returns the only action if it is a SendBlock.
std::optional<SendBlock> from_master(const BlockActions& actions) {
    const auto* send = actions.size() == 1 ? std::get_if<SendBlock>(&actions[0]) : nullptr;
    return send == nullptr ? std::nullopt : std::optional(*send);
}

std::optional<SendToPeers> from_peers(const BlockActions& actions) {
    const auto* fetch = actions.size() == 1 ? std::get_if<SendToPeers>(&actions[0]) : nullptr;
    return fetch == nullptr ? std::nullopt : std::optional(*fetch);
}

/// A director with workers 1 to `count`, which serve each other.
struct BlockDirectorTest : testing::Test {
    void join(std::uint64_t count) {
        for (std::uint64_t i = 1; i <= count; ++i) {
            director.worker_joined(worker(i), true);
        }
    }
    BlockActions want(std::uint64_t who, std::vector<RootIndex> roots) {
        return director.wanted(worker(who), tree, roots, now);
    }
    BlockActions hold(std::uint64_t who, std::vector<RootIndex> roots) {
        return director.held(worker(who), tree, roots, now);
    }
    BlockActions fail(std::uint64_t who, std::uint64_t source, PeerOutcome how) {
        return director.peer_failed(worker(who), worker(source), tree, std::vector{hot}, how, now);
    }
    ~BlockDirectorTest() override { director.check_invariants(); }

    BlockDirector director;
    Time now{};
};

TEST_F(BlockDirectorTest, TheFirstWorkerThatWantsABlockGetsItFromTheMaster) {
    join(2);
    const auto send = from_master(want(1, {hot}));
    ASSERT_TRUE(send);
    EXPECT_EQ(*send, (SendBlock{worker(1), {tree, hot}}));
    EXPECT_TRUE(want(1, {hot}).empty()) << "it is on the way already";
}

TEST_F(BlockDirectorTest, AWorkerHoldsABlockOnlyAfterItsReport) {
    join(2);
    (void)want(1, {hot});
    EXPECT_TRUE(want(2, {hot}).empty()) << "on the way to worker 1 is not held";
    const BlockActions actions = hold(1, {hot});
    const auto fetch = from_peers(actions);
    ASSERT_TRUE(fetch);
    EXPECT_EQ(*fetch, (SendToPeers{worker(2), tree, {hot}, {worker(1)}}));
}

TEST_F(BlockDirectorTest, ANonServingHolderDelaysNoOtherWorker) {
    director.worker_joined(worker(1), false);
    director.worker_joined(worker(2), true);
    (void)want(1, {hot});
    EXPECT_TRUE(from_master(want(2, {hot})));
}

TEST_F(BlockDirectorTest, ManyBlocksAreSpreadOverTheirHolders) {
    join(4);
    const std::vector<RootIndex> roots{0, 1, 2, 3, 4, 5, 6, 7, 8};
    for (const std::uint64_t holder : {1, 2, 3}) {
        (void)hold(holder, roots);
    }
    const BlockActions actions = want(4, roots);
    ASSERT_EQ(actions.size(), 3u);
    for (const BlockAction& action : actions) {
        const auto& fetch = std::get<SendToPeers>(action);
        EXPECT_EQ(fetch.roots.size(), 3u);
        EXPECT_EQ(fetch.sources.size(), 3u) << "the others stand in";
    }
}

TEST_F(BlockDirectorTest, AThirdFetchWaitsForAnUploadSlot) {
    join(4);
    (void)hold(1, {hot});
    EXPECT_TRUE(from_peers(want(2, {hot})));
    EXPECT_TRUE(from_peers(want(3, {hot})));
    EXPECT_TRUE(want(4, {hot}).empty());
    const auto fetch = from_peers(hold(2, {hot}));
    ASSERT_TRUE(fetch);
    EXPECT_EQ(fetch->to, worker(4));
}

TEST_F(BlockDirectorTest, BlocksThatPeersDidNotGiveComeFromTheMaster) {
    join(2);
    (void)hold(1, {hot});
    ASSERT_TRUE(from_peers(want(2, {hot})));
    EXPECT_TRUE(fail(2, 1, PeerOutcome::Unreachable).empty());
    EXPECT_TRUE(from_master(want(2, {hot})));
}

TEST_F(BlockDirectorTest, ASourceThatTwoWorkersCannotReachIsAvoided) {
    join(4);
    (void)hold(1, {hot, 8});
    for (const std::uint64_t who : {2, 3}) {
        EXPECT_FALSE(director.is_avoided(worker(1)));
        ASSERT_TRUE(from_peers(want(who, {hot})));
        (void)fail(who, 1, PeerOutcome::Unreachable);
        EXPECT_TRUE(from_master(want(who, {hot})));
    }
    EXPECT_TRUE(director.is_avoided(worker(1)));
    EXPECT_TRUE(from_master(want(4, {8})));
}

TEST_F(BlockDirectorTest, ASourceThatAProbeDidNotReachIsAvoided) {
    join(3);
    (void)hold(1, {hot});
    EXPECT_TRUE(director.not_reached(worker(1), now).empty());
    EXPECT_TRUE(director.is_avoided(worker(1)));
    EXPECT_TRUE(from_master(want(2, {hot})));
    EXPECT_TRUE(director.not_reached(worker(9), now).empty()) << "it has left";
}

TEST_F(BlockDirectorTest, ABlockAwaitedFromAnUnreachableSourceComesFromTheMaster) {
    join(4);
    (void)hold(1, {hot, 8});
    ASSERT_TRUE(from_peers(want(2, {8})));
    ASSERT_TRUE(from_peers(want(3, {8})));
    ASSERT_TRUE(want(4, {hot}).empty()) << "it waits for a place";
    const auto send = from_master(director.not_reached(worker(1), now));
    ASSERT_TRUE(send);
    EXPECT_EQ(*send, (SendBlock{worker(4), {tree, hot}}));
}

TEST_F(BlockDirectorTest, AnUnreachableSourceIsNotNamedAgain) {
    join(3);
    (void)hold(1, {hot, 8});
    (void)want(2, {hot});
    (void)fail(2, 1, PeerOutcome::Unreachable);
    EXPECT_TRUE(from_master(want(2, {8})));
    EXPECT_TRUE(from_peers(want(3, {8})));
}

TEST_F(BlockDirectorTest, ASourceOfDamageIsAvoidedAtOnce) {
    join(3);
    (void)hold(1, {hot});
    (void)want(2, {hot});
    (void)fail(2, 1, PeerOutcome::Damaged);
    EXPECT_TRUE(director.is_avoided(worker(1)));
    EXPECT_TRUE(want(3, {hot}).empty()) << "worker 2 gets it from the master, as it will say";
    EXPECT_TRUE(from_master(want(2, {hot})));
    const auto fetch = from_peers(hold(2, {hot}));
    ASSERT_TRUE(fetch);
    EXPECT_EQ(fetch->sources, std::vector{worker(2)});
}

TEST_F(BlockDirectorTest, ABlockAwaitedFromALeavingWorkerComesFromTheMaster) {
    join(3);
    (void)want(1, {hot});
    EXPECT_TRUE(want(2, {hot}).empty());
    EXPECT_TRUE(want(3, {hot}).empty());
    const auto send = from_master(director.worker_left(worker(1), now));
    ASSERT_TRUE(send) << "one of the two; the other waits for it";
    EXPECT_EQ(send->to, worker(2));
}

TEST_F(BlockDirectorTest, AnEvictedBlockIsNotHeld) {
    join(2);
    (void)hold(1, {hot});
    EXPECT_TRUE(director.evicted(worker(1), tree, std::vector{hot}, now).empty());
    EXPECT_TRUE(from_master(want(2, {hot})));
}

TEST_F(BlockDirectorTest, NoWorkerWaitsForEver) {
    join(3);
    (void)want(1, {hot});
    (void)want(2, {hot});
    now += timing::peer_wait_max;
    EXPECT_TRUE(from_master(director.time_is(now)));
    (void)hold(1, {hot});
    EXPECT_TRUE(from_peers(want(3, {hot})));
    now += timing::peer_fetch_max;
    EXPECT_TRUE(from_master(director.time_is(now)));
    EXPECT_EQ(director.open(), 2u);
}

TEST_F(BlockDirectorTest, AWorkerWaitsOnWhileTheBlockSpreads) {
    join(6);
    (void)want(1, {hot});
    (void)hold(1, {hot});
    for (std::uint64_t other = 2; other <= 4; ++other) {
        (void)want(other, {hot}); // Two are served, the third waits.
    }
    now += timing::peer_wait_max - 1s;
    (void)hold(2, {hot}); // Worker 1 serves worker 4 now.
    EXPECT_TRUE(want(5, {hot}).size() == 1) << "worker 2 serves it";
    (void)director.evicted(worker(2), tree, std::vector{hot}, now);
    EXPECT_TRUE(want(6, {hot}).empty());
    now += timing::peer_wait_max - 1s;
    EXPECT_FALSE(hold(3, {hot}).empty()) << "worker 6 gets it";
    EXPECT_TRUE(director.time_is(now).empty());
    EXPECT_TRUE(want(2, {hot}).size() == 1);
    EXPECT_EQ(director.open(), 4u);
}

TEST_F(BlockDirectorTest, FewSourcesGiveTheBlocksOfOneRequest) {
    join(20);
    const std::vector<RootIndex> roots{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    for (std::uint64_t source = 1; source <= 19; ++source) {
        (void)hold(source, roots);
    }
    const BlockActions actions = want(20, roots);
    EXPECT_EQ(actions.size(), limits::sources_of_a_request_max);
    for (const BlockAction& action : actions) {
        EXPECT_EQ(std::get<SendToPeers>(action).roots.size(),
                  roots.size() / limits::sources_of_a_request_max);
    }
}

TEST_F(BlockDirectorTest, ARemovedTreeLeavesNothing) {
    join(3);
    (void)hold(1, {hot});
    (void)want(2, {hot, 8});
    (void)want(3, {8});
    EXPECT_TRUE(director.tree_removed(tree, now).empty());
    EXPECT_EQ(director.open(), 0u);
    director.check_invariants();
    EXPECT_TRUE(from_master(want(3, {hot})));
}

// ---- In simulated time ------------------------------------------------------------------------

/// Workers that obey the director; each transfer takes one round, and some workers fail.
class Cluster {
  public:
    Cluster(std::uint64_t seed, std::uint64_t workers, double trouble)
        : random_(seed), trouble_(trouble) {
        for (std::uint64_t i = 1; i <= workers; ++i) {
            director_.worker_joined(worker(i), true);
            alive_.insert(worker(i));
        }
    }

    void want(WorkerId who, const std::vector<RootIndex>& roots) {
        for (const RootIndex root : roots) {
            wants_.insert({who, root});
        }
        take(director_.wanted(who, tree, roots, now_));
    }

    /// Apply the decisions of the round before.
    void step() {
        now_ += 100ms;
        const BlockActions round = std::exchange(actions_, {});
        for (const BlockAction& action : round) {
            if (const auto send = std::get_if<SendBlock>(&action)) {
                ++master_uploads_;
                arrive(send->to, {send->block.root});
            } else {
                fetch(std::get<SendToPeers>(action));
            }
        }
        take(director_.time_is(now_));
        director_.check_invariants();
    }

    void lose(WorkerId who) {
        alive_.erase(who);
        std::erase_if(wants_, [&](const auto& want) { return want.first == who; });
        take(director_.worker_left(who, now_));
    }

    [[nodiscard]] bool is_done() const { return wants_.empty(); }
    [[nodiscard]] std::size_t master_uploads() const { return master_uploads_; }
    [[nodiscard]] bool has_trouble() { return chance_(random_) < trouble_; }
    std::mt19937_64& random() { return random_; }

  private:
    void take(BlockActions actions) {
        actions_.insert(actions_.end(), actions.begin(), actions.end());
    }

    void fetch(const SendToPeers& fetch) {
        if (!alive_.contains(fetch.to)) {
            return;
        }
        for (const WorkerId source : fetch.sources) {
            if (alive_.contains(source) && !has_trouble()) {
                return arrive(fetch.to, fetch.roots);
            }
            const auto how = static_cast<PeerOutcome>(1 + random_() % 3);
            take(director_.peer_failed(fetch.to, source, tree, fetch.roots, how, now_));
        }
        if (has_trouble()) {
            return; // No report at all; a timeout reveals the failure.
        }
        take(director_.wanted(fetch.to, tree, fetch.roots, now_));
    }

    void arrive(WorkerId who, const std::vector<RootIndex>& roots) {
        if (!alive_.contains(who)) {
            return;
        }
        for (const RootIndex root : roots) {
            wants_.erase({who, root});
        }
        take(director_.held(who, tree, roots, now_));
    }

    BlockDirector director_;
    std::mt19937_64 random_;
    double trouble_;
    std::uniform_real_distribution<double> chance_{0, 1};
    Time now_{};
    std::set<WorkerId> alive_;
    std::set<std::pair<WorkerId, RootIndex>> wants_;
    BlockActions actions_;
    std::size_t master_uploads_ = 0;
};

TEST(BlockSpreading, AHotBlockCostsTheMasterOneUploadAndALogarithmOfRounds) {
    for (const std::uint64_t workers : {2, 16, 64, 256, 1000}) {
        Cluster cluster(1, workers, 0);
        for (std::uint64_t i = 1; i <= workers; ++i) {
            cluster.want(worker(i), {hot});
        }
        int rounds = 0;
        while (!cluster.is_done()) {
            cluster.step();
            ++rounds;
        }
        EXPECT_EQ(cluster.master_uploads(), 1u) << workers;
        EXPECT_LE(rounds, 2 + std::ceil(std::log2(workers))) << workers;
    }
}

TEST(BlockSpreading, AllBlocksArriveWhicheverFetchesFail) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Cluster cluster(seed, 12, 0.3);
        for (std::uint64_t i = 1; i <= 12; ++i) {
            std::vector<RootIndex> roots;
            for (RootIndex root = 0; root < 20; ++root) {
                if (cluster.random()() % 2 == 0) {
                    roots.push_back(root);
                }
            }
            cluster.want(worker(i), roots);
            if (cluster.random()() % 4 == 0) {
                cluster.step();
            }
            if (i % 5 == 0) {
                cluster.lose(worker(i - 2));
            }
        }
        int rounds = 0;
        while (!cluster.is_done() && rounds < 2000) {
            cluster.step();
            ++rounds;
        }
        ASSERT_TRUE(cluster.is_done()) << "seed " << seed;
    }
}

} // namespace
} // namespace cd::tests
