// Jobs on thousands of simulated hosts: the real dispatcher and director, and a network simple
// enough for that many.
#pragma once

#include "bench/cluster/model/workload.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstdint>
#include <vector>

namespace cd::bench {

struct LargeOptions {
    std::vector<double> speeds; ///< Of each host, against a fast one; one thread each.
    ClusterOptions dispatch;
    bool peers = true;
    std::uint64_t cache_bytes = 0; ///< Of each; 0: no limit.
    double bytes_per_second = 125e6;
    double latency_seconds = 50e-6; ///< Of a link; a message passes two.
    std::uint32_t analysts = 15;    ///< Cores of the master's computer that analyse.
    double results_period = 0.05;
    /// The master's thread is busy for as long as the dispatcher really took; then no two runs are
    /// quite the same.
    bool charges_dispatcher = false;
};

struct LargeOutcome {
    double seconds = 0;
    std::uint64_t answered = 0;
    std::uint64_t sent_bytes = 0;  ///< By the master,
    std::uint64_t block_bytes = 0; ///< of which blocks,
    std::uint64_t received_bytes = 0;
    std::uint64_t peer_bytes = 0;
    std::uint64_t evictions = 0;
    double dispatcher_us = 0; ///< Really spent, for each scenario of the workload.
    double master_share = 0;  ///< Of the time in which its thread is charged.
    // Shares of what all hosts could have worked in which they did no scenario.
    double start_share = 0;
    double between_share = 0;
    double tail_share = 0;
};

/// Every host has one link in each direction. What is larger than a control message passes the
/// sender's link, then the receiver's, one after the other in the order of sending; what is not
/// goes before it, and takes its share of the link. Deterministic unless the dispatcher is charged.
[[nodiscard]] LargeOutcome simulate_large(const Workload& workload, const LargeOptions& options);

} // namespace cd::bench
