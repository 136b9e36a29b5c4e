// Logs to stderr, one fact per line, with fields. The header is cheap to include: only log.cpp
// includes spdlog and the formatting code.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <memory>
#include <string>

namespace spdlog {
class formatter;
}

namespace cd {

enum class LogLevel : std::uint8_t { Trace, Debug, Info, Warning, Error, Critical, Off };

/// Starts logging to stderr. `level` is one of trace, debug, info, warning, error, off.
void start_logging(const std::string& program, const std::string& level);

/// Makes the formatter of log lines, which escapes control characters of the logged text.
[[nodiscard]] std::unique_ptr<spdlog::formatter> log_formatter();

/// Logs a warning, also at log levels that hide warnings.
void warn_always(const std::string& text);

/// Logs a line unless its level is hidden. On return, a critical line has reached stderr.
void log_formatted(LogLevel level, fmt::string_view format, fmt::format_args arguments);

template <typename... Arguments>
void log_at(LogLevel level,
            fmt::format_string<const Arguments&...> format,
            const Arguments&... arguments) {
    log_formatted(level, format, fmt::make_format_args(arguments...));
}
template <typename... Arguments>
void log_debug(fmt::format_string<const Arguments&...> format, const Arguments&... arguments) {
    log_formatted(LogLevel::Debug, format, fmt::make_format_args(arguments...));
}
template <typename... Arguments>
void log_info(fmt::format_string<const Arguments&...> format, const Arguments&... arguments) {
    log_formatted(LogLevel::Info, format, fmt::make_format_args(arguments...));
}
template <typename... Arguments>
void log_warning(fmt::format_string<const Arguments&...> format, const Arguments&... arguments) {
    log_formatted(LogLevel::Warning, format, fmt::make_format_args(arguments...));
}
template <typename... Arguments>
void log_error(fmt::format_string<const Arguments&...> format, const Arguments&... arguments) {
    log_formatted(LogLevel::Error, format, fmt::make_format_args(arguments...));
}
template <typename... Arguments>
void log_critical(fmt::format_string<const Arguments&...> format, const Arguments&... arguments) {
    log_formatted(LogLevel::Critical, format, fmt::make_format_args(arguments...));
}

} // namespace cd
