// Proves that the ledger lets an entry be acknowledged once all of it is on disk, and never before:
// on long random histories it agrees with a slow reference that keeps every entry and scans all of
// them.
#include "master/journal/ledger.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <tuple>

namespace cd::tests {
namespace {

constexpr JobId job_a{1};
constexpr JobId job_b{2};

TEST(Ledger, AJobIsAcceptedOnceItsEntryIsCommitted) {
    Ledger ledger;
    ledger.promise(JobAccepted{job_a}, 3);
    ledger.committed(2);
    EXPECT_TRUE(ledger.take_kept().empty());
    ledger.committed(3);
    EXPECT_EQ(ledger.take_kept(), (std::vector<Promise>{JobAccepted{job_a}}));
    EXPECT_TRUE(ledger.take_kept().empty());
}

TEST(Ledger, ResultsAreKeptOnceAllOfThemAreDurable) {
    Ledger ledger;
    ledger.open_job(job_a);
    ledger.write(job_a, 7, 1);
    ledger.write(job_a, 5000, 2);
    const Delivery delivery{WorkerId{1}, 1};
    ledger.promise(delivery, job_a, std::vector<std::uint64_t>{7, 5000});
    ledger.committed(1);
    EXPECT_EQ(ledger.state(job_a, 7), Ledger::State::Durable);
    EXPECT_EQ(ledger.state(job_a, 5000), Ledger::State::Written);
    EXPECT_EQ(ledger.state(job_a, 6), Ledger::State::Unknown);
    EXPECT_TRUE(ledger.take_kept().empty());
    ledger.committed(2);
    EXPECT_EQ(ledger.take_kept(), (std::vector<Promise>{delivery}));
    EXPECT_EQ(ledger.durable(job_a), 2u);
}

TEST(Ledger, DurableEntriesAreAcknowledgedAtOnce) {
    Ledger ledger;
    ledger.open_job(job_a);
    ledger.restore(job_a, 3);
    const Delivery again{WorkerId{1}, 4};
    ledger.promise(again, job_a, std::vector<std::uint64_t>{3});
    EXPECT_EQ(ledger.take_kept(), (std::vector<Promise>{again}));
}

TEST(Ledger, NoPromiseWaitsForAClosedJob) {
    Ledger ledger;
    ledger.open_job(job_a);
    ledger.write(job_a, 3, 1);
    ledger.close_job(job_a);
    const Delivery late{WorkerId{1}, 4};
    ledger.promise(late, job_a, std::vector<std::uint64_t>{3});
    EXPECT_EQ(ledger.take_kept(), (std::vector<Promise>{late}));
    ledger.committed(1);
    ledger.check_invariants();
}

TEST(Ledger, AWorkerThatHasLeftGetsNoAcknowledgement) {
    Ledger ledger;
    ledger.promise(Delivery{WorkerId{1}, 1}, 1);
    ledger.promise(Delivery{WorkerId{2}, 1}, 1);
    ledger.forget(WorkerId{1});
    ledger.committed(1);
    EXPECT_EQ(ledger.take_kept(), (std::vector<Promise>{Delivery{WorkerId{2}, 1}}));
    EXPECT_EQ(ledger.owed(), 0u);
}

/// Keeps every entry.
struct Twin {
    std::map<std::pair<JobId, std::uint64_t>, std::uint64_t> written; ///< Position of each result.
    std::map<Delivery, std::vector<std::pair<JobId, std::uint64_t>>> owed;
    std::set<JobId> open;
    std::uint64_t committed = 0;

    [[nodiscard]] bool may_be_kept(const Delivery& delivery) const {
        for (const auto& each : owed.at(delivery)) {
            const auto found = written.find(each);
            if (open.contains(each.first) && found != written.end() && found->second > committed) {
                return false;
            }
        }
        return true;
    }
};

TEST(Ledger, AgreesWithATwinOnRandomHistories) {
    std::uint64_t waited = 0;
    for (SeededRandom random : seeds(60)) {
        Ledger ledger;
        Twin twin;
        for (const JobId job : {job_a, job_b}) {
            ledger.open_job(job);
            twin.open.insert(job);
        }
        std::uint64_t position = 0;
        for (std::uint64_t sequence = 1; sequence < 300; ++sequence) {
            const JobId job = random() % 2 == 0 ? job_a : job_b;
            std::vector<std::uint64_t> scenarios;
            std::vector<std::pair<JobId, std::uint64_t>> keys;
            const bool writes = twin.open.contains(job);
            position += writes ? 1 : 0;
            for (std::uint64_t i = random() % 8; i != 0; --i) {
                const std::uint64_t scenario = random() % 9000;
                scenarios.push_back(scenario);
                keys.emplace_back(job, scenario);
                if (writes && !twin.written.contains(keys.back())) {
                    ledger.write(job, scenario, position);
                    twin.written[keys.back()] = position;
                }
            }
            const Delivery delivery{WorkerId{random() % 3}, sequence};
            twin.owed[delivery] = keys;
            waited += twin.may_be_kept(delivery) ? 0 : 1;
            ledger.promise(delivery, job, scenarios);
            if (random() % 3 == 0) {
                twin.committed += random() % (position - twin.committed + 1);
                ledger.committed(twin.committed);
            }
            if (random() % 200 == 0) {
                ledger.close_job(job);
                twin.open.erase(job);
            }
            ledger.check_invariants();
            for (const Promise& kept : ledger.take_kept()) {
                const Delivery& each = std::get<Delivery>(kept);
                ASSERT_TRUE(twin.may_be_kept(each));
                ASSERT_EQ(twin.owed.erase(each), 1u) << "kept twice";
            }
        }
        ledger.committed(position);
        EXPECT_EQ(ledger.take_kept().size(), twin.owed.size()) << "owed for ever";
    }
    EXPECT_GT(waited, 1000u);
}

} // namespace
} // namespace cd::tests
