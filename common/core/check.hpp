// Aborts the process if an internal invariant is broken. Other processes redo its unfinished work.
#pragma once

namespace cd {

/// Logs the condition, file and line, then aborts.
[[noreturn]] void check_failed(const char* condition, const char* file, int line);

} // namespace cd

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): only a macro has the condition's text.
#define CD_CHECK(condition)                                                                        \
    do {                                                                                           \
        if (!(condition)) [[unlikely]] {                                                           \
            ::cd::check_failed(#condition, __FILE__, __LINE__);                                    \
        }                                                                                          \
    } while (false)
