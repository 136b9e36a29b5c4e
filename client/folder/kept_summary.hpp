// Reads the summary.json of a results folder.
#pragma once

#include "client/report/report.hpp"
#include "common/core/result.hpp"

#include <filesystem>

namespace cd {

/// Reads the counts of classes, time, place, most touched parts and digest from summary.json.
/// Missing keys count as 0 or none. Errors: Io, BadInput naming the file.
[[nodiscard]] Result<RunReport> read_summary(const std::filesystem::path& path);

} // namespace cd
