// What a cluster tells to Prometheus.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <string>
#include <string_view>

namespace cd {

/// Of `metrics_text`.
inline constexpr std::string_view metrics_content_type = "text/plain; version=0.0.4; charset=utf-8";

/// In Prometheus' text format, version 0.0.4: seconds, bytes and counts. Counters begin anew with
/// the master. Workers are labelled by number and name; of jobs, those that run.
[[nodiscard]] std::string metrics_text(const ClusterStatus& status);

} // namespace cd
