// Proves that a session requests a block once, tells when scenarios have all their blocks, and
// reports to the master what its cache holds and has evicted.
#include "worker/session/block_inbox.hpp"

#include "tests/worker/session/parts.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Tokens = std::vector<BlockInbox::Token>;

constexpr JobId job{1};

struct Inbox : HubStage {
    explicit Inbox(std::uint64_t cache_bytes = unlimited)
        : keep(std::make_shared<CarryOver>(cache_bytes)), blocks(*hub, master, keep, {}) {
        EXPECT_TRUE(blocks.add_tree(bodies().a.add(tree_a)));
        EXPECT_TRUE(blocks.add_tree(bodies().b.add(tree_b)));
        WorkerJob known;
        known.id = job;
        known.trees = {tree_a, tree_b};
        blocks.add_job(known);
    }
    /// Delivers the block, and waits until it is open.
    void deliver(RootIndex root) {
        const std::size_t before = hub->settled;
        blocks.receive({tree_a, {bodies().a.block(root)}});
        run_until([&] { return hub->settled != before; });
    }

    std::shared_ptr<CarryOver> keep;
    BlockInbox blocks;
};

struct SmallInbox : Inbox {
    SmallInbox() : Inbox(1) {}
};

TEST_F(Inbox, AScenarioIsReadyOnceItsBlocksHaveCome) {
    blocks.need(1, job, {{tree_a, 0}, {tree_a, 2}});
    blocks.need(2, job, {{tree_a, 2}});
    EXPECT_THAT(blocks.settle(), IsEmpty());
    ASSERT_EQ(master.sent.size(), 1u);
    EXPECT_THAT(master.all<WantSubtrees>().at(0).roots, ElementsAre(0, 2));
    deliver(2);
    EXPECT_THAT(blocks.settle(), ElementsAre(2));
    deliver(0);
    EXPECT_THAT(blocks.settle(), ElementsAre(1));
    const auto held = master.all<Held>();
    ASSERT_EQ(held.size(), 2u);
    EXPECT_THAT(held[0].roots, ElementsAre(2));
    EXPECT_THAT(held[1].roots, ElementsAre(0));
    EXPECT_EQ(master.sent.size(), 3u);
    const BlockTraffic traffic = blocks.take_traffic(job);
    EXPECT_EQ(traffic.misses, 2u);
    EXPECT_GT(traffic.master_bytes, 0u);
}

TEST_F(Inbox, BlocksAreReportedTogetherWhereTheMasterHasManyWorkers) {
    hub->set_results_wait(std::chrono::hours(100));
    blocks.need(1, job, {{tree_a, 0}, {tree_a, 2}});
    EXPECT_THAT(blocks.settle(), IsEmpty());
    deliver(2);
    EXPECT_THAT(blocks.settle(), IsEmpty());
    EXPECT_THAT(master.all<Held>(), IsEmpty());
    hub->set_results_wait(std::chrono::milliseconds(0));
    deliver(0);
    EXPECT_THAT(blocks.settle(), ElementsAre(1));
    const auto held = master.all<Held>();
    ASSERT_EQ(held.size(), 1u);
    EXPECT_THAT(held[0].roots, ElementsAre(0, 2));
}

TEST_F(SmallInbox, AnEvictionIsReportedBeforeTheNextRequest) {
    blocks.need(1, job, {{tree_a, 0}});
    EXPECT_THAT(blocks.settle(), IsEmpty());
    deliver(0);
    EXPECT_THAT(blocks.settle(), ElementsAre(1));
    master.sent.clear();
    blocks.release(1);
    blocks.need(2, job, {{tree_a, 0}});
    EXPECT_THAT(blocks.settle(), IsEmpty());
    ASSERT_EQ(master.sent.size(), 2u);
    EXPECT_EQ(std::get<Evicted>(master.sent[0]).roots, std::vector<RootIndex>{0});
    EXPECT_EQ(std::get<WantSubtrees>(master.sent[1]).roots, std::vector<RootIndex>{0});
    EXPECT_EQ(blocks.take_traffic(job).evictions, 1u);
}

TEST_F(Inbox, HintsAreOfKnownJobsAndSubtrees) {
    EXPECT_TRUE(blocks.hint({job, tree_a, {0}}));
    EXPECT_THAT(blocks.hint({job, TreeId{99}, {0}}).error().detail, HasSubstr("not here"));
    EXPECT_THAT(blocks.hint({JobId{99}, tree_a, {0}}).error().detail, HasSubstr("not here"));
    EXPECT_THAT(blocks.hint({job, tree_a, {1u << 30}}).error().detail, HasSubstr("does not exist"));
    EXPECT_THAT(blocks.settle(), IsEmpty());
    EXPECT_THAT(master.all<WantSubtrees>().at(0).roots, ElementsAre(0));
    EXPECT_EQ(blocks.take_traffic(job).hinted, 1u);
}

TEST_F(Inbox, ADamagedBlockOfTheMasterIsRefused) {
    Subtrees wrong{tree_a, {bodies().a.blocks[0]}};
    wrong.blocks[0].hash.bytes[0] ^= std::byte{1};
    blocks.receive(wrong);
    run_until([&] { return !master.refused.empty(); });
    EXPECT_THAT(master.refused, ElementsAre(HasSubstr("hash")));
    EXPECT_FALSE(blocks.cache().has({tree_a, 0}));
}

TEST_F(Inbox, PendingRequestsAreRepeatedOverTheNextConnection) {
    blocks.need(1, job, {{tree_a, 0}, {tree_a, 2}});
    EXPECT_THAT(blocks.settle(), IsEmpty());
    deliver(2);
    const auto inventory = blocks.inventory();
    ASSERT_EQ(inventory.size(), 2u);
    EXPECT_THAT(inventory[0].held, ElementsAre(2));
    EXPECT_THAT(inventory[1].held, IsEmpty());
    master.sent.clear();
    blocks.ask_again();
    EXPECT_THAT(blocks.settle(), IsEmpty());
    ASSERT_EQ(master.sent.size(), 1u) << "the inventory has named block 2";
    EXPECT_THAT(master.all<WantSubtrees>().at(0).roots, ElementsAre(0));
}

TEST_F(Inbox, UpperTreesAreRequestedOnce) {
    blocks.need_tops(job, {tree_a});
    blocks.need_tops(job, {tree_a});
    EXPECT_THAT(blocks.settle(), IsEmpty());
    ASSERT_EQ(master.sent.size(), 1u);
    EXPECT_THAT(master.all<WantSubtrees>().at(0).roots, ElementsAre(top_root));
    EXPECT_FALSE(blocks.has_tops({tree_a}));
    deliver(top_root);
    EXPECT_TRUE(blocks.has_tops({tree_a}));
    EXPECT_FALSE(blocks.has_tops({tree_a, tree_b}));
}

TEST_F(Inbox, TheCacheOutlivesTheSession) {
    deliver(1);
    EXPECT_TRUE(keep->cache.parked().empty());
    blocks.leave();
    EXPECT_EQ(keep->cache.parked(), std::vector{bodies().a.add(tree_a).cut});
}

} // namespace
} // namespace cd::tests
