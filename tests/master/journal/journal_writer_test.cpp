// Proves that nothing is announced before the journal has it.
#include "master/journal/journal_writer.hpp"

#include "proto/channel/asio.hpp"
#include "tests/master/journal_writer.hpp"
#include "tests/master/master_stage.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

/// A journal with one accepted job, and a writer that notes what it announces.
class JournalWriterTest : public testing::Test {
  protected:
    JournalWriterTest()
        : journal_(std::move(Journal::open({.directory = folder_.path()}).value())) {
        writer_.start({[this](WorkerId worker, const ResultsKept& kept) {
                           EXPECT_EQ(worker, WorkerId{5});
                           kept_.insert(kept_.end(), kept.sequences.begin(), kept.sequences.end());
                       },
                       [this](JobId) { events_ += "recorded "; },
                       [this](JobId) { events_ += "ended "; },
                       [this](JobId) { events_ += "dropped "; },
                       [this](const Dispute&) { events_ += "disputed "; },
                       [] {},
                       [] {}});
        writer_.write(AcceptJob{job_record(JobId{1}, 100)});
        store_ = ResultStore::create(journal_->results_path(JobId{1}), JobId{1}, 100);
        run_until([this] { return events_ == "recorded "; });
        events_.clear();
    }
    // The journal stops before the context's end; the writer is gone by then.
    ~JournalWriterTest() override { journal_.reset(); }

    template <class Condition>
    void run_until(const Condition& condition) {
        context_.restart();
        const auto work = asio::make_work_guard(context_);
        tests::run_until(context_, condition);
    }

    const TemporaryFolder folder_;
    asio::io_context context_;
    std::unique_ptr<Journal> journal_;
    JournalWriter writer_{
        [this](std::function<void()> run) { asio::post(context_, std::move(run)); }, *journal_};
    std::shared_ptr<ResultStore> store_;
    std::vector<std::uint64_t> kept_;
    std::string events_;
};

TEST_F(JournalWriterTest, ResultsAreAcknowledgedWhenTheyAreDurable) {
    writer_.write(results_of(JobId{1}, store_, 0, 10));
    writer_.promise(Delivery{WorkerId{5}, 7}, JobId{1}, std::vector<std::uint64_t>{3, 4});
    writer_.announce();
    EXPECT_TRUE(kept_.empty());
    run_until([this] { return !kept_.empty(); });
    EXPECT_EQ(kept_, std::vector<std::uint64_t>{7});
    EXPECT_TRUE(store_->has(3));
    // A repetition is durable already.
    writer_.promise(Delivery{WorkerId{5}, 8}, JobId{1}, std::vector<std::uint64_t>{3});
    writer_.announce();
    EXPECT_EQ(kept_, (std::vector<std::uint64_t>{7, 8}));
}

TEST_F(JournalWriterTest, WithdrawnResultsMayBeWrittenAgain) {
    writer_.write(results_of(JobId{1}, store_, 0, 3));
    AddResults withdrawal{JobId{1}, store_, {}, {}, {}};
    withdrawal.withdrawn = {0, 1};
    writer_.write(std::move(withdrawal));
    writer_.check_invariants();
    writer_.write(results_of(JobId{1}, store_, 1, 1));
    writer_.check_invariants();
    writer_.promise(Delivery{WorkerId{5}, 1}, JobId{1}, std::vector<std::uint64_t>{1});
    run_until([this] { return !kept_.empty(); });
    EXPECT_FALSE(store_->has(0));
    EXPECT_TRUE(store_->has(1));
    EXPECT_TRUE(store_->has(2));
}

TEST_F(JournalWriterTest, EndsDropsAndDisputesAreAnnouncedInTheirOrder) {
    writer_.write(results_of(JobId{1}, store_, 0, 1));
    writer_.promise(Dispute{JobId{1}, 0, nullptr, {}});
    writer_.write(EndJob{JobId{1}, {JobState::Cancelled, "cancelled", {}}, {}});
    writer_.write(DropJob{JobId{1}});
    EXPECT_EQ(events_, "");
    run_until([this] { return events_ == "disputed ended dropped "; });
}

TEST_F(JournalWriterTest, AChangedJobIsAnnouncedWhenItIsDurable) {
    JobRecord job = job_record(JobId{1}, 100);
    job.submit.priority = 4;
    const std::uint64_t position = writer_.write(ChangeJob{job});
    EXPECT_FALSE(writer_.is_durable(position));
    run_until([this] { return events_ == "recorded "; });
    EXPECT_TRUE(writer_.is_durable(position));
    EXPECT_EQ(journal_->job(JobId{1}).value().submit.priority, 4);
}

TEST_F(JournalWriterTest, AForgottenWorkerIsToldNothing) {
    writer_.write(results_of(JobId{1}, store_, 0, 1));
    writer_.promise(Delivery{WorkerId{5}, 7}, JobId{1}, std::vector<std::uint64_t>{0});
    writer_.forget(WorkerId{5});
    writer_.write(EndJob{JobId{1}, {JobState::Cancelled, "cancelled", {}}, {}});
    run_until([this] { return events_ == "ended "; });
    EXPECT_TRUE(kept_.empty());
}

} // namespace
} // namespace cd::tests
