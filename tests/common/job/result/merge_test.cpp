// Proves that results merge once each, in any order, to one digest and one summary.

#include "common/job/result/merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace cd::tests {

namespace {

ScenarioResult make_result(std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    result.level = Level::Pairs;
    if (index % 3 == 1) {
        result.kind = ScenarioClass::Cross;
        result.pair_count = 5;
        result.pairs = {{1, 2, PairClass::Proper}};
    }
    if (index % 3 == 2) {
        result.surfaces_only = true;
    }
    return result;
}

} // namespace

TEST(ResultMerger, TheOrderOfArrivalDoesNotMatter) {
    std::mt19937_64 random(1);
    std::vector<std::uint64_t> order(100);
    std::iota(order.begin(), order.end(), 0u);
    std::optional<Sha256> expected;
    for (int round = 0; round < 5; ++round) {
        ResultMerger merger(order.size());
        for (const std::uint64_t index : order) {
            EXPECT_FALSE(merger.digest());
            EXPECT_FALSE(merger.has(index));
            EXPECT_EQ(merger.add(make_result(index)), ResultMerger::Outcome::Added);
            EXPECT_TRUE(merger.has(index));
        }
        ASSERT_TRUE(merger.digest());
        EXPECT_EQ(merger.digest(), expected.value_or(*merger.digest()));
        expected = merger.digest();
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[random() % i]);
        }
    }
    EXPECT_EQ(to_short_hex(*expected), "31bdf435b1f1dab7");
}

TEST(ResultMerger, TheDigestIsTheHashOfAllDigestsInOrder) {
    for (const std::uint64_t count :
         {1u, 1023u, 1024u, 1025u, 2500u}) { // A list's block has 1,024.
        ResultMerger merger(count);
        Sha256Stream expected;
        for (std::uint64_t index = 0; index < count; ++index) {
            const ScenarioResult result = make_result(index);
            EXPECT_EQ(merger.add(result), ResultMerger::Outcome::Added);
            expected.update(digest_of(result).bytes);
        }
        EXPECT_EQ(merger.digest(), expected.finish()) << count;
    }
}

TEST(ResultMerger, CountsClassesAndCoverage) {
    ResultMerger merger(9);
    for (std::uint64_t i = 0; i < 8; ++i) {
        (void)merger.add(make_result(i));
    }
    const Summary& summary = merger.summary();
    EXPECT_EQ(summary.total, 9u);
    EXPECT_EQ(summary.separate, 5u);
    EXPECT_EQ(summary.cross, 3u);
    EXPECT_EQ(summary.pairs, 15u);
    EXPECT_EQ(summary.cut, 3u);
    EXPECT_EQ(summary.surfaces_only, 2u);
    EXPECT_EQ(summary.tested(), 8u);
    EXPECT_FALSE(summary.is_complete());

    ScenarioResult failed;
    failed.index = 8;
    failed.kind = ScenarioClass::Failed;
    EXPECT_EQ(merger.add(failed), ResultMerger::Outcome::Added);
    EXPECT_TRUE(merger.summary().is_complete());
    EXPECT_EQ(merger.summary().tested(), 8u);
    EXPECT_TRUE(merger.digest());
}

TEST(ResultMerger, TheFirstResultStays) {
    ResultMerger merger(2);
    EXPECT_EQ(merger.add(make_result(1)), ResultMerger::Outcome::Added);
    EXPECT_EQ(merger.add(make_result(1)), ResultMerger::Outcome::Repeated);
    ScenarioResult other = make_result(1);
    other.pair_count = 6;
    EXPECT_EQ(merger.add(other), ResultMerger::Outcome::Differs);
    EXPECT_EQ(merger.add(make_result(2)), ResultMerger::Outcome::Foreign);
    EXPECT_EQ(merger.summary().merged(), 1u);
    EXPECT_EQ(merger.summary().pairs, 5u);
}

TEST(ResultMerger, AfterCloseMergedScenariosAreStillKnown) {
    ResultMerger merger(4);
    for (const std::uint64_t index : {0u, 2u}) {
        EXPECT_EQ(merger.add(make_result(index)), ResultMerger::Outcome::Added);
    }
    const std::uint64_t merged = merger.summary().merged();
    merger.close();
    EXPECT_TRUE(merger.has(2));
    EXPECT_FALSE(merger.has(1));
    EXPECT_EQ(merger.summary().merged(), merged);
}

TEST(ResultMerger, AClaimedSizeCostsNothing) {
    ResultMerger merger(std::uint64_t{1} << 40);
    EXPECT_EQ(merger.add(make_result(3)), ResultMerger::Outcome::Added);
    EXPECT_FALSE(merger.has(std::uint64_t{1} << 39));
    EXPECT_FALSE(merger.digest());
}

TEST(ResultMerger, AJobWithoutScenariosHasADigest) {
    EXPECT_EQ(ResultMerger(0).digest(), sha256({}));
}

} // namespace cd::tests
