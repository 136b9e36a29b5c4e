// Logging of the three programs: one fact a line, with fields, on stderr.
#pragma once

#include <spdlog/spdlog.h>

#include <string>

namespace cd {

/// Sends the default logger to stderr. `level` is one of trace, debug, info, warning, error, off.
void start_logging(const std::string& program, const std::string& level);

} // namespace cd
