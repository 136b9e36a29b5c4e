// Formats the cluster status for Prometheus.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <string>
#include <string_view>

namespace cd {

/// Content type of `metrics_text`.
inline constexpr std::string_view metrics_content_type = "text/plain; version=0.0.4; charset=utf-8";

/// Returns the metrics in Prometheus text format 0.0.4. Units are seconds, bytes and counts. All
/// counters but that of alarms start at 0 when the master starts. Workers are labelled by id and
/// name. Only running jobs are listed.
[[nodiscard]] std::string metrics_text(const ClusterStatus& status);

} // namespace cd
