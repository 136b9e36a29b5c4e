// The verbs of cdctl that need no connection of their own. Each returns the exit code.
#pragma once

#include "client/cli.hpp"
#include "client/report.hpp"

namespace cd {

[[nodiscard]] int execute(const RunCommand& command);
[[nodiscard]] int execute(const DemoCommand& command);
[[nodiscard]] int execute(const InspectCommand& command);
[[nodiscard]] int execute(const VerifyCommand& command);
[[nodiscard]] int execute(const ExtractCommand& command);
[[nodiscard]] int execute(const VersionCommand& command);

/// The exit code of a run that has ended: 3 where a scenario has no answer, then what `fail_on`
/// asks about, otherwise 0. `inside` counts as `cross` does: solids share space.
[[nodiscard]] int exit_code_of(const Summary& summary, FailOn fail_on);

/// Errors: BadInput for a question that level `any` cannot answer.
[[nodiscard]] Status check_fail_on(FailOn fail_on, Level level);

/// Prints the error as one line on stderr; its exit code.
[[nodiscard]] int fail(const Error& error);

} // namespace cd
