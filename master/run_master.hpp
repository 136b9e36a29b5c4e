// Runs a master from its start to the signal that ends it.
#pragma once

#include "common/core/result.hpp"
#include "master/config.hpp"

namespace cd {

/// Listens, prints the command with which a worker joins, and serves until SIGINT or SIGTERM.
/// Returns an error if the master cannot start.
[[nodiscard]] Status run_master(const MasterConfig& config);

/// `cdmaster init`: creates an identity in the state folder if there is none, writes a new admin
/// credential, and prints its path. Errors: as `MasterIdentity::init`.
[[nodiscard]] Status init_master(const MasterConfig& config);

} // namespace cd
