// SIGINT and SIGTERM as a flag that long operations poll.
#pragma once

#include <csignal>

namespace cd {

/// During the lifetime of a guard, the first SIGINT or SIGTERM only sets a flag; the second ends
/// the process at once. Only one guard may exist at a time.
class InterruptGuard {
  public:
    /// The effect of the first signal. With `EndsProcess` and before `begin_to_flag`, it ends the
    /// process at once, with a line on stderr and exit code 128 + signal. This suits work that may
    /// block and whose loss does no harm: reading inputs, building trees.
    enum class First { SetsFlag, EndsProcess };

    explicit InterruptGuard(First first = First::SetsFlag);
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    ~InterruptGuard();

    /// From now on, the first signal only sets the flag.
    static void begin_to_flag();
    /// From now on, the first signal ends the process, as with `EndsProcess`. If a signal has
    /// already come, ends the process immediately.
    static void begin_to_end();
    /// Returns the signal received since the guard was made, or 0.
    [[nodiscard]] static int signal();
    /// True after a signal; usable as a `StopCheck`.
    [[nodiscard]] static bool has_come() { return signal() != 0; }

  private:
    struct sigaction old_interrupt_ {};
    struct sigaction old_terminate_ {};
};

} // namespace cd
