#include "common/core/host/log.hpp"

#include "common/core/host/log_style.hpp"
#include "common/core/printable.hpp"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <atomic>

namespace cd {

namespace {

/// Escapes the logged text, so that foreign text cannot forge a log line.
class EscapedText : public spdlog::custom_flag_formatter {
  public:
    void format(const spdlog::details::log_msg& message,
                const std::tm& /*time*/,
                spdlog::memory_buf_t& out) override {
        const std::string text = escaped({message.payload.data(), message.payload.size()});
        out.append(text.data(), text.data() + text.size());
    }
    [[nodiscard]] std::unique_ptr<custom_flag_formatter> clone() const override {
        return std::make_unique<EscapedText>();
    }
};

std::string_view view(const spdlog::string_view_t& text) {
    return {text.data(), text.size()};
}

/// Formats lines with a priority, or as JSON, for which the logged text is the object's members.
class StyledLines final : public spdlog::formatter {
  public:
    explicit StyledLines(LogStyle style) : style_(style) {}

    void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override {
        std::string line;
        if (style_.has_priority) {
            line += journal_priority(static_cast<LogLevel>(message.level));
        }
        line += style_.is_json ? json_line(message.time,
                                           view(spdlog::level::to_string_view(message.level)),
                                           view(message.logger_name),
                                           view(message.payload))
                               : escaped(view(message.payload));
        line += '\n';
        out.append(line.data(), line.data() + line.size());
    }
    [[nodiscard]] std::unique_ptr<spdlog::formatter> clone() const override {
        return std::make_unique<StyledLines>(style_);
    }

  private:
    LogStyle style_;
};

/// Whether the text of a message is the members of a JSON object.
std::atomic<bool> writes_json = false;

std::string message_text(fmt::string_view format, fmt::format_args arguments) {
    return writes_json ? json_members(format, arguments) : fmt::vformat(format, arguments);
}

static_assert(static_cast<int>(LogLevel::Trace) == SPDLOG_LEVEL_TRACE);
static_assert(static_cast<int>(LogLevel::Off) == SPDLOG_LEVEL_OFF);

} // namespace

std::unique_ptr<spdlog::formatter> log_formatter() {
    auto formatter = std::make_unique<spdlog::pattern_formatter>();
    formatter->add_flag<EscapedText>('*').set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %^%l%$ %n %*");
    return formatter;
}

void start_logging(const std::string& program, const std::string& level) {
    auto logger = std::make_shared<spdlog::logger>(
        program, std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    logger->set_formatter(log_formatter());
    logger->set_level(spdlog::level::from_str(level));
    logger->flush_on(spdlog::level::info);
    spdlog::set_default_logger(std::move(logger));
}

void start_logging(const std::string& program, const LogOptions& options) {
    start_logging(program, options.level);
    const LogStyle style = log_style(options.format);
    if (style.is_json || style.has_priority) {
        spdlog::default_logger()->set_formatter(std::make_unique<StyledLines>(style));
    }
    writes_json = style.is_json;
}

void warn_always(const std::string& text) {
    const auto logger = spdlog::default_logger();
    const std::string line = message_text("{}", fmt::make_format_args(text));
    const spdlog::details::log_msg message(logger->name(), spdlog::level::warn, line);
    for (const auto& sink : logger->sinks()) {
        sink->log(message);
        sink->flush();
    }
}

void log_formatted(LogLevel level, fmt::string_view format, fmt::format_args arguments) {
    spdlog::logger* logger = spdlog::default_logger_raw();
    const auto spdlog_level = static_cast<spdlog::level::level_enum>(level);
    if (!logger->should_log(spdlog_level)) {
        return;
    }
    logger->log(spdlog_level, message_text(format, arguments));
    if (level == LogLevel::Critical) {
        logger->flush();
    }
}

} // namespace cd
