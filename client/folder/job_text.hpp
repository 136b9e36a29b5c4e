// Jobs as text: what a job file would say.
#pragma once

#include "client/folder/run_manifest.hpp"

#include <string>
#include <string_view>

namespace cd {

/// The job as a job file. What a job file cannot say stands there as a comment: a grid, whose
/// angles have become quaternions, and ranges of triangles that are passed over.
[[nodiscard]] std::string job_text(const RunManifest& manifest);

/// The text in quotes, as TOML wants it.
[[nodiscard]] std::string toml_quoted(std::string_view text);

} // namespace cd
