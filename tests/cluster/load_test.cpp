// Proves that a worker on a heavily overloaded host is not declared lost: computing does not delay
// its heartbeats.
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"

namespace cd::tests {
namespace {

class FullLoad : public MortalCluster {
  protected:
    FullLoad() : MortalCluster({"--heartbeat", "0.2", "--lost-after", "4"}) {}
};

TEST_F(FullLoad, AnOverloadedWorkerIsNotDeclaredLost) {
    constexpr unsigned threads = 48;
    start_worker(threads, {"--drain-timeout", "0"});
    const auto connection = connect();
    Query query;
    query.level = Level::Count;
    ClusterOptions one_block;
    one_block.depths = {0, 0};
    const JobId id = submit(*connection, make_long_job(threads, 0), query, one_block);
    // A heartbeat tells of a scenario that has run for longer than it takes to be declared lost.
    Result<ClusterStatus> status{ClusterStatus{}};
    ASSERT_TRUE(comes_true([&] {
        status = connection->status();
        return status && !status.value().workers.empty() && status.value().workers[0].longest &&
               status.value().workers[0].longest->seconds > 6;
    })) << master_.log();
    EXPECT_EQ(status.value().losses.workers_lost, 0u) << master_.log();
    ASSERT_TRUE(connection->cancel(id));
    EXPECT_EQ(finish(*connection, id).state, JobState::Cancelled);
}

} // namespace
} // namespace cd::tests
