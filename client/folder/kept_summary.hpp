// A results folder's summary.json, read again.
#pragma once

#include "client/report.hpp"
#include "common/core/result.hpp"

#include <filesystem>

namespace cd {

/// What summary.json says of a run, as far as a person is told: classes, time, where it ran, most
/// touched parts, digest. Keys that are missing count as 0 or none. Errors: Io, BadInput naming the
/// file.
[[nodiscard]] Result<RunReport> read_summary(const std::filesystem::path& path);

} // namespace cd
