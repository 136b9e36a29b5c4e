// Formats the cluster status for Prometheus.
#pragma once

#include "master/blocks/block_delivery.hpp"
#include "master/journal/commit_times.hpp"
#include "master/journal/journal_writer.hpp"
#include "master/net/process_figures.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Content type of `metrics_text`.
inline constexpr std::string_view metrics_content_type = "text/plain; version=0.0.4; charset=utf-8";

/// What a `WorkerStatus` does not have of a worker.
struct WorkerFigures {
    WorkerId worker;
    std::string name;
    std::string build;                            ///< Version of its program.
    std::optional<BlockDelivery::PeerPort> peers; ///< Empty: the worker serves no others.
};

/// What a `ClusterStatus` does not have.
struct MasterFigures {
    JournalWriter::Counts written;
    CommitTimes::Counts commits;
    std::uint64_t disk_bytes = 0; ///< Size of the state's file system; 0: unknown, as is its room.
    /// End of the master's certificate, in seconds since 1970; empty without one.
    std::optional<double> certificate_until;
    double now = 0; ///< The master's clock, in seconds since 1970.
    ProcessFigures process;
    std::map<unsigned, std::uint64_t> http_answers; ///< Number of answers by status code.
    std::vector<WorkerFigures> workers;
};

/// Returns the metrics in Prometheus text format 0.0.4. Units are seconds, bytes and counts. All
/// counters but that of alarms start at 0 when the master starts. Workers are labelled by id and
/// name. Only running jobs are listed. A figure that is unknown is left out.
[[nodiscard]] std::string metrics_text(const ClusterStatus& status, const MasterFigures& figures);

} // namespace cd
