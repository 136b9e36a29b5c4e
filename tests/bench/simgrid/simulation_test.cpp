// Proves that a job simulated under SimGrid is answered completely, takes at least as long as its
// bounds, and is reproducible.
#include "bench/cluster/model/simulation.hpp"

#include "bench/cluster/model/strategies.hpp"
#include "tests/bench/cluster/synthetic.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace cd::tests {
namespace {

using namespace cd::bench;

constexpr std::chrono::seconds limit{30};

SimulationOptions small_cluster() {
    SimulationOptions options;
    options.cluster.fast_cores = 6;
    options.cluster.slow_cores = 4;
    options.dispatch.q = 5;
    return options;
}

TEST(ClusterSimulation, IsWholeWithinItsBoundsAndTheSameEachTime) {
    const Workload workload = make_synthetic_workload(3, 400);
    for (const ComparedStrategy& compared : compared_strategies) {
        for (const bool is_product : {false, true}) {
            SCOPED_TRACE(testing::Message() << compared.name() << " " << is_product);
            SimulationOptions options = small_cluster();
            options.dispatch.strategy = compared.strategy;
            options.dispatch.claim = !is_product;
            options.cluster.worker_per_computer = is_product;
            options.analysts = is_product ? 2 : 0;
            options.ahead = is_product || compared.sees_queue ? 0 : 1;
            options.peers = compared.peers;
            const auto first = simulate_apart(workload, options, limit);
            const auto second = simulate_apart(workload, options, limit);
            ASSERT_TRUE(first && second);

            EXPECT_EQ(first->answered, workload.count());
            EXPECT_EQ(first->answered_again, 0u);
            EXPECT_EQ(first->blocks_received == first->blocks, !compared.peers);
            EXPECT_EQ(first->peer_bytes != 0, compared.peers);
            EXPECT_GT(first->sent_bytes, first->block_bytes);
            // Some scenarios run twice at the end.
            EXPECT_GT(first->work_seconds, workload.serial_seconds - 1e-9);
            EXPECT_LT(first->work_seconds, 1.06 * workload.serial_seconds);
            const double bound = options.cluster.weighted_cores(workload.slow_ratio);
            EXPECT_GT(first->seconds, workload.serial_seconds / bound);
            EXPECT_LT(first->seconds, workload.serial_seconds);
            EXPECT_EQ(first->seconds, second->seconds);
            EXPECT_EQ(first->sent_bytes, second->sent_bytes);
            EXPECT_GT(first->received_bytes, 900 * workload.count()); // Bytes of the records.
            EXPECT_EQ(first->received_bytes, second->received_bytes);
            EXPECT_EQ(first->master_seconds, second->master_seconds);
        }
    }
}

TEST(ClusterSimulation, ClientsThatChooseByLikenessGetFewerBytes) {
    const Workload workload = make_synthetic_workload(5, 300);
    SimulationOptions options = small_cluster();
    options.dispatch.claim = true;
    options.variation = Variation::ClientFirst;
    std::map<std::string, std::uint64_t> bytes;
    for (const std::string strategy : {"best-match", "random", "lowest"}) {
        options.dispatch.strategy = strategy;
        const auto outcome = simulate_apart(workload, options, limit);
        ASSERT_TRUE(outcome) << strategy;
        EXPECT_EQ(outcome->answered, workload.count());
        bytes[strategy] = outcome->block_bytes;
    }
    EXPECT_LT(bytes["best-match"], bytes["random"]);
    EXPECT_LE(bytes["random"], bytes["lowest"]);
}

TEST(ClusterSimulation, MatchingWithoutEyesForBlocksSendsMore) {
    const Workload workload = make_synthetic_workload(6, 300);
    SimulationOptions options = small_cluster();
    options.ahead = 0;
    options.cluster.bytes_per_second = 1e6;
    options.dispatch.strategy = "earliest-finish";
    const auto seeing = simulate_apart(workload, options, limit);
    options.variation = Variation::Blind;
    const auto blind = simulate_apart(workload, options, limit);
    ASSERT_TRUE(seeing && blind);
    EXPECT_EQ(blind->answered, workload.count());
    EXPECT_LT(seeing->block_bytes, blind->block_bytes);
}

TEST(ClusterSimulation, ASlowWireAndASlowPipeTakeTheirTime) {
    const Workload workload = make_synthetic_workload(4, 100);
    const SimulationOptions usual = small_cluster();
    SimulationOptions wire = usual;
    wire.cluster.bytes_per_second = 1e6;
    SimulationOptions pipe = usual;
    pipe.pipe_bytes_per_second = 1e6;
    const auto at_once = simulate_apart(workload, usual, limit);
    const auto by_wire = simulate_apart(workload, wire, limit);
    const auto by_pipe = simulate_apart(workload, pipe, limit);
    ASSERT_TRUE(at_once && by_wire && by_pipe);
    EXPECT_GT(by_wire->seconds, static_cast<double>(by_wire->sent_bytes) / 1e6);
    EXPECT_GT(by_pipe->seconds, static_cast<double>(by_pipe->sent_bytes) / 1e6);
    EXPECT_LT(at_once->seconds, by_pipe->seconds);
    EXPECT_LT(at_once->seconds, by_wire->seconds);
}

} // namespace
} // namespace cd::tests
