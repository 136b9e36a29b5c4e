// What is logged while a test looks.
#pragma once

#include "common/core/log.hpp"

#include <spdlog/sinks/ostream_sink.h>

#include <memory>
#include <sstream>
#include <string>

namespace cd::tests {

/// Takes the place of the default logger, written as the programs write it.
class Logged {
  public:
    explicit Logged(spdlog::level::level_enum level = spdlog::level::info) {
        auto sink = std::make_shared<spdlog::sinks::ostream_sink_mt>(text_);
        auto logger = std::make_shared<spdlog::logger>("test", std::move(sink));
        logger->set_formatter(log_formatter());
        logger->set_level(level);
        spdlog::set_default_logger(std::move(logger));
    }
    Logged(const Logged&) = delete;
    Logged& operator=(const Logged&) = delete;
    ~Logged() { spdlog::set_default_logger(before_); }

    [[nodiscard]] std::string text() const { return text_.str(); }

  private:
    std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
    std::ostringstream text_;
};

} // namespace cd::tests
