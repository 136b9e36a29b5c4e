// Proves that the cache keeps its limit, evicts blocks of parked trees first and then the least
// recently used subtree, never evicts pinned ones, reports evictions, and rejects subtrees with a
// wrong hash or shape.
#include "worker/cache/subtree_cache.hpp"

#include "common/core/limits/worker.hpp"
#include "tests/worker/cut_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace cd::tests {
namespace {

constexpr TreeId tree{7};
constexpr std::uint64_t unlimited = std::uint64_t{1} << 40;

Sha256 some_name(unsigned char number) {
    Sha256 name;
    name.bytes[7] = std::byte{number};
    return name;
}

/// Makes about eight subtrees of about equal size.
class SubtreeCacheTest : public testing::Test {
  protected:
    [[nodiscard]] std::shared_ptr<const Subtree> subtree(RootIndex root) const {
        return std::get<std::shared_ptr<const Subtree>>(open_block(body.blocks[root]).value());
    }
    /// Returns the tree with this id and cut hash.
    [[nodiscard]] AddTree add(TreeId id, const Sha256& cut = {}) const {
        AddTree add = body.add(id);
        add.cut = cut;
        return add;
    }
    [[nodiscard]] SubtreeCache cache_for(std::uint64_t bytes) const {
        SubtreeCache cache(bytes);
        EXPECT_TRUE(cache.add_tree(add(tree)));
        return cache;
    }
    void insert(SubtreeCache& cache, RootIndex root) const {
        EXPECT_TRUE(cache.insert({tree, root}, subtree(root)));
    }
    [[nodiscard]] std::uint64_t bytes_of(std::initializer_list<RootIndex> roots) const {
        std::uint64_t bytes = 0;
        for (const RootIndex root : roots) {
            bytes += subtree(root)->memory_bytes();
        }
        return bytes;
    }

    CutBody body = cut_body(make_sphere(3), 3);
};

TEST_F(SubtreeCacheTest, WhatCameInIsHere) {
    SubtreeCache cache = cache_for(unlimited);
    EXPECT_EQ(cache.at({tree, 2}), nullptr);
    insert(cache, 2);
    EXPECT_NE(cache.at({tree, 2}), nullptr);
    EXPECT_EQ(cache.find(tree)->at(2), cache.at({tree, 2}));
    EXPECT_EQ(cache.bytes(), bytes_of({2}));
    EXPECT_TRUE(cache.take_evicted().empty());
}

TEST_F(SubtreeCacheTest, BeyondTheLimitTheLongestUnusedLeaves) {
    SubtreeCache cache = cache_for(bytes_of({0, 1, 2}));
    insert(cache, 0);
    insert(cache, 1);
    insert(cache, 2);
    cache.pin({tree, 0}); // Uses 0: now 1 is least recently used.
    cache.unpin({tree, 0});
    insert(cache, 3);
    EXPECT_EQ(cache.at({tree, 1}), nullptr);
    EXPECT_NE(cache.at({tree, 0}), nullptr);
    const auto evicted = cache.take_evicted();
    ASSERT_FALSE(evicted.empty());
    EXPECT_EQ(evicted.front(), (SubtreeKey{tree, 1}));
    EXPECT_LE(cache.bytes(), cache.bytes_max());
    EXPECT_TRUE(cache.take_evicted().empty()) << "each is told once";
}

TEST_F(SubtreeCacheTest, WhenMemoryIsShortTheLongestUnusedLeavesButNothingPinned) {
    SubtreeCache cache = cache_for(unlimited);
    insert(cache, 0);
    insert(cache, 1);
    insert(cache, 2);
    cache.pin({tree, 0});
    EXPECT_EQ(cache.let_go(bytes_of({0, 2})), 1u);
    EXPECT_EQ(cache.at({tree, 1}), nullptr);
    EXPECT_EQ(cache.let_go(0), 1u);
    EXPECT_NE(cache.at({tree, 0}), nullptr);
    EXPECT_EQ(cache.take_evicted(), (std::vector{SubtreeKey{tree, 1}, SubtreeKey{tree, 2}}));
    insert(cache, 1); // This time there is room again.
    EXPECT_NE(cache.at({tree, 1}), nullptr);
}

TEST_F(SubtreeCacheTest, WhatIsPinnedStaysEvenBeyondTheLimit) {
    SubtreeCache cache = cache_for(1);
    for (RootIndex root = 0; root < 3; ++root) {
        cache.pin({tree, root}); // Pins it before it arrives.
        insert(cache, root);
    }
    EXPECT_EQ(cache.bytes(), bytes_of({0, 1, 2}));
    EXPECT_TRUE(cache.take_evicted().empty());
    cache.unpin({tree, 1});
    EXPECT_EQ(cache.at({tree, 1}), nullptr);
    EXPECT_EQ(cache.bytes(), bytes_of({0, 2}));
    cache.unpin({tree, 0});
    cache.unpin({tree, 2});
    EXPECT_EQ(cache.bytes(), 0u);
    EXPECT_EQ(cache.take_evicted().size(), 3u);
}

TEST_F(SubtreeCacheTest, UnneededBlocksAreLetGoAtOnceWhenTheLimitIsTiny) {
    SubtreeCache cache = cache_for(1);
    insert(cache, 0);
    EXPECT_EQ(cache.at({tree, 0}), nullptr);
    EXPECT_EQ(cache.take_evicted(), (std::vector<SubtreeKey>{{tree, 0}}));
}

TEST_F(SubtreeCacheTest, ParkingATreeTouchesNoOtherAndDroppingItFreesItsBlocks) {
    SubtreeCache cache = cache_for(unlimited);
    const TreeId other{8};
    ASSERT_TRUE(cache.add_tree(add(other)));
    insert(cache, 0);
    cache.pin({tree, 1});
    insert(cache, 1);
    ASSERT_TRUE(cache.insert({other, 4}, subtree(4)));
    const std::weak_ptr<const Subtree> freed = cache.at({tree, 1});
    cache.park(tree);
    EXPECT_FALSE(freed.expired());
    EXPECT_EQ(cache.bytes(), bytes_of({0, 1, 4}));
    EXPECT_EQ(cache.bytes_in_use(), bytes_of({4}));
    cache.drop_parked();
    EXPECT_TRUE(freed.expired());
    EXPECT_EQ(cache.bytes(), bytes_of({4}));
    EXPECT_EQ(cache.bytes_in_use(), bytes_of({4}));
    EXPECT_EQ(cache.find(tree), nullptr);
    EXPECT_EQ(cache.at({tree, 0}), nullptr);
    EXPECT_TRUE(cache.take_evicted().empty());
    // Blocks that still arrive and scenarios that still end do no harm.
    insert(cache, 3);
    cache.unpin({tree, 1});
    cache.park(tree);
    EXPECT_EQ(cache.bytes(), bytes_of({4}));
}

TEST_F(SubtreeCacheTest, ATopStaysWhileItsTreeIsNotParked) {
    SubtreeCache cache = cache_for(1);
    const SubtreeKey key{tree, top_root};
    EXPECT_FALSE(cache.has(key));
    EXPECT_EQ(cache.bytes_expected(key), body.top.nodes.size() * sizeof(ObbNode));
    const auto block = std::make_shared<const SubtreeBlock>(body.top_block);
    ASSERT_TRUE(cache.insert(key, open_block(*block).value(), block));
    ASSERT_TRUE(cache.has(key));
    EXPECT_EQ(cache.find(tree)->top().nodes, body.top.nodes);
    EXPECT_EQ(cache.block_at(key), block);
    EXPECT_EQ(cache.at(key), nullptr) << "it is no subtree";
    EXPECT_EQ(cache.held(tree), std::vector<RootIndex>{top_root});
    EXPECT_EQ(cache.bytes(), cache.bytes_expected(key) + block->compressed.size());
    EXPECT_TRUE(cache.snapshot(tree)->has_top());
    cache.pin(key); // Nothing to pin.
    cache.unpin(key);
    cache.park_all();
    EXPECT_TRUE(cache.take_evicted().empty());
    EXPECT_EQ(cache.bytes(), 0u);
    ASSERT_TRUE(cache.add_tree(add(TreeId{9})));
    EXPECT_FALSE(cache.has({TreeId{9}, top_root}));
}

TEST_F(SubtreeCacheTest, ATopComesBackWithItsTree) {
    SubtreeCache cache = cache_for(unlimited);
    ASSERT_TRUE(cache.insert({tree, top_root}, open_block(body.top_block).value()));
    cache.park_all();
    ASSERT_TRUE(cache.add_tree(add(TreeId{9})));
    EXPECT_TRUE(cache.has({TreeId{9}, top_root}));
    EXPECT_EQ(cache.let_go(0), 0u) << "it is not parked";
    cache.park(TreeId{9});
    EXPECT_EQ(cache.let_go(0), 1u);
    EXPECT_EQ(cache.bytes(), 0u);
}

TEST_F(SubtreeCacheTest, ATopOfAnotherTreeIsRefused) {
    SubtreeCache cache = cache_for(unlimited);
    const CutBody deeper = cut_body(make_sphere(3), 4);
    const CutBody larger = cut_body(make_sphere(4), 3);
    EXPECT_FALSE(cache.insert({tree, top_root}, open_block(deeper.top_block).value()));
    EXPECT_FALSE(cache.insert({tree, top_root}, open_block(larger.top_block).value()));
    EXPECT_FALSE(cache.has({tree, top_root}));
}

TEST_F(SubtreeCacheTest, ADuplicateIsIgnored) {
    SubtreeCache cache = cache_for(unlimited);
    insert(cache, 5);
    const auto first = cache.at({tree, 5});
    insert(cache, 5);
    EXPECT_EQ(cache.at({tree, 5}), first);
    EXPECT_EQ(cache.bytes(), bytes_of({5}));
}

TEST_F(SubtreeCacheTest, WhatDoesNotFitTheTreeIsRefused) {
    SubtreeCache cache = cache_for(unlimited);
    EXPECT_FALSE(cache.add_tree(add(tree))) << "twice";
    EXPECT_FALSE(cache.insert({tree, body.top.root_count()}, subtree(0)));
    const CutBody binary = cut_body(make_sphere(3), 3, SubtreeForm::Binary);
    EXPECT_FALSE(cache.insert({tree, 0}, open_block(binary.blocks[0]).value()));
    EXPECT_EQ(cache.bytes(), 0u);
    const CutBody box = cut_body(make_box(Vec3(1, 1, 1)), 0);
    ASSERT_TRUE(cache.insert({tree, 0}, open_block(box.blocks[0]).value())) << "not yet known";
    EXPECT_FALSE(cache.insert({tree, top_root}, open_block(body.top_block).value()));
    cache.park(tree);
    cache.drop_parked();
    ASSERT_TRUE(cache.add_tree(add(tree)));
    ASSERT_TRUE(cache.insert({tree, top_root}, open_block(body.top_block).value()));
    EXPECT_FALSE(cache.insert({tree, 0}, open_block(box.blocks[0]).value()));
}

TEST_F(SubtreeCacheTest, ABlockWithAnotherHashIsRefused) {
    SubtreeBlock block = body.blocks[0];
    EXPECT_TRUE(open_block(block));
    block.hash = body.blocks[1].hash;
    const auto opened = open_block(block);
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().detail, testing::HasSubstr("hash"));
}

TEST_F(SubtreeCacheTest, BytesThatAreNoBlockAreRefusedWhateverTheirHash) {
    SubtreeBlock block;
    block.compressed = Bytes(20, std::byte{1});
    EXPECT_FALSE(open_block(block)) << "not compressed";
    const Bytes nonsense(20, std::byte{1});
    block.compressed = compress(nonsense, compression_level_fast);
    block.hash = sha256(nonsense);
    EXPECT_FALSE(open_block(block)) << "no subtree";
}

TEST_F(SubtreeCacheTest, AParkedTreeComesBackUnderAnotherNumberWithWhatItHad) {
    const Sha256 cut = some_name(1);
    SubtreeCache cache(unlimited);
    ASSERT_TRUE(cache.add_tree(add(tree, cut)));
    for (const RootIndex root : {1u, 3u, 4u}) {
        insert(cache, root);
    }
    cache.pin({tree, 3});
    cache.park(tree);
    EXPECT_EQ(cache.find(tree), nullptr);
    EXPECT_EQ(cache.parked(), std::vector<Sha256>{cut});

    const TreeId other{1};
    ASSERT_TRUE(cache.add_tree(add(other, cut)));
    EXPECT_EQ(cache.held(other), (std::vector<RootIndex>{1, 3, 4}));
    EXPECT_NE(cache.at({other, 3}), nullptr);
    EXPECT_TRUE(cache.parked().empty());
    EXPECT_EQ(cache.bytes_in_use(), bytes_of({1, 3, 4}));
    cache.pin({other, 3});
    cache.unpin({other, 3});
    EXPECT_EQ(cache.let_go(0), 3u);
    EXPECT_EQ(cache.take_evicted().size(), 3u);
    cache.park(other);
    EXPECT_TRUE(cache.parked().empty()) << "it has no blocks";
}

TEST_F(SubtreeCacheTest, OnlyTheSameCutInTheSameFormBringsAParkedTreeBack) {
    const Sha256 cut = some_name(1);
    SubtreeCache cache(unlimited);
    ASSERT_TRUE(cache.add_tree(add(tree, cut)));
    insert(cache, 1);
    cache.park_all();
    ASSERT_TRUE(cache.add_tree(add(TreeId{1}, some_name(2))));
    AddTree other_form = add(TreeId{2}, cut);
    other_form.form = SubtreeForm::Binary;
    ASSERT_TRUE(cache.add_tree(other_form));
    AddTree other_top = add(TreeId{3}, cut);
    other_top.top = some_name(3);
    ASSERT_TRUE(cache.add_tree(other_top));
    for (const TreeId id : {TreeId{1}, TreeId{2}, TreeId{3}}) {
        EXPECT_TRUE(cache.held(id).empty());
    }
    EXPECT_EQ(cache.parked().size(), 1u);
    cache.drop_parked();
    EXPECT_TRUE(cache.parked().empty());
    EXPECT_EQ(cache.bytes(), 0u);
}

TEST_F(SubtreeCacheTest, ParkedSubtreesLeaveFirstAndNobodyIsTold) {
    SubtreeCache cache(bytes_of({2, 3, 4}));
    ASSERT_TRUE(cache.add_tree(add(tree, some_name(1))));
    insert(cache, 0);
    insert(cache, 1);
    cache.park_all();
    ASSERT_TRUE(cache.add_tree(add(tree, some_name(2))));
    for (const RootIndex root : {2u, 3u, 4u}) {
        insert(cache, root);
    }
    EXPECT_LE(cache.bytes(), cache.bytes_max());
    EXPECT_TRUE(cache.take_evicted().empty());
    EXPECT_EQ(cache.held(tree), (std::vector<RootIndex>{2, 3, 4}));
    EXPECT_TRUE(cache.parked().empty());
}

TEST_F(SubtreeCacheTest, ParkedTreesLeaveBeforeLongUnusedOnesAndThoseParkedFirstBeforeTheOthers) {
    SubtreeCache cache(unlimited);
    ASSERT_TRUE(cache.add_tree(add(tree, some_name(1))));
    insert(cache, 0);
    for (unsigned char number = 2; number < 4; ++number) {
        const TreeId other{number};
        ASSERT_TRUE(cache.add_tree(add(other, some_name(number))));
        ASSERT_TRUE(cache.insert({other, 1}, subtree(1)));
        ASSERT_TRUE(cache.insert({other, top_root}, open_block(body.top_block).value()));
        cache.park(other);
    }
    ASSERT_EQ(cache.parked(), (std::vector{some_name(2), some_name(3)}));
    EXPECT_EQ(cache.let_go(cache.bytes() - 1), 1u);
    EXPECT_EQ(cache.parked().size(), 2u) << "the upper tree of the first is still here";
    EXPECT_EQ(cache.let_go(cache.bytes() - 1), 1u);
    EXPECT_EQ(cache.parked(), std::vector{some_name(3)});
    EXPECT_EQ(cache.let_go(bytes_of({0})), 2u);
    EXPECT_TRUE(cache.parked().empty());
    EXPECT_TRUE(cache.take_evicted().empty()) << "the master does not know of them";
    EXPECT_NE(cache.at({tree, 0}), nullptr);
}

TEST_F(SubtreeCacheTest, TheNumberOfParkedTreesIsBounded) {
    SubtreeCache cache(unlimited);
    const auto top = open_block(body.top_block).value();
    for (std::uint64_t number = 1; number <= limits::parked_trees_max + 1; ++number) {
        Sha256 name;
        std::memcpy(name.bytes.data(), &number, sizeof number);
        ASSERT_TRUE(cache.add_tree(add(TreeId{number}, name)));
        ASSERT_TRUE(cache.insert({TreeId{number}, top_root}, top));
        cache.park(TreeId{number});
    }
    EXPECT_EQ(cache.parked().size(), limits::parked_trees_max);
}

} // namespace
} // namespace cd::tests
