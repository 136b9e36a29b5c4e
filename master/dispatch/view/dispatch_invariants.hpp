// Checks the invariants of the dispatcher, which hold between two events.
#pragma once

#include "master/dispatch/dispatch_parts.hpp"

namespace cd {

/// Aborts if an invariant is broken.
void check_invariants_of(const DispatchParts& parts);

} // namespace cd
