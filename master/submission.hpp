// Checks what a client submits, before anything is kept of it.
#pragma once

#include "common/core/result.hpp"
#include "proto/client_messages.hpp"

#include <span>

namespace cd {

/// `stored` are the meshes that the master has. Errors: BadInput, TooLarge and NotFound, naming the
/// field and what it may be.
[[nodiscard]] Status check_submission(const Submit& submit, std::span<const MeshStatus> stored);

} // namespace cd
