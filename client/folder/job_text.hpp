// Writes a job as the text of a job file.
#pragma once

#include "client/spec/job_file.hpp"

#include <string>
#include <string_view>

namespace cd {

/// The text of a job file that `parse_job` reads back to the same job, without values that have
/// their default. A grid whose axes are unknown becomes a comment, so the text is then no valid
/// job.
[[nodiscard]] std::string job_text(const JobSpec& spec);

/// A TOML string with this content.
[[nodiscard]] std::string toml_quoted(std::string_view text);

} // namespace cd
