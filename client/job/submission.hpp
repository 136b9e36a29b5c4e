// Converts a job to a submission for a master, and a submission to a job.
#pragma once

#include "client/job/prepared_job.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstddef>

namespace cd {

/// Describes a body for a master or a manifest. Its unit is the one given in the job, else the one
/// that the mesh file declares, else the job's.
[[nodiscard]] JobBody body_of(const PreparedJob& job, std::size_t body);

/// Converts a job to a submission. Names are escaped, since they may be file names.
[[nodiscard]] Submit submission_of(const PreparedJob& job);

/// Converts a submission to a job without output; names stay escaped. Errors: BadFrame if there are
/// other than two bodies; also for an invalid grid.
[[nodiscard]] Result<JobSpec> spec_of(const Submit& submit);

} // namespace cd
