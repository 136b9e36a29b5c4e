// Proves, over all failures and their orders, that every scenario of an accepted job gets exactly
// one result. It is the right one; or, after the tolerated number of losses, the failure that says
// so; or that of a wrong worker that nothing could expose. Runs the real programs in simulated
// time; each seed is a cluster with its own faults. Also proves that the test detects defects: it
// switches on each of many mutations in turn, and one of the first seeds finds each.
#include "tests/faults/simulation.hpp"

#include <gtest/gtest.h>

#include <map>

namespace cd::tests {
namespace {

constexpr std::uint64_t shards = 5;
constexpr std::uint64_t seeds_of_shard = 400; // Workers found wrong are rare: 2 to 10 of every 200.

/// `workers` has the meaning of SimulationOptions::workers.
std::string replay(std::uint64_t seed, std::size_t workers = 0) {
    return "replay it with: build/test/tests/faults_test --seed " + std::to_string(seed) +
           " --log" + (workers == 0 ? "" : " --workers " + std::to_string(workers));
}

/// Each bound is well below what every hundred seeds have shown, so that no kind of fault goes
/// untested.
void expect_trouble(const Troubles& troubles) {
    constexpr std::uint64_t some = seeds_of_shard / 100;
    constexpr std::uint64_t many = seeds_of_shard / 8;
    const std::map<Trouble, std::uint64_t> least = {
        {Trouble::Doubled, many},        {Trouble::Overtaken, some},
        {Trouble::Delayed, many},        {Trouble::Lost, many},
        {Trouble::Unwelcomed, some},     {Trouble::Late, 0},
        {Trouble::WorkerCutOff, many},   {Trouble::WorkerStopped, many},
        {Trouble::WorkerSlowed, many},   {Trouble::WorkerDrained, many},
        {Trouble::WorkerKilled, many},   {Trouble::WorkerGone, many},
        {Trouble::WorkerPoisoned, many}, {Trouble::WorkerMute, some},
        {Trouble::WorkerDeaf, some},     {Trouble::WorkerApart, some},
        {Trouble::CacheShrunk, some},    {Trouble::MasterCutOff, some},
        {Trouble::MasterStopped, some},  {Trouble::MasterKilled, many},
        {Trouble::PowerCut, some},       {Trouble::UnsyncedLost, 0},
        {Trouble::DiskFull, many},       {Trouble::DiskUnreadable, some},
        {Trouble::BlocksLost, some},
    };
    EXPECT_EQ(least.size(), static_cast<std::size_t>(Trouble::count));
    for (const auto& [trouble, count] : least) {
        EXPECT_GT(troubles.of(trouble), count) << to_text(trouble);
    }
}

class Seeds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Seeds, EveryScenarioComesToExactlyOneResult) {
    Outcome sum;
    for (std::uint64_t seed = GetParam() * seeds_of_shard; seed < (GetParam() + 1) * seeds_of_shard;
         ++seed) {
        const Outcome outcome = simulate(seed);
        ASSERT_TRUE(outcome.problems.empty()) << outcome.problems.front() << "\n" << replay(seed);
        sum += outcome;
    }
    // The seeds produced enough trouble.
    EXPECT_GT(sum.masters, 3 * seeds_of_shard / 2);
    EXPECT_GT(sum.workers, 5 * seeds_of_shard);
    EXPECT_GT(sum.results_repeated, seeds_of_shard / 4);
    EXPECT_GT(sum.blocks_checked, seeds_of_shard);
    EXPECT_GT(sum.scenarios_sent, sum.scenarios * 3 / 4);
    EXPECT_GT(sum.failed, seeds_of_shard / 20);
    EXPECT_GT(sum.cancelled, seeds_of_shard / 200);
    EXPECT_GT(sum.recalled, seeds_of_shard / 5);
    EXPECT_GT(sum.copies, seeds_of_shard / 10);
    EXPECT_GT(sum.called_off, seeds_of_shard / 10);
    // Workers gave wrong results and were exposed; late messages did no harm.
    EXPECT_GT(sum.lies, seeds_of_shard);
    EXPECT_GT(sum.found_out, seeds_of_shard / 200);
    EXPECT_GT(sum.corrected, seeds_of_shard / 200);
    EXPECT_GT(sum.late_results, seeds_of_shard);
    EXPECT_GT(sum.old_sessions, seeds_of_shard / 2);
    expect_trouble(sum.troubles);
}

INSTANTIATE_TEST_SUITE_P(Faults, Seeds, testing::Range<std::uint64_t>(0, shards));

// Starts more workers than the master can greet at once, with a few scenarios each.
TEST(ManyWorkers, EveryScenarioComesToExactlyOneResult) {
    constexpr std::size_t workers = 1000;
    std::uint64_t answering = 0;
    for (const std::uint64_t seed : {4, 5}) { // Their jobs last until most workers are greeted.
        const Outcome outcome = simulate(seed, {false, Mutation::None, workers});
        ASSERT_TRUE(outcome.problems.empty()) << outcome.problems.front() << "\n"
                                              << replay(seed, workers);
        EXPECT_GE(outcome.workers, workers);
        EXPECT_GE(outcome.scenarios, 3 * workers);
        answering += outcome.answering;
    }
    EXPECT_GE(answering, workers) << "half of them all; some never get to anything";
}

TEST(Replay, ASeedIsTheSameEachTime) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Outcome first = simulate(seed);
        const Outcome second = simulate(seed);
        EXPECT_EQ(first.events, second.events) << replay(seed);
        EXPECT_EQ(first.seconds, second.seconds);
        EXPECT_EQ(first.scenarios_sent, second.scenarios_sent);
    }
}

struct KnownFault {
    Mutation mutation = Mutation::None;
    std::string name;
    std::string noticed_as; ///< Part of the expected problem text.

    friend void PrintTo(const KnownFault& fault, std::ostream* out) { *out << fault.name; }
};

class Faults : public testing::TestWithParam<KnownFault> {};

TEST_P(Faults, EveryMutationIsDetected) {
    constexpr std::uint64_t seeds_tried = seeds_of_shard; // Without a mutation, all of them pass.
    std::string noticed; // If another problem shows first, the next seeds are tried.
    const auto is_noticed = [&] {
        return noticed.find(GetParam().noticed_as) != std::string::npos;
    };
    for (std::uint64_t seed = 0; seed < seeds_tried && !is_noticed(); ++seed) {
        const Outcome outcome = simulate(seed, {false, GetParam().mutation, 0});
        if (!outcome.problems.empty()) {
            noticed = outcome.problems.front();
            RecordProperty("seed", std::to_string(seed));
        }
    }
    EXPECT_TRUE(is_noticed()) << "noticed: " << noticed;
}

const std::vector<KnownFault>& known_faults() {
    static const std::vector<KnownFault> faults = {
        {Mutation::LostLeaseForgotten, "LostLeaseForgotten", "unanswered(job.id) =="},
        {Mutation::DrainedWorkForgotten, "DrainedWorkForgotten", "unanswered(job.id) =="},
        {Mutation::LostRangeForgotten, "LostRangeForgotten", "in_ranges[index]"},
        {Mutation::AnswerLeftAtWorker, "AnswerLeftAtWorker", "known == placed"},
        {Mutation::RoomNotGivenBack, "RoomNotGivenBack", "unsent == not_sent"},
        {Mutation::PoisonToleratedTooLong, "PoisonToleratedTooLong", "losses.count() <"},
        {Mutation::PoisonGivenUpTooEarly, "PoisonGivenUpTooEarly", "went out 2 times"},
        {Mutation::SecondAnswerMerged, "SecondAnswerMerged", "!block.written"},
        {Mutation::AnswerKeptTooEarly, "AnswerKeptTooEarly", "acknowledged, and not on the disk"},
        {Mutation::JobAcceptedTooEarly, "JobAcceptedTooEarly", "accepted that is not on the disk"},
        {Mutation::EndToldTooEarly, "EndToldTooEarly", "hears of an end that is not on the disk"},
        {Mutation::SegmentNotSynced, "SegmentNotSynced", "the master does not start"},
        {Mutation::GroupNotRecovered, "GroupNotRecovered", "is merged twice"},
        {Mutation::DoneIsDoneAgain, "DoneIsDoneAgain", "is done again after a restart"},
        {Mutation::RecalledLeftAtWorker, "RecalledLeftAtWorker", "known == placed"},
        {Mutation::RecalledIsLost, "RecalledIsLost", "in_ranges[index]"},
        {Mutation::CopyLeftAtWorker, "CopyLeftAtWorker", "known == placed"},
        {Mutation::CopyIsAlone, "CopyIsAlone", "known == placed"},
        {Mutation::EvictionIgnored, "EvictionIgnored", "holds a block that is not there"},
        {Mutation::HeldWhenSent, "HeldWhenSent", "!peer.holds.contains(block)"},
        {Mutation::LiarKept, "LiarKept", "a wrong result of scenario"},
        {Mutation::OldEpochTaken, "OldEpochTaken", "a session of a former life of the master"},
        {Mutation::TooMuchInFlight, "TooMuchInFlight", "bytes of them are under way"},
        {Mutation::ReadsOn, "ReadsOn", "messages <="},
        {Mutation::EvictionNotTold, "EvictionNotTold", "holds a block that is not there"},
        {Mutation::HeardAgainForgotten, "HeardAgainForgotten", "no progress"},
        {Mutation::BatchesWithoutBound, "BatchesWithoutBound", "tasks <= std::max"},
        {Mutation::NobodyAwaited, "NobodyAwaited", "has said what it brings"},
        {Mutation::OthersSourceNamed, "OthersSourceNamed", "that it never said to hold"},
        {Mutation::IndexTakenForPosition, "IndexTakenForPosition", "merged.has(analysis"},
        {Mutation::SplitRunLosesEnd, "SplitRunLosesEnd", "task_had_positions"},
    };
    return faults;
}

TEST(KnownFaults, AreAllThereAre) {
    EXPECT_EQ(known_faults().size() + 1, static_cast<std::size_t>(Mutation::count));
}

INSTANTIATE_TEST_SUITE_P(Known, Faults, testing::ValuesIn(known_faults()), [](const auto& fault) {
    return fault.param.name;
});

} // namespace
} // namespace cd::tests
