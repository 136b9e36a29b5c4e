// Logging of the three programs: one fact a line, with fields, on stderr.
#pragma once

#include <spdlog/spdlog.h>

#include <memory>
#include <string>

namespace cd {

/// Sends the default logger to stderr. `level` is one of trace, debug, info, warning, error, off.
void start_logging(const std::string& program, const std::string& level);

/// How a line is written. Control characters of its text are escaped.
[[nodiscard]] std::unique_ptr<spdlog::formatter> log_formatter();

/// A warning that no level hides.
void warn_always(const std::string& text);

} // namespace cd
