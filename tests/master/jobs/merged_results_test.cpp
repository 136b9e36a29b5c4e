// Proves that withdrawing the results of a process leaves the merge as if they had never come.
#include "master/jobs/merged_results.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cd::tests {
namespace {

using Outcome = MergedResults::Outcome;

std::shared_ptr<const Author> author(InstanceId process) {
    return std::make_shared<const Author>(Author{process, WorkerId{process}, "w", ""});
}

Sha256 digest(std::uint64_t number) {
    Sha256 digest;
    digest.bytes[0] = static_cast<std::byte>(number);
    return digest;
}

ScenarioFacts facts(std::uint64_t number) {
    return {static_cast<ScenarioClass>(number % 8),
            number % 2 == 0,
            number % 3 == 0,
            number % 5 == 0,
            number % 7 == 0,
            number << 40,
            number % 4 == 1 ? number << 44 : 0};
}

void expect_equal(const Summary& one, const Summary& other) {
    EXPECT_EQ(one.merged(), other.merged());
    EXPECT_EQ(one.failed, other.failed);
    EXPECT_EQ(one.separate, other.separate);
    EXPECT_EQ(one.near, other.near);
    EXPECT_EQ(one.pairs, other.pairs);
    EXPECT_EQ(one.near_pairs, other.near_pairs);
    EXPECT_EQ(one.surfaces_only, other.surfaces_only);
    EXPECT_EQ(one.insides_skipped, other.insides_skipped);
    EXPECT_EQ(one.cut, other.cut);
}

TEST(MergedResults, WithoutAWithdrawnProcessAreThoseOfTheOthers) {
    std::mt19937 random(7);
    MergedResults all(500);
    MergedResults honest(500);
    const auto liar_before = author(1);
    const auto liar_again = author(1); // Another session of the process.
    const auto other = author(2);
    std::vector<std::uint64_t> lies;
    for (std::uint64_t scenario = 0; scenario < 400; ++scenario) {
        const unsigned kind = random() % 4;
        const auto by = kind == 0   ? liar_before
                        : kind == 1 ? liar_again
                        : kind == 2 ? other
                                    : nullptr;
        EXPECT_EQ(all.add(scenario, facts(scenario), digest(scenario), by), Outcome::Added);
        if (kind < 2) {
            lies.push_back(scenario);
        } else {
            (void)honest.add(scenario, facts(scenario), digest(scenario), by);
        }
    }
    EXPECT_EQ(all.processes(), (std::set<InstanceId>{1, 2}));
    EXPECT_EQ(all.withdraw(1), lies);
    EXPECT_TRUE(all.withdraw(1).empty());
    expect_equal(all.summary(), honest.summary());
    EXPECT_EQ(all.processes(), std::set<InstanceId>{2});
    for (std::uint64_t scenario = 0; scenario < 500; ++scenario) {
        EXPECT_EQ(all.has(scenario), honest.has(scenario));
        EXPECT_EQ(all.author_of(scenario), honest.author_of(scenario));
    }
    EXPECT_EQ(*all.marks(), *honest.marks());
    EXPECT_EQ(all.add(lies[0], facts(1), digest(1), other), Outcome::Added);
    EXPECT_EQ(all.author_of(lies[0]), other);
}

TEST(MergedResults, AFailureOfTheMasterIsToldFromAWorkers) {
    const ScenarioFacts failed{ScenarioClass::Failed, false, false, false, false, 0};
    MergedResults results(3);
    (void)results.add(0, failed, digest(0), nullptr);
    (void)results.add(1, failed, digest(1), author(1));
    EXPECT_TRUE(results.is_failed_by_master(0));
    EXPECT_FALSE(results.is_failed_by_master(1));
    EXPECT_FALSE(results.is_failed_by_master(2));
}

TEST(MergedResults, RestoredResultsCanBeWithdrawn) {
    ResultMerger merged(3);
    (void)merged.add(1, facts(1), digest(1));
    MergedResults results(std::move(merged));
    results.restore(1, facts(1), author(5));
    EXPECT_EQ(results.withdraw(5), std::vector<std::uint64_t>{1});
    Summary none;
    none.total = 3;
    expect_equal(results.summary(), none);
    EXPECT_EQ(results.marks(), nullptr);
}

TEST(MergedResults, KnowTheirAuthorsAfterTheEnd) {
    MergedResults results(2);
    (void)results.add(0, facts(0), digest(0), author(1));
    (void)results.add(1, facts(1), digest(1), nullptr);
    EXPECT_TRUE(results.digest());
    results.close();
    EXPECT_EQ(results.author_of(0)->process, 1u);
    EXPECT_EQ(results.author_of(1), nullptr);
    EXPECT_TRUE(results.has(1));
}

} // namespace
} // namespace cd::tests
