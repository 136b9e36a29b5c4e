// Functions shared by the verbs that connect to a master.
#pragma once

#include "client/cli/cli.hpp"
#include "client/job/prepared_job.hpp"
#include "client/remote/connection.hpp"
#include "client/report/progress.hpp"
#include "client/report/report.hpp"
#include "common/core/result.hpp"
#include "common/job/result/merge.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace cd {

/// Connects to a master; a signal (`InterruptGuard`) interrupts the connection's calls.
[[nodiscard]] Result<std::unique_ptr<Connection>> open_master(const MasterOptions& options);
/// Connects for a job that could also run on this machine, as the text of a network error then
/// says. Called before the inputs are read, which may take long.
[[nodiscard]] Result<std::unique_ptr<Connection>> open_master_for_job(const MasterOptions& options);

/// A connection, and the cluster's status when it was opened.
struct ConnectedCluster {
    std::unique_ptr<Connection> connection;
    ClusterStatus status;
};
/// Connects to a master and asks for the status. Errors: those of `open_master`.
[[nodiscard]] Result<ConnectedCluster> open_cluster(const MasterOptions& options);

/// The number of workers that are not lost.
[[nodiscard]] std::uint64_t worker_count(const ClusterStatus& cluster);
/// `worker_count` as text: "12 workers".
[[nodiscard]] std::string workers_text(const ClusterStatus& cluster);

/// Uploads missing meshes, each with a line on stderr unless quiet, and submits the job.
[[nodiscard]] Result<JobId> send_job(Connection& connection, PreparedJob& job, bool quiet);

/// A job on the master, found by the user's text.
struct KnownJob {
    JobStatus status;
    std::string id;                    ///< Short unique id: "j-4f2a".
    std::array<std::string, 2> bodies; ///< Names of the meshes; short hashes of unnamed ones.
};
/// Finds the job that `text` names on the master. Errors: those of `find_job`.
[[nodiscard]] Result<KnownJob> find_known_job(Connection& connection, const std::string& text);

/// Watches the job to its end, with progress on stderr. After a network error it reconnects, and
/// gives up after a minute.
[[nodiscard]] Result<JobStatus> watch_job(const MasterOptions& master,
                                          std::unique_ptr<Connection>& connection,
                                          JobId job,
                                          const std::string& id,
                                          ProgressPrinter::Style progress);

/// Fetches all existing results of a job into `take`. Errors: those of `take`; BadFrame when the
/// results do not match the digest that the master states for a completed job.
[[nodiscard]] Status fetch_results(Connection& connection,
                                   const JobStatus& job,
                                   const std::function<Status(const ScenarioResult&)>& take);

/// Adds the job's contact map, if the job asks for maps, to its report. Errors: BadFrame for an
/// invalid map.
[[nodiscard]] Status fetch_map(Connection& connection, JobId job, RunReport& report);

/// Checks that the job is done. Errors: Incomplete with the reason.
[[nodiscard]] Status check_done(const JobStatus& job, const std::string& id);

/// The number of scenarios with a result: "incomplete: 12 of 90 scenarios ...". Empty for a
/// completed job.
[[nodiscard]] std::string coverage_text(const JobStatus& job, std::uint64_t answered);

/// The report of an ended job. `level` is the level of the job.
[[nodiscard]] RunReport report_of(const JobStatus& job, Level level);

} // namespace cd
