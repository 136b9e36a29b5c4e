// A terminal that a program under test writes to.
#pragma once

#include <string>

namespace cd::tests {

/// A pseudo-terminal; the test reads what programs write to it.
class Terminal {
  public:
    Terminal();
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal();

    /// The device that a program opens, such as /dev/pts/3.
    [[nodiscard]] const std::string& device() const { return device_; }
    /// All that was written until now. The terminal ends lines with "\r\n".
    [[nodiscard]] const std::string& text();

  private:
    int screen_ = -1;
    int held_open_ = -1; ///< Without an open device, reading fails.
    std::string device_;
    std::string text_;
};

} // namespace cd::tests
