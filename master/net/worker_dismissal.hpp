// Drains or terminates workers at an admin's request.
#pragma once

#include "common/core/result.hpp"
#include "proto/messages/client_messages.hpp"

namespace cd {

class Coordinator;

/// Tells the workers to leave: after they have finished what runs and returned the rest, or at
/// once. Errors: NotFound naming an absent worker; then no worker is told.
[[nodiscard]] Result<Draining> dismiss_workers(Coordinator& coordinator, DrainWorkers wish);

} // namespace cd
