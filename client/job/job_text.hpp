// Writes a job as the text of a job file.
#pragma once

#include "client/spec/job_file.hpp"

#include <string>

namespace cd {

/// Writes a job as a job file that `parse_job` reads back to an equal job, without values that have
/// their default. A grid whose axes are unknown becomes a comment; the text is then not a valid job
/// file.
[[nodiscard]] std::string job_text(const JobSpec& spec);

} // namespace cd
