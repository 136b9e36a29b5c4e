// Functions shared by the verbs that connect to a master.
#pragma once

#include "client/cli/cli.hpp"
#include "client/cluster/job_on_master.hpp"
#include "client/remote/connection.hpp"
#include "client/report/progress.hpp"
#include "common/core/result.hpp"

#include <memory>
#include <string>

namespace cd {

/// Connects to a master for a job that could also run on this machine; the text of a network error
/// says so. Callers connect before they read the inputs, which may take long.
[[nodiscard]] Result<std::unique_ptr<Connection>> open_master_for_job(const MasterOptions& options);

/// As `open_job`, for an argument that is no folder; the text of an error says so.
[[nodiscard]] Result<ConnectedJob> open_job_of_argument(const MasterOptions& options,
                                                        const std::string& text);

/// Watches the job to its end, with progress on stderr. After a network error it reconnects, and
/// gives up after a minute.
[[nodiscard]] Result<JobStatus> watch_job(const MasterOptions& master,
                                          std::unique_ptr<Connection>& connection,
                                          JobId job,
                                          const std::string& id,
                                          ProgressPrinter::Style progress);

} // namespace cd
