// Invariants of the coordinator, which hold between two events.
#pragma once

#include "master/coordinator/master_services.hpp"
#include "master/coordinator/master_state.hpp"

namespace cd {

/// Aborts if an invariant is broken, for example: every task belongs to a known worker, and no
/// scenario is lost. For tests.
void check_invariants(const MasterState& state, const MasterServices& services);

} // namespace cd
