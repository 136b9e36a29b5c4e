// A job as a master is told of it, and back.
#pragma once

#include "client/prepared_job.hpp"
#include "proto/client_messages.hpp"

#include <cstddef>

namespace cd {

/// A body as it was tested, with its unit as far as it is known.
[[nodiscard]] JobBody body_of(const JobSpec& spec, std::size_t body, const Sha256& mesh);

/// What the master is told of the job. Names may be those of files, so they are escaped.
[[nodiscard]] Submit submission_of(const PreparedJob& job);

/// The job as it was said, but for its output and the names that were escaped. Errors: BadFrame for
/// a job of other than two bodies, and for a grid that is none.
[[nodiscard]] Result<JobSpec> spec_of(const Submit& submit);

} // namespace cd
