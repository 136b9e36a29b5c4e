// SIGINT and SIGTERM as a flag that long work looks at.
#pragma once

#include <csignal>

namespace cd {

/// While it lives, the first SIGINT or SIGTERM only sets a flag; a second one ends the process at
/// once. One at a time.
class InterruptGuard {
  public:
    InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    ~InterruptGuard();

    /// The signal that came, or 0.
    [[nodiscard]] static int signal();

  private:
    struct sigaction old_interrupt_ {};
    struct sigaction old_terminate_ {};
};

} // namespace cd
