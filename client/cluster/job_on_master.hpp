// Connections to a master, and the jobs on it.
#pragma once

#include "client/base/interrupt.hpp"
#include "client/cli/cli.hpp"
#include "client/job/prepared_job.hpp"
#include "client/remote/connection.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace cd {

/// Connects to a master. `stopped` interrupts the connection's calls; by default a signal does
/// (`InterruptGuard`).
[[nodiscard]] Result<std::unique_ptr<Connection>>
open_master(const MasterOptions& options, StopCheck stopped = &InterruptGuard::has_come);

/// A connection, and the status that the cluster had when it was opened.
struct ConnectedCluster {
    std::unique_ptr<Connection> connection;
    ClusterStatus status;
};
/// Connects to a master and asks for the cluster's status. Errors: as `open_master`.
[[nodiscard]] Result<ConnectedCluster> open_cluster(const MasterOptions& options,
                                                    StopCheck stopped = &InterruptGuard::has_come);

/// A connection, and a job on the master.
struct ConnectedJob {
    std::unique_ptr<Connection> connection;
    JobStatus status; ///< The job's status when the connection was opened.
    std::string id;   ///< Short unique id: "j-4f2a".
};
/// Connects to a master and finds the job that `text` names. Errors: as `open_master` and
/// `find_job`.
[[nodiscard]] Result<ConnectedJob> open_job(const MasterOptions& options,
                                            const std::string& text,
                                            StopCheck stopped = &InterruptGuard::has_come);

/// Returns the number of workers that are not lost.
[[nodiscard]] std::uint64_t worker_count(const ClusterStatus& cluster);
/// Asks for the number of workers that are not lost; 0 if the master does not answer.
[[nodiscard]] std::uint64_t worker_count(Connection& connection);
/// Asks for `worker_count` as text: "12 workers"; empty if the master does not answer.
[[nodiscard]] std::string workers_text(Connection& connection);

/// Uploads meshes that the master lacks, with a line on stderr unless quiet, and submits the job.
[[nodiscard]] Result<JobId>
send_job(Connection& connection, PreparedJob& job, bool quiet, std::int32_t priority);

/// Checks that the job is done. Errors: Incomplete with the reason.
[[nodiscard]] Status check_done(const JobStatus& job, const std::string& id);

} // namespace cd
