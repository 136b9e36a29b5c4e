// The verbs of cdctl that work without a master. Each returns the exit code.
#pragma once

#include "client/cli/cli.hpp"
#include "client/report/report.hpp"

namespace cd {

[[nodiscard]] int execute(const RunCommand& command);
[[nodiscard]] int execute(const DemoCommand& command);
[[nodiscard]] int execute(const InspectCommand& command);
[[nodiscard]] int execute(const VerifyCommand& command);
[[nodiscard]] int execute(const ExtractCommand& command);
[[nodiscard]] int execute(const VersionCommand& command);

/// The exit code of a finished run: 3 if a scenario has no result or failed; else 1 if the run has
/// contacts that `fail_on` names (`inside` counts like `cross`, since the solids share space); else
/// 3 if undecided scenarios leave this open; else 0.
[[nodiscard]] int exit_code_of(const Summary& summary, FailOn fail_on);

/// Refuses `FailOn::Cross` at `level any`, which does not tell touch from cross. Errors: BadInput.
[[nodiscard]] Status check_fail_on(FailOn fail_on, Level level);

/// Prints an error as one line on stderr and returns its exit code.
[[nodiscard]] int fail(const Error& error);

} // namespace cd
