// A whole master, from its start to the signal that ends it.
#pragma once

#include "common/core/result.hpp"
#include "master/config.hpp"

namespace cd {

/// Listens, prints the line with which a worker joins, and serves until SIGINT or SIGTERM. Errors:
/// why it could not start.
[[nodiscard]] Status run_master(const MasterConfig& config);

/// `cdmaster init`: makes an identity in the state folder where there is none, and a new credential
/// for an admin; prints where. Errors: those of `MasterIdentity::init`.
[[nodiscard]] Status init_master(const MasterConfig& config);

} // namespace cd
