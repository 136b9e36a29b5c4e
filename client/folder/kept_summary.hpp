// Reads the summary.json of a results folder.
#pragma once

#include "client/report/report.hpp"
#include "common/core/result.hpp"

#include <filesystem>

namespace cd {

/// The classes, time, place, most touched parts and digest in summary.json. Missing keys count as 0
/// or none. Errors: Io, BadInput naming the file.
[[nodiscard]] Result<RunReport> read_summary(const std::filesystem::path& path);

} // namespace cd
