// Aborts the process when an internal invariant is broken. Other processes redo the work in flight.
#pragma once

namespace cd {

/// Logs the condition, file and line, then aborts.
[[noreturn]] void check_failed(const char* condition, const char* file, int line);

} // namespace cd

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the text of the condition is needed.
#define CD_CHECK(condition)                                                                        \
    do {                                                                                           \
        if (!(condition)) [[unlikely]] {                                                           \
            ::cd::check_failed(#condition, __FILE__, __LINE__);                                    \
        }                                                                                          \
    } while (false)
