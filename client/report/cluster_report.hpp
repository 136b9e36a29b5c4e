// What is told of a cluster: its jobs, workers and meshes, and what holds it up.
#pragma once

#include "client/base/table.hpp"
#include "proto/messages/client_messages.hpp"

#include <string>

namespace cd {

[[nodiscard]] Table jobs_table(const ClusterStatus& status);
[[nodiscard]] Table workers_table(const ClusterStatus& status);
[[nodiscard]] Table meshes_table(const ClusterStatus& status);

/// One line without its end: what limits the cluster now, judged by what changed between two
/// statuses taken a moment apart.
[[nodiscard]] std::string bottleneck_text(const ClusterStatus& before, const ClusterStatus& after);

/// The whole status, each line ended; the last one names the bottleneck.
[[nodiscard]] std::string status_text(const ClusterStatus& before, const ClusterStatus& after);
/// The same as one JSON document.
[[nodiscard]] std::string status_json(const ClusterStatus& before, const ClusterStatus& after);

/// One job as a JSON document.
[[nodiscard]] std::string job_json(const JobStatus& job);

} // namespace cd
