// Proves that traffic counts once in total, and once for the job that requested it.
#include "worker/session/traffic_book.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

constexpr JobId job{1};
constexpr JobId other_job{2};
constexpr SubtreeKey key{TreeId{3}, 4};
constexpr SubtreeKey other_key{TreeId{5}, 4};

struct Book : testing::Test {
    Book() {
        book.job_added(job, {key.tree, other_key.tree});
        book.job_added(other_job, {other_key.tree, other_key.tree});
    }
    TrafficBook book;
};

TEST_F(Book, ABlockCountsForTheJobThatAskedForIt) {
    book.missed(job, key);
    book.hinted(other_job, other_key);
    book.came_from_master(key, 100);
    book.came_from_peer(other_key, 30);
    EXPECT_EQ(book.take(job), (BlockTraffic{0, 1, 0, 0, 100, 0}));
    EXPECT_EQ(book.take(other_job), (BlockTraffic{0, 0, 1, 0, 0, 30}));
    EXPECT_EQ(book.total(), (BlockTraffic{0, 1, 1, 0, 100, 30}));
}

TEST_F(Book, ABlockThatIsAskedForAgainCountsForWhoDoes) {
    book.missed(job, key);
    book.came_from_master(key, 100);
    book.evicted(key.tree);
    book.missed(other_job, key);
    book.came_from_master(key, 100);
    EXPECT_EQ(book.take(job), (BlockTraffic{0, 1, 0, 1, 100, 0}));
    EXPECT_EQ(book.take(other_job), (BlockTraffic{0, 1, 0, 0, 100, 0}));
}

TEST_F(Book, WhatIsTakenIsNotTakenAgain) {
    book.found(job, 7);
    EXPECT_EQ(book.take(job).hits, 7u);
    book.found(job, 2);
    EXPECT_EQ(book.take(job).hits, 2u);
    EXPECT_EQ(book.take(job), BlockTraffic{});
    EXPECT_EQ(book.total().hits, 9u);
}

TEST_F(Book, WhatComesForNobodyCountsInTotalAlone) {
    book.missed(job, key);
    book.missed(other_job, other_key);
    book.job_removed(job);
    book.tree_removed(other_key.tree);
    book.came_from_master(key, 100);
    book.came_from_master(other_key, 10);
    book.found(job, 1);
    EXPECT_EQ(book.take(job), BlockTraffic{});
    EXPECT_EQ(book.take(other_job).master_bytes, 0u);
    EXPECT_EQ(book.total().master_bytes, 110u);
    EXPECT_EQ(book.total().hits, 1u);
}

} // namespace
} // namespace cd::tests
