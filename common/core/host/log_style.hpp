// Forms of a log line: text for people, JSON for programs, and the priorities of a system's
// journal.
#pragma once

#include "common/core/host/log.hpp"

#include <chrono>
#include <string>
#include <string_view>

namespace cd {

/// What a daemon's options ask for.
struct LogOptions {
    std::string level = "info";  ///< trace, debug, info, warning, error, off
    std::string format = "text"; ///< text, json
};

/// The form of log lines.
struct LogStyle {
    bool is_json = false;      ///< One JSON object a line, else text.
    bool has_priority = false; ///< Begins with a priority such as `<6>`; text then has no time.
};

/// Returns the style for `format` (text or json). Lines have a priority if stderr is the stream
/// that JOURNAL_STREAM names, as under systemd.
[[nodiscard]] LogStyle log_style(std::string_view format);

/// Starts logging to stderr as asked for.
void start_logging(const std::string& program, const LogOptions& options);

/// Returns the priority with which the journal files lines of this level, such as `<6>`.
[[nodiscard]] std::string_view journal_priority(LogLevel level);

/// Returns `text` as a JSON string with its quotes: escapes control characters, and has U+FFFD in
/// place of bytes that are not UTF-8.
[[nodiscard]] std::string json_string(std::string_view text);

/// Returns the members `event` and fields of a line's JSON object. In `format`, the event ends at
/// the first ": ", and fields follow: key={}, key="{}" or key=word. An unquoted number, or true or
/// false, stays one in JSON. If no fields follow, the text after ": " is the field `detail`.
[[nodiscard]] std::string json_members(fmt::string_view format, fmt::format_args arguments);

/// Returns a line's JSON object without newline; `members` comes from `json_members`.
[[nodiscard]] std::string json_line(std::chrono::system_clock::time_point time,
                                    std::string_view level,
                                    std::string_view program,
                                    std::string_view members);

} // namespace cd
