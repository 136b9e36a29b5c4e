// What `cdctl doctor` says of a master and its workers.
#pragma once

#include "client/commands/doctor/finding.hpp"
#include "client/remote/master_metrics.hpp"
#include "proto/messages/client_messages.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// What is known of a cluster.
struct ClusterFacts {
    std::string address; ///< The master's, as the user wrote it.
    std::string owner;   ///< Who the user is for the master.
    std::string role;    ///< The role in the user's certificate; empty without one.
    bool is_tls = false;
    bool is_loopback = false;
    ClusterStatus status;
    /// Set if the master's HTTP port was read. Its `time_seconds` is that of `metrics_time` here.
    std::optional<MasterMetrics> metrics;
    std::chrono::system_clock::time_point status_time; ///< When the status came, by this clock.
    std::chrono::system_clock::time_point metrics_time;
    std::string no_metrics; ///< Why there are no metrics.
};

/// Returns true if metrics are those of the master that gave the status.
[[nodiscard]] bool is_of_master(const MasterMetrics& metrics, const ClusterStatus& status);

/// Returns how far the master's clock is ahead of this one, in seconds: by its metrics, or else by
/// a running job that it has accepted since it started, to a second; empty if neither tells.
[[nodiscard]] std::optional<double> clock_ahead(const ClusterFacts& facts);

[[nodiscard]] Finding master_finding(const ClusterFacts& facts);
/// At least one finding: one for each worker with a fault, or one for all.
[[nodiscard]] std::vector<Finding> worker_findings(const ClusterFacts& facts);
/// A finding for each paused job, and one if there are alarms.
[[nodiscard]] std::vector<Finding> job_findings(const ClusterFacts& facts);
[[nodiscard]] Finding disk_finding(const ClusterFacts& facts);

} // namespace cd
