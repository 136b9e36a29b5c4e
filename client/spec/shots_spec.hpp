// Reads the table [shots] of a job file.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/spec/toml_fields.hpp"
#include "common/job/query.hpp"

#include <filesystem>

namespace cd {

/// Reads [shots], which the job has, and refuses the tables whose place it takes; with [bodies] it
/// takes none. Sets the question and the first hits of the query. Paths are relative to the folder
/// of `file`.
[[nodiscard]] ShotsSpec
read_shots(const TomlFields& job, const std::filesystem::path& file, Query& query);

} // namespace cd
