// One job on a simulated cluster: the real dispatcher, on hosts and a network of SimGrid's.
#pragma once

#include "bench/cluster/model/workload.hpp"
#include "proto/messages/cluster_options.hpp"

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>

namespace cd::bench {

/// The paper's section 7: five computers of four fast cores and four of two slow ones, of which the
/// first so many cores take part. Every computer has one link to a switch. The master has a fast
/// computer for itself: a bound of 25 times one fast core counts all 28 for work.
struct ClusterSpec {
    std::uint32_t fast_cores = 20;
    std::uint32_t slow_cores = 8;
    std::uint32_t fast_cores_each = 4; ///< Of a computer.
    std::uint32_t slow_cores_each = 2;
    bool worker_per_computer = false; ///< With a thread for each core; else a worker for each core.
    /// Above 0: one computer of so many fast cores for the master and `fast_cores` workers of one
    /// thread, which share it; messages cost nothing.
    std::uint32_t shared_cores = 0;
    double bytes_per_second = 125e6; ///< 1 Gb/s in each direction.
    double latency_seconds = 50e-6;  ///< Of a link; a message passes two.

    [[nodiscard]] std::uint32_t cores() const { return fast_cores + slow_cores; }
    /// The paper's bound: n1 + n2 t1 / t2.
    [[nodiscard]] double weighted_cores(double slow_ratio) const {
        return fast_cores + slow_cores / slow_ratio;
    }
};

struct SimulationOptions {
    ClusterSpec cluster;
    ClusterOptions dispatch; ///< Its depths are the workload's.
    /// Analysed scenarios that may wait for a worker beside those in buffers; 0: as the product.
    std::uint64_t ahead = 1;
    bool peers = false; ///< Workers give each other blocks.
    bool helps_at_end = true;
    /// Cores of the master's computer that analyse; 0: the master's one thread does.
    std::uint32_t analysts = 0;
    /// For each scenario, of the master's thread: the dispatcher's decisions.
    double dispatch_seconds = 0;
    /// Above 0, the master's thread passes all that it sends through a pipe of this rate.
    double pipe_bytes_per_second = 0;
    /// A worker keeps results until their task ends, or so long.
    double results_period = std::numeric_limits<double>::infinity();
};

struct Outcome {
    double seconds = 0; ///< From the first analysis to the last result's coming.
    std::uint64_t answered = 0;
    std::uint64_t answered_again = 0;
    std::uint64_t recalled = 0;
    std::uint64_t copies = 0;
    std::uint64_t batches = 0;
    std::uint64_t wants = 0;
    std::uint64_t blocks = 0;
    std::uint64_t block_bytes = 0;
    std::uint64_t sent_bytes = 0;     ///< By the master, all.
    std::uint64_t received_bytes = 0; ///< By the master, all.
    std::uint64_t peer_bytes = 0;     ///< Of blocks, from worker to worker.
    std::uint64_t blocks_received = 0;
    std::uint64_t memory_bytes_max = 0; ///< Of the worker that holds most, at the end: its peak,
    std::uint64_t memory_bytes_sum = 0; ///< and of all.
    double master_seconds = 0;          ///< In which its thread was busy.
    double work_seconds = 0;            ///< Of all workers with scenarios, as fast cores.
    double dispatcher_us = 0;           ///< Really spent in the dispatcher, for each scenario.
    // Shares of what all cores could have worked, in which they did no scenario:
    double start_share = 0;   ///< before their first,
    double between_share = 0; ///< between two,
    double tail_share = 0;    ///< after their last.
};

/// In this process, which can do that once. The same arguments give the same outcome, but for the
/// dispatcher's real time.
[[nodiscard]] Outcome simulate(const Workload& workload, const SimulationOptions& options);

/// In a child of this process; for a process with one thread. Nothing where that crashes or does
/// not end within the limit.
[[nodiscard]] std::optional<Outcome> simulate_apart(const Workload& workload,
                                                    const SimulationOptions& options,
                                                    std::chrono::seconds limit);

} // namespace cd::bench
