// Proves that quarantine applies to the certificate's holder, and not to another holder with a
// process of equal number: neither a new number nor a restart of the master ends it.
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

namespace cd::tests {
namespace {

constexpr FailureTimes no_return{.return_within = std::chrono::milliseconds(0)};
constexpr Stage secured{.is_secured = true};

std::optional<WorkerStatus> alive_at(Master& master) {
    const auto workers = master.coordinator.cluster_status().workers;
    const auto here = std::ranges::find(workers, WorkerState::Alive, &WorkerStatus::state);
    return here == workers.end() ? std::nullopt : std::optional(*here);
}

/// Joins and leaves; returns whether the worker was in quarantine.
bool joins_in_quarantine(Master& master, const std::string& holder, std::uint64_t instance) {
    std::optional<WorkerStatus> found;
    {
        const FakeWorker worker(master, {.instance = instance, .holder = holder});
        master.run_until([&] { return (found = alive_at(master)).has_value(); });
    }
    master.run_until([&] { return !alive_at(master); });
    return found && found->quarantined;
}

TEST(ServerHolder, QuarantineFollowsTheCertificateToANewProcess) {
    const TemporaryFolder state;
    {
        Master master(no_return, state.path(), secured);
        Client client(master);
        client.start_submitting(reference().submission());
        master.run_until([&] { return client.done; });
        {
            const FakeWorker liar(master, {.lies_first = true, .instance = 1, .holder = "liar"});
            master.run_until([&] { return !master.coordinator.quarantined().empty(); });
        }
        master.run_until([&] { return !alive_at(master); });
        const std::uint64_t merged =
            master.coordinator.job_status(*client.job).value().summary.merged();
        EXPECT_TRUE(joins_in_quarantine(master, "liar", 1));
        EXPECT_TRUE(joins_in_quarantine(master, "liar", 2));
        {
            // Results of a quarantined worker are rejected, even right ones.
            Results results = right_results(*client.job, 89);
            results.sequence = 1;
            const FakeWorker again(master,
                                   {.instance = 6, .comes_with = {results}, .holder = "liar"});
            master.run_until([&] { return again.kept == 1; });
            EXPECT_EQ(master.coordinator.job_status(*client.job).value().summary.merged(), merged);
        }
        master.run_until([&] { return !alive_at(master); });
        EXPECT_FALSE(joins_in_quarantine(master, "honest", 3));
        EXPECT_FALSE(joins_in_quarantine(master, "honest", 1)) << "the same number by chance";
        const auto alarms = master.coordinator.cluster_status().alarms;
        ASSERT_FALSE(alarms.empty());
        EXPECT_NE(alarms.front().find("certified as liar"), std::string::npos) << alarms.front();
    }
    Master master(no_return, state.path(), secured);
    EXPECT_TRUE(joins_in_quarantine(master, "liar", 4));
    EXPECT_FALSE(joins_in_quarantine(master, "honest", 5));
}

TEST(ServerHolder, AnotherHolderWithTheSameNumberEndsNobodysSession) {
    Master master(no_return, {}, secured);
    const FakeWorker first(master, {.instance = 7, .holder = "first"});
    master.run_until([&] { return alive_at(master).has_value(); });
    const FakeWorker second(master, {.instance = 7, .holder = "second"});
    const auto here = [&] {
        const auto workers = master.coordinator.cluster_status().workers;
        return std::ranges::count(workers, WorkerState::Alive, &WorkerStatus::state);
    };
    master.run_until([&] { return first.ended || here() == 2; });
    EXPECT_FALSE(first.ended);
    EXPECT_EQ(here(), 2);
    const FakeWorker again(master, {.instance = 7, .holder = "first"});
    master.run_until([&] { return first.ended; });
    EXPECT_FALSE(second.ended);
}

} // namespace
} // namespace cd::tests
