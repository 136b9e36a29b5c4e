// Captures log output during a test.
#pragma once

#include "common/core/host/log.hpp"

#include <memory>
#include <string>

namespace cd::tests {

/// Replaces the default logger and writes in the programs' format.
class Logged {
  public:
    explicit Logged(LogLevel level = LogLevel::Info);
    Logged(const Logged&) = delete;
    Logged& operator=(const Logged&) = delete;
    ~Logged();

    [[nodiscard]] std::string text() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace cd::tests
