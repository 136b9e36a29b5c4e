// The verbs of cdctl.
#pragma once

#include "client/cli/cli.hpp"
#include "client/report/report.hpp"
#include "common/core/result.hpp"

namespace cd {

/// Runs a verb and returns its exit code. An error ends the verb; `execute` turns it into a code.
[[nodiscard]] Result<int> perform(const RunCommand& command);
[[nodiscard]] Result<int> perform(const CheckCommand& command);
[[nodiscard]] Result<int> perform(const DemoCommand& command);
[[nodiscard]] Result<int> perform(const SubmitCommand& command);
[[nodiscard]] Result<int> perform(const WatchCommand& command);
[[nodiscard]] Result<int> perform(const ResultsCommand& command);
[[nodiscard]] Result<int> perform(const VerifyCommand& command);
[[nodiscard]] Result<int> perform(const ExtractCommand& command);
[[nodiscard]] Result<int> perform(const ViewCommand& command);
[[nodiscard]] Result<int> perform(const DiffCommand& command);
[[nodiscard]] Result<int> perform(const ReportCommand& command);
[[nodiscard]] Result<int> perform(const GetCommand& command);
[[nodiscard]] Result<int> perform(const StatusCommand& command);
[[nodiscard]] Result<int> perform(const PriorityCommand& command);
[[nodiscard]] Result<int> perform(const CancelCommand& command);
[[nodiscard]] Result<int> perform(const RemoveCommand& command);
[[nodiscard]] Result<int> perform(const DrainCommand& command);
[[nodiscard]] Result<int> perform(const ExplainCommand& command);
[[nodiscard]] Result<int> perform(const JoinCommand& command);
[[nodiscard]] Result<int> perform(const TokenCommand& command);
[[nodiscard]] Result<int> perform(const InspectCommand& command);
[[nodiscard]] Result<int> perform(const VersionCommand& command);
[[nodiscard]] Result<int> perform(const ConfigCommand& command);
[[nodiscard]] Result<int> perform(const DoctorCommand& command);
[[nodiscard]] Result<int> perform(const CompletionCommand& command);
[[nodiscard]] Result<int> perform(const CompleteCommand& command);

/// Prints an error as one line on stderr and returns its exit code.
[[nodiscard]] int fail(const Error& error);

/// Runs a verb, prints its error, if any, and returns the exit code.
template <class Command>
[[nodiscard]] int execute(const Command& command) {
    const Result<int> code = perform(command);
    return code ? code.value() : fail(code.error());
}

/// Returns the exit code of a finished run: 3 if a scenario has no result or failed; else 1 if the
/// run has what `fail_on` names (`inside` counts like `cross`, since the solids share space); else
/// 3 if undecided scenarios leave this open; else 0. `has_news` tells whether there are groups for
/// `FailOn::news`.
[[nodiscard]] int exit_code_of(const Summary& summary, FailOn fail_on, bool has_news = false);

/// Refuses at `level any` to fail on cross alone, since that level does not tell touch from cross;
/// without a clearance to fail on near; and without groups (`asks_for_groups`) to fail on new ones.
/// Errors: BadInput.
[[nodiscard]] Status check_fail_on(FailOn fail_on, const Query& query);

} // namespace cd
