// Formats the cluster status for Prometheus.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <string>
#include <string_view>

namespace cd {

/// Content type of `metrics_text`.
inline constexpr std::string_view metrics_content_type = "text/plain; version=0.0.4; charset=utf-8";

/// Returns the metrics in Prometheus text format 0.0.4: seconds, bytes and counts. Counters restart
/// with the master. Workers are labelled by number and name; only running jobs are listed.
[[nodiscard]] std::string metrics_text(const ClusterStatus& status);

} // namespace cd
