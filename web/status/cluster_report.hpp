// Reports about a cluster: its jobs, workers, meshes and bottleneck.
#pragma once

#include "proto/messages/client_messages.hpp"
#include "web/status/table.hpp"

#include <string>

namespace cd {

[[nodiscard]] Table jobs_table(const ClusterStatus& status);
[[nodiscard]] Table workers_table(const ClusterStatus& status);
[[nodiscard]] Table meshes_table(const ClusterStatus& status);

/// What all workers did per second between two statuses.
struct ClusterRates {
    double scenarios = 0;
    double sent = 0;       ///< Bytes to workers.
    double received = 0;   ///< Bytes from workers.
    double from_peers = 0; ///< Bytes of blocks that workers got from each other.
};
[[nodiscard]] ClusterRates rates_between(const ClusterStatus& before, const ClusterStatus& after);

/// Names the cluster's bottleneck in a line without newline, from the changes between two statuses
/// taken a moment apart.
[[nodiscard]] std::string bottleneck_text(const ClusterStatus& before, const ClusterStatus& after);

/// Returns the whole status as lines with newlines; the last one names the bottleneck.
[[nodiscard]] std::string status_text(const ClusterStatus& before, const ClusterStatus& after);
/// Returns the whole status as one JSON document.
[[nodiscard]] std::string status_json(const ClusterStatus& before, const ClusterStatus& after);

/// Returns one job as a JSON document.
[[nodiscard]] std::string job_json(const JobStatus& job);

} // namespace cd
