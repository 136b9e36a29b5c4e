// The exit codes of cdctl.
#pragma once

#include "common/core/result.hpp"

namespace cd {

inline constexpr int exit_done = 0;
inline constexpr int exit_contacts =
    1; ///< Contacts found (--fail-on), differences (verify), a fault (doctor).
inline constexpr int exit_usage = 2; ///< Wrong usage or input.
inline constexpr int exit_incomplete = 3;
inline constexpr int exit_unreachable = 4;
inline constexpr int exit_refused = 5;
inline constexpr int exit_signal_base = 128; ///< Added to the signal's number: 130, 143.

/// Returns the exit code for an error. For Interrupted it is 128 + `signal`.
[[nodiscard]] int exit_code_of(const Error& error, int signal = 2);

} // namespace cd
