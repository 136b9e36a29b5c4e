#include "common/core/host/log_style.hpp"

#include "common/core/printable.hpp"

#include <fmt/chrono.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// A field of a log line. `value` is a format whose replacement fields are numbered.
struct Field {
    std::string_view key;
    std::string_view value;
    bool is_quoted = false;
};

/// Returns `format` with the number of the argument in each replacement field, as in {0} or
/// {1:.3f}, so that its parts can be formatted apart.
std::string numbered(std::string_view format) {
    std::string text;
    int next = 0;
    for (std::size_t at = 0; at < format.size(); ++at) {
        text += format[at];
        if (format[at] == '{') {
            if (at + 1 < format.size() && format[at + 1] == '{') {
                text += format[++at];
            } else {
                text += std::to_string(next++);
            }
        }
    }
    return text;
}

bool is_key(std::string_view word) {
    return !word.empty() &&
           word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789") == std::string::npos;
}

/// Splits `text` into fields that blanks separate. Returns nothing if it is not a list of fields.
std::optional<std::vector<Field>> split_fields(std::string_view text) {
    std::vector<Field> fields;
    while (!text.empty()) {
        const std::size_t equals = text.find('=');
        if (equals == std::string_view::npos || !is_key(text.substr(0, equals))) {
            return std::nullopt;
        }
        Field field{text.substr(0, equals), {}, false};
        text.remove_prefix(equals + 1);
        field.is_quoted = text.substr(0, 1) == "\"";
        text.remove_prefix(field.is_quoted ? 1 : 0);
        const std::size_t end = text.find(field.is_quoted ? '"' : ' ');
        if (field.is_quoted && end == std::string_view::npos) {
            return std::nullopt;
        }
        field.value = text.substr(0, end);
        text.remove_prefix(std::min(text.size(), field.value.size() + (field.is_quoted ? 1 : 0)));
        if (!text.empty() && text.front() != ' ') {
            return std::nullopt;
        }
        text.remove_prefix(text.empty() ? 0 : 1);
        fields.push_back(field);
    }
    return fields;
}

/// Whether `value` is one replacement field, of a number or a truth value.
bool is_of_number(std::string_view value, const fmt::format_args& arguments) {
    int index = 0;
    if (value.size() < 3 || value.front() != '{' || value.find('}') != value.size() - 1) {
        return false;
    }
    const auto [end, error] = std::from_chars(value.data() + 1, value.data() + value.size(), index);
    return error == std::errc() && end != value.data() + 1 && arguments.get(index).is_arithmetic();
}

/// Whether `text` is a number, true or false in JSON: no leading zero, no infinity.
bool is_json_scalar(std::string_view text) {
    if (text == "true" || text == "false") {
        return true;
    }
    const std::string_view digits = text.substr(text.substr(0, 1) == "-" ? 1 : 0);
    const auto is_digit = [&](std::size_t at) {
        return at < digits.size() && digits[at] >= '0' && digits[at] <= '9';
    };
    double number = 0;
    const char* const end = text.data() + text.size();
    return is_digit(0) && (digits[0] != '0' || !is_digit(1)) && digits.back() != '.' &&
           std::from_chars(text.data(), end, number).ptr == end;
}

std::string json_value(const Field& field, const fmt::format_args& arguments) {
    const std::string text =
        fmt::vformat(fmt::string_view(field.value.data(), field.value.size()), arguments);
    const bool is_scalar =
        !field.is_quoted && is_of_number(field.value, arguments) && is_json_scalar(text);
    return is_scalar ? text : json_string(text);
}

std::string event_member(std::string_view format, const fmt::format_args& arguments) {
    return "\"event\":" +
           json_string(fmt::vformat(fmt::string_view(format.data(), format.size()), arguments));
}

} // namespace

LogStyle log_style(std::string_view format) {
    LogStyle style;
    style.is_json = format == "json";
    const char* const stream = std::getenv("JOURNAL_STREAM");
    struct stat file {};
    if (stream != nullptr && ::fstat(STDERR_FILENO, &file) == 0) {
        style.has_priority = stream == fmt::format("{}:{}", file.st_dev, file.st_ino);
    }
    return style;
}

std::string_view journal_priority(LogLevel level) {
    switch (level) {
    case LogLevel::Critical:
        return "<2>";
    case LogLevel::Error:
        return "<3>";
    case LogLevel::Warning:
        return "<4>";
    case LogLevel::Trace:
    case LogLevel::Debug:
        return "<7>";
    case LogLevel::Info:
    case LogLevel::Off:
        break;
    }
    return "<6>";
}

std::string json_string(std::string_view text) {
    const std::string valid = valid_utf8(text);
    std::string out = "\"";
    for (std::size_t at = 0; at < valid.size(); ++at) {
        const auto byte = static_cast<unsigned char>(valid[at]);
        if (byte == '"' || byte == '\\') {
            out += '\\';
            out += valid[at];
        } else if (byte == '\n') {
            out += "\\n";
        } else if (byte == '\t') {
            out += "\\t";
        } else if (byte < 0x20 || byte == 0x7f) {
            out += fmt::format("\\u{:04x}", byte);
        } else if (byte == 0xc2 && static_cast<unsigned char>(valid[at + 1]) < 0xa0) {
            // U+0080 to U+009F are control characters, which could steer a terminal.
            out += fmt::format("\\u{:04x}", static_cast<unsigned char>(valid[++at]));
        } else {
            out += valid[at];
        }
    }
    return out + '"';
}

std::string json_members(fmt::string_view format, fmt::format_args arguments) {
    const std::string text = numbered({format.data(), format.size()});
    const std::string_view whole = text;
    const std::size_t colon = whole.find(": ");
    if (colon == std::string_view::npos) {
        return event_member(whole, arguments);
    }
    const std::string_view rest = whole.substr(colon + 2);
    std::string members = event_member(whole.substr(0, colon), arguments);
    const auto fields = split_fields(rest).value_or(std::vector<Field>{{"detail", rest, true}});
    for (const Field& field : fields) {
        members += "," + json_string(field.key) + ":" + json_value(field, arguments);
    }
    return members;
}

std::string json_line(std::chrono::system_clock::time_point time,
                      std::string_view level,
                      std::string_view program,
                      std::string_view members) {
    const auto milliseconds =
        std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch());
    return fmt::format("{{\"time\":\"{:%Y-%m-%dT%H:%M:%S}.{:03}Z\",\"level\":\"{}\",\"program\":{},"
                       "{}}}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(time)),
                       milliseconds.count() % 1000,
                       level,
                       json_string(program),
                       members);
}

} // namespace cd
