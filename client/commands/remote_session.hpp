// Shared parts of the verbs that connect to a master.
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

/// Connects to a master; the connection stops at a signal (`InterruptGuard`).
[[nodiscard]] Result<std::unique_ptr<Connection>> open_master(const MasterOptions& options);
/// Connects for a job that could also run here; an error of the network says so. Called before the
/// inputs are read, which may take long.
[[nodiscard]] Result<std::unique_ptr<Connection>> open_master_for_job(const MasterOptions& options);

/// The number of workers that are not lost.
[[nodiscard]] std::uint64_t worker_count(const ClusterStatus& cluster);
/// `worker_count` as text: "12 workers".
[[nodiscard]] std::string workers_text(const ClusterStatus& cluster);

/// Uploads what is missing, with a line on stderr for each mesh unless quiet, and submits.
[[nodiscard]] Result<JobId> send_job(Connection& connection, PreparedJob& job, bool quiet);

/// A job that the master knows, as the user wrote it, with its name among the others.
struct KnownJob {
    JobStatus status;
    std::string id;                    ///< "j-4f2a"
    std::array<std::string, 2> bodies; ///< Names of the meshes, as far as they are known.
};
/// Errors: those of `find_job`.
[[nodiscard]] Result<KnownJob> find_known_job(Connection& connection, const std::string& text);

/// Watches the job to its end, with progress on stderr. When the master goes away, or the
/// connection is good for nothing any more, waits for it to come back, for a minute, with a new
/// connection.
[[nodiscard]] Result<JobStatus> watch_job(const MasterOptions& master,
                                          std::unique_ptr<Connection>& connection,
                                          JobId job,
                                          const std::string& id,
                                          ProgressPrinter::Style progress);

/// Pulls all results that there are of a job into `take`. Errors: those of `take`; BadFrame when
/// what came does not have the digest that the master states of a job that is done.
[[nodiscard]] Status fetch_results(Connection& connection,
                                   const JobStatus& job,
                                   const std::function<Status(const ScenarioResult&)>& take);

/// Puts the job's map into its report, where one was asked for. Errors: BadFrame for a map that is
/// none.
[[nodiscard]] Status fetch_map(Connection& connection, JobId job, RunReport& report);

/// Nothing of a job that is done; otherwise why there are no results of it: Incomplete.
[[nodiscard]] Status check_done(const JobStatus& job, const std::string& id);

/// How many scenarios of a job have a result: "incomplete: 12 of 90 scenarios ...". Empty for a job
/// that is done.
[[nodiscard]] std::string coverage_text(const JobStatus& job, std::uint64_t answered);

/// The report of a job that has ended. `level` is the level of its results, if known.
[[nodiscard]] RunReport report_of(const JobStatus& job, Level level);

} // namespace cd
