// Converts jobs to submissions for a master and back.
#pragma once

#include "client/job/prepared_job.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstddef>

namespace cd {

/// The description of a body for a master or a manifest. Its unit is the given one, else the one
/// that the mesh file declares, else the job's.
[[nodiscard]] JobBody body_of(const JobSpec& spec, std::size_t body, const Sha256& mesh);

/// The submission of a job. Names are escaped, since they may be file names.
[[nodiscard]] Submit submission_of(const PreparedJob& job);

/// The job of a submission, without its output; names stay escaped. Errors: BadFrame unless the job
/// has two bodies, and for an invalid grid.
[[nodiscard]] Result<JobSpec> spec_of(const Submit& submit);

} // namespace cd
