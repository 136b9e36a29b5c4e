// Proves that both sides of the index, workers and blocks, agree after each change.
#include "master/blocks/block_index.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {
namespace {

constexpr WorkerId one{1};
constexpr WorkerId two{2};
constexpr WorkerId deaf{3}; ///< Serves no peers.
constexpr BlockKey red{TreeId{1}, 4};
constexpr BlockKey blue{TreeId{1}, 7};
constexpr BlockIndex::Time start{};

class BlockIndices : public testing::Test {
  protected:
    BlockIndices() {
        index_.join(one, true);
        index_.join(two, true);
        index_.join(deaf, false);
    }
    ~BlockIndices() override { index_.check_invariants(); }

    [[nodiscard]] std::vector<WorkerId> ids(const SlotSet& slots) const {
        std::vector<WorkerId> ids;
        for (auto slot = slots.next(0); slot != SlotSet::none; slot = slots.next(slot + 1)) {
            ids.push_back(index_.peers()[slot]->id);
        }
        return ids;
    }

    using Workers = std::vector<WorkerId>;
    BlockIndex index_;
};

TEST_F(BlockIndices, OnlyAWorkerThatServesPeersIsAHolder) {
    index_.add_hold(one, red, {});
    index_.add_hold(deaf, red, {});
    EXPECT_EQ(ids(index_.blocks().at(red).holders), Workers{one});
    EXPECT_TRUE(index_.lose_hold(one, red));
    EXPECT_FALSE(index_.lose_hold(one, red));
    index_.forget_if_unused(red);
    EXPECT_TRUE(index_.blocks().empty());
}

TEST_F(BlockIndices, ABlockIsUnderWayUntilItsDeliveryEnds) {
    index_.send(deaf, red, 5);
    index_.forget_if_unused(red);
    EXPECT_EQ(ids(index_.blocks().at(red).on_the_way_to), Workers{deaf});
    EXPECT_EQ(index_.stop_sending(deaf, red), 5u);
    EXPECT_EQ(index_.stop_sending(deaf, red), std::nullopt);
}

TEST_F(BlockIndices, AHolderServesTheWorkersThatAwaitItsBlocks) {
    index_.add_hold(one, red, {});
    index_.wait(deaf, red, start);
    (void)index_.known(blue);
    index_.wait(deaf, blue, start);
    index_.add_hold(two, red, {});
    EXPECT_EQ(index_.next_for(one), deaf);
    EXPECT_EQ(index_.next_for(two), deaf);
    index_.stop_waiting(deaf, red);
    EXPECT_EQ(index_.next_for(one), WorkerId{}) << "it holds no other block";
    index_.stop_waiting(deaf, blue);
    EXPECT_TRUE(index_.awaited().empty());
}

TEST_F(BlockIndices, ASlotGoesToALaterWorker) {
    index_.add_hold(one, red, {});
    index_.add_hold(two, red, {});
    EXPECT_TRUE(index_.lose_hold(one, red));
    index_.leave(one);
    EXPECT_EQ(index_.find(one), nullptr);
    const WorkerId four{4};
    index_.join(four, true);
    EXPECT_EQ(index_.at(four).slot, 0u);
    EXPECT_EQ(ids(index_.free()), (Workers{four, two}));
    EXPECT_EQ(ids(index_.blocks().at(red).holders), Workers{two});
}

TEST_F(BlockIndices, TheLongestWaitingWorkerThatReachesTheSourceIsNext) {
    index_.add_hold(one, red, {});
    index_.add_hold(one, blue, {});
    index_.wait(deaf, blue, start);
    index_.wait(two, red, start);
    EXPECT_EQ(index_.next_for(one), deaf);
    index_.set_unreachable(one, deaf);
    EXPECT_EQ(index_.next_for(one), two);
    EXPECT_EQ(index_.next_for(two), WorkerId{});
}

TEST_F(BlockIndices, ASourceHasALimitedNumberOfUploadSlots) {
    for (std::size_t i = 0; i < limits::peer_uploads_max; ++i) {
        EXPECT_EQ(ids(index_.free()), (Workers{one, two}));
        index_.add_upload(one);
    }
    EXPECT_EQ(ids(index_.free()), Workers{two});
    index_.remove_upload(one);
    EXPECT_EQ(ids(index_.free()), (Workers{one, two}));
}

TEST_F(BlockIndices, ASourceThatTooManyWorkersCannotReachServesNoWorker) {
    index_.add_hold(one, red, {});
    const BlockIndex::Block& block = index_.blocks().at(red);
    EXPECT_TRUE(index_.is_worth_waiting(block, deaf));
    for (std::uint64_t worker = 10; worker < 10 + limits::peer_unreachable_by_max; ++worker) {
        EXPECT_TRUE(index_.can_serve(one, two));
        index_.set_unreachable(one, WorkerId{worker});
    }
    EXPECT_FALSE(index_.can_serve(one, two));
    EXPECT_EQ(ids(index_.free()), Workers{two});
    EXPECT_FALSE(index_.is_worth_waiting(block, deaf));
    index_.send(two, red, 0); // A worker that will hold it.
    EXPECT_TRUE(index_.is_worth_waiting(block, deaf));
    index_.avoid(two);
    EXPECT_FALSE(index_.is_worth_waiting(block, deaf));
}

} // namespace
} // namespace cd::tests
