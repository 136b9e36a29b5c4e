#include "tests/support/logged.hpp"

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <sstream>

namespace cd::tests {

struct Logged::State {
    std::shared_ptr<spdlog::logger> before = spdlog::default_logger();
    std::ostringstream text;
};

Logged::Logged(LogLevel level) : state_(std::make_unique<State>()) {
    auto sink = std::make_shared<spdlog::sinks::ostream_sink_mt>(state_->text);
    auto logger = std::make_shared<spdlog::logger>("test", std::move(sink));
    logger->set_formatter(log_formatter());
    logger->set_level(static_cast<spdlog::level::level_enum>(level));
    spdlog::set_default_logger(std::move(logger));
}

Logged::~Logged() {
    spdlog::set_default_logger(state_->before);
}

std::string Logged::text() const {
    return state_->text.str();
}

} // namespace cd::tests
