// Jobs as text: what a job file would say.
#pragma once

#include "client/job_file.hpp"

#include <string>
#include <string_view>

namespace cd {

/// The job as a job file, which `parse_job` reads back to the same job; what has its default is
/// left out. A grid whose axes are not known becomes a comment, and then it is no job file.
[[nodiscard]] std::string job_text(const JobSpec& spec);

/// The text in quotes, as TOML wants it.
[[nodiscard]] std::string toml_quoted(std::string_view text);

} // namespace cd
