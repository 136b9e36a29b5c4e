// Drains or terminates workers at an admin's request.
#pragma once

#include "common/core/result.hpp"
#include "proto/messages/client_messages.hpp"

namespace cd {

class Coordinator;

/// Makes the named workers leave, or all if `wish` names none: either after they have finished the
/// running scenarios and returned the others, or, with `wish.now`, at once. Errors: NotFound naming
/// an unknown worker; then no worker leaves.
[[nodiscard]] Result<Draining> dismiss_workers(Coordinator& coordinator, DrainWorkers wish);

} // namespace cd
