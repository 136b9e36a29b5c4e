// The verbs of cdctl that connect to a master. Each returns the exit code.
#pragma once

#include "client/cli/cli.hpp"
#include "client/job/prepared_job.hpp"
#include "client/remote/connection.hpp"

#include <memory>

namespace cd {

[[nodiscard]] int execute(const SubmitCommand& command);
[[nodiscard]] int execute(const WatchCommand& command);
[[nodiscard]] int execute(const ResultsCommand& command);
[[nodiscard]] int execute(const GetCommand& command);
[[nodiscard]] int execute(const StatusCommand& command);
[[nodiscard]] int execute(const CancelCommand& command);
[[nodiscard]] int execute(const RemoveCommand& command);
[[nodiscard]] int execute(const DrainCommand& command);
[[nodiscard]] int execute(const ExplainCommand& command);
[[nodiscard]] int execute(const JoinCommand& command);
[[nodiscard]] int execute(const TokenCommand& command);

/// `run --master`: submits, watches, fetches, reports. The caller has printed the job's header and
/// holds an InterruptGuard; an interrupt cancels the job.
[[nodiscard]] int
run_on_master(const RunCommand& command, PreparedJob& job, std::unique_ptr<Connection> connection);

} // namespace cd
