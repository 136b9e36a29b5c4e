// One job on a simulated cluster: the real coordinator on SimGrid's hosts and network.
#pragma once

#include "bench/cluster/model/policies.hpp"
#include "bench/cluster/model/workload.hpp"
#include "proto/messages/cluster_options.hpp"

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

namespace cd::bench {

/// The paper's section 7: five computers of four fast cores and four of two slow ones, of which the
/// first cores take part. Every computer has one link to a switch. The master has its own fast
/// computer: the paper's bound of 25 times one fast core counts all 28 cores for work.
struct ClusterSpec {
    std::uint32_t fast_cores = 20;
    std::uint32_t slow_cores = 8;
    std::uint32_t fast_cores_each = 4; ///< Fast cores of each fast computer.
    std::uint32_t slow_cores_each = 2;
    bool worker_per_computer = false; ///< One worker per computer; else one per core.
    /// Above 0: one computer of so many fast cores, shared by the master and `fast_cores` workers
    /// of one thread each; messages cost nothing.
    std::uint32_t shared_cores = 0;
    double bytes_per_second = 125e6; ///< 1 Gb/s in each direction.
    double latency_seconds = 50e-6;  ///< Latency of one link; a message passes two.

    [[nodiscard]] std::uint32_t cores() const { return fast_cores + slow_cores; }
    /// The paper's bound: n1 + n2 t1 / t2.
    [[nodiscard]] double weighted_cores(double slow_ratio) const {
        return fast_cores + slow_cores / slow_ratio;
    }
    /// The paper's weighted serial time (7.1) relative to that of a fast core.
    [[nodiscard]] double weighted_ratio(double slow_ratio) const {
        return (fast_cores + slow_cores * slow_ratio) / cores();
    }
};

struct SimulationOptions {
    ClusterSpec cluster;
    ClusterOptions dispatch;                      ///< The workload gives its depths.
    AnalysisMode analysis = AnalysisMode::Always; ///< Whatever `dispatch` says.
    /// With ClientFirst, as in the paper's section 5.1, all scenarios are analysed before workers
    /// join, and a worker requests the blocks of a scenario when its turn comes.
    Variation variation = Variation::None;
    /// Analysed scenarios that may wait outside buffers; 0: the product's number.
    std::uint64_t ahead = 1;
    bool peers = false; ///< Workers send each other blocks.
    bool helps_at_end = true;
    /// Cores of the master's computer that analyse; 0: the master's one thread analyses.
    std::uint32_t analysts = 0;
    /// Time of the master's thread for each analysed scenario.
    double dispatch_seconds = 0;
    /// Above 0: the master's thread sends everything through a pipe of this rate.
    double pipe_bytes_per_second = 0;
    /// Longest time for which a worker keeps results before their task ends.
    double results_period = std::numeric_limits<double>::infinity();
};

struct Outcome {
    double seconds = 0; ///< From the first analysis to the arrival of the last result.
    std::uint64_t answered = 0;
    std::uint64_t answered_again = 0;
    std::uint64_t recalled = 0;
    std::uint64_t copies = 0;
    std::uint64_t batches = 0;
    std::uint64_t wants = 0;
    std::uint64_t blocks = 0;
    std::uint64_t block_bytes = 0;
    std::uint64_t sent_bytes = 0;     ///< Bytes sent by the master.
    std::uint64_t received_bytes = 0; ///< Bytes received by the master.
    std::uint64_t peer_bytes = 0;     ///< Block bytes sent from worker to worker.
    std::uint64_t blocks_received = 0;
    std::uint64_t memory_bytes_max = 0; ///< Final, so peak, memory of the worker with the most.
    std::uint64_t memory_bytes_sum = 0; ///< Final memory of all workers.
    double master_seconds = 0;          ///< Busy time of the master's thread.
    double work_seconds = 0;            ///< Time of all workers with scenarios, in fast cores.
    double coordinator_us = 0;          ///< Real time of the coordinator per scenario.
    // Idle shares of the time of all cores:
    double start_share = 0;   ///< Before a core's first scenario.
    double between_share = 0; ///< Between two scenarios.
    double tail_share = 0;    ///< After a core's last scenario.
};

/// Runs in this process, which can do it only once. Deterministic, except for the coordinator's
/// real time.
[[nodiscard]] Outcome simulate(const Workload& workload, const SimulationOptions& options);

/// Runs in a child process; only for a process with one thread. Returns nothing if the child
/// crashes or exceeds the limit.
[[nodiscard]] std::optional<Outcome> simulate_apart(const Workload& workload,
                                                    const SimulationOptions& options,
                                                    std::chrono::seconds limit);

} // namespace cd::bench
