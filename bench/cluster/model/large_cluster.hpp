// Jobs on thousands of simulated hosts: the real coordinator on a simple, scalable network model.
#pragma once

#include "bench/cluster/model/workload.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace cd::bench {

/// Hosts that join while the job runs.
struct LateHosts {
    double share = 1; ///< They join once this share of the scenarios is answered.
    std::vector<double> speeds;
};

struct LargeOptions {
    std::vector<double> speeds; ///< Speed of each host's threads relative to a fast one's.
    std::uint32_t threads = 1;  ///< Of each host.
    LateHosts late = {};
    ClusterOptions dispatch;
    AnalysisMode analysis = AnalysisMode::Always;
    bool peers = true;
    std::uint64_t cache_bytes = 0; ///< Cache of each host; 0: no limit.
    double bytes_per_second = 125e6;
    double latency_seconds = 50e-6; ///< Latency of one link; a message passes two.
    std::uint32_t analysts = 15;    ///< Cores of the master's computer that analyse.
    /// A thread takes ready scenarios of about this time at once; 0: one scenario.
    double at_once_seconds = 0;
    /// Charges the master's thread with the coordinator's real time; runs then differ slightly.
    bool charges_coordinator = false;
    double result_seconds = 0; ///< Time of the master's thread for each result.
};

struct LargeOutcome {
    double seconds = 0;
    std::uint64_t answered = 0;
    std::uint64_t sent_bytes = 0;  ///< Bytes sent by the master.
    std::uint64_t block_bytes = 0; ///< Block bytes among them.
    std::uint64_t uploads_max = 0; ///< Most times that the master sent one block.
    std::uint64_t received_bytes = 0;
    std::uint64_t peer_bytes = 0;
    std::uint64_t evictions = 0;
    std::uint64_t blocks_again = 0; ///< Blocks that reached a host which had them.
    double coordinator_us = 0;      ///< Real time per scenario of the workload.
    double master_share = 0;        ///< Share of the time for which the master's thread is charged.
    // Idle shares of the time of all hosts.
    double start_share = 0;
    double between_share = 0;
    double tail_share = 0;
    double joined_seconds = 0;         ///< When the late hosts joined.
    std::optional<Growth> growth = {}; ///< The master's estimate just before.
};

/// Every host has one link in each direction. Messages larger than control messages pass the
/// sender's link, then the receiver's, in sending order. Control messages overtake them, and take
/// their share of the link. Deterministic unless the coordinator is charged.
[[nodiscard]] LargeOutcome simulate_large(const Workload& workload, const LargeOptions& options);

} // namespace cd::bench
