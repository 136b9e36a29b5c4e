// The worker daemon: connects to the master, serves it, and reconnects until it must end.
#pragma once

#include "worker/config.hpp"

namespace cd {

/// Runs the daemon until the worker has drained or cannot work. Returns a code that --help lists.
[[nodiscard]] int run_worker(const WorkerConfig& config);

/// Runs `cdworker join`: gets a credential with the configured token. Returns the exit code.
[[nodiscard]] int join_as_worker(const WorkerConfig& config);

} // namespace cd
