// Runs a master from its start to the signal that ends it.
#pragma once

#include "common/core/result.hpp"
#include "master/config.hpp"

namespace cd {

/// Listens, prints the command with which a worker joins, and serves until SIGINT or SIGTERM.
/// Errors: why the master could not start.
[[nodiscard]] Status run_master(const MasterConfig& config);

/// `cdmaster init`: creates an identity in the state folder if it has none, and a new admin
/// credential; prints its path. Errors: those of `MasterIdentity::init`.
[[nodiscard]] Status init_master(const MasterConfig& config);

} // namespace cd
