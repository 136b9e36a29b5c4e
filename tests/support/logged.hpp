// What is logged while a test looks.
#pragma once

#include "common/core/host/log.hpp"

#include <memory>
#include <string>

namespace cd::tests {

/// Takes the place of the default logger, written as the programs write it.
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
