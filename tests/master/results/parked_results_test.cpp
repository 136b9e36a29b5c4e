// Proves that results that wait are kept once, by job and worker, and hold up their worker only
// when they exceed the memory set aside for them.
#include "master/results/parked_results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint64_t record_bytes = 1000;
constexpr std::uint64_t message_bytes = sizeof(Results) + record_bytes;

class ParkedResultsTest : public testing::Test {
  protected:
    IncomingResults message(std::uint64_t sequence, JobId job = {1}, WorkerId worker = {1}) {
        auto results = std::make_shared<Results>();
        results->job = job;
        results->sequence = sequence;
        results->records.resize(record_bytes);
        return {std::make_shared<const Author>(Author{worker.value, worker, "w", ""}),
                std::move(results),
                [this, sequence] { done_.push_back(sequence); }};
    }
    [[nodiscard]] std::vector<std::uint64_t> take(JobId job) {
        std::vector<std::uint64_t> sequences;
        for (IncomingResults& one : parked_.take(job)) {
            sequences.push_back(one.message->sequence);
            one.done();
        }
        return sequences;
    }

    std::vector<std::uint64_t> done_; ///< Messages whose workers may go on.
    ParkedResults parked_{2 * message_bytes};
};

TEST_F(ParkedResultsTest, AWorkerGoesOnWhileThereIsMemory) {
    for (const std::uint64_t sequence : {1, 2, 3}) {
        parked_.park(message(sequence));
    }
    EXPECT_THAT(done_, ElementsAre(1, 2));
    EXPECT_THAT(take(JobId{1}), ElementsAre(1, 2, 3));
    EXPECT_THAT(done_, ElementsAre(1, 2, 3)) << "each worker goes on once";
    parked_.park(message(4));
    EXPECT_THAT(done_, ElementsAre(1, 2, 3, 4)) << "the memory is free again";
}

TEST_F(ParkedResultsTest, ACopyOfAParkedMessageIsDropped) {
    for (const std::uint64_t sequence : {1, 2, 3, 3}) {
        parked_.park(message(sequence));
    }
    EXPECT_THAT(done_, ElementsAre(1, 2, 3)) << "the copy holds up nobody";
    EXPECT_THAT(take(JobId{1}), ElementsAre(1, 2, 3));
}

TEST_F(ParkedResultsTest, MessagesAreTakenByJob) {
    parked_.park(message(1, JobId{1}));
    parked_.park(message(2, JobId{2}));
    EXPECT_TRUE(parked_.has_any(JobId{1}));
    EXPECT_FALSE(parked_.has_any(JobId{3}));
    EXPECT_THAT(take(JobId{1}), ElementsAre(1));
    EXPECT_FALSE(parked_.has_any(JobId{1}));
    EXPECT_THAT(take(JobId{2}), ElementsAre(2));
}

TEST_F(ParkedResultsTest, MessagesOfAWorkerThatHasLeftAreForgotten) {
    parked_.park(message(1, JobId{1}, WorkerId{1}));
    parked_.park(message(1, JobId{1}, WorkerId{2}));
    parked_.park(message(2, JobId{2}, WorkerId{1}));
    parked_.forget(WorkerId{1});
    EXPECT_FALSE(parked_.has_any(JobId{2}));
    EXPECT_EQ(parked_.take(JobId{1}).at(0).author->worker, WorkerId{2});
    done_.clear();
    parked_.park(message(3));
    parked_.park(message(4));
    EXPECT_THAT(done_, ElementsAre(3, 4)) << "their memory is free again";
}

TEST_F(ParkedResultsTest, AMessageThatTheCallerKeepsCountsToo) {
    IncomingResults kept = message(1);
    parked_.count(kept);
    EXPECT_THAT(done_, ElementsAre(1));
    parked_.park(message(2));
    parked_.park(message(3));
    EXPECT_THAT(done_, ElementsAre(1, 2));
    EXPECT_THAT(take(JobId{1}), ElementsAre(2, 3));
    parked_.uncount(kept);
    done_.clear();
    kept.done();
    EXPECT_THAT(done_, IsEmpty()) << "the worker goes on already";
}

} // namespace
} // namespace cd::tests
