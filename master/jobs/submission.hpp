// Checks what a client submits, before anything is kept of it.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <span>
#include <vector>

namespace cd {

/// `stored` are the meshes that the master has. Errors: BadInput, TooLarge and NotFound, naming the
/// field and what it may be.
[[nodiscard]] Status check_submission(const Submit& submit, std::span<const MeshStatus> stored);

[[nodiscard]] std::vector<Sha256> meshes_of(const Submit& submit);

/// The bytes of the fields that can be large: the grid and the ignored parts.
[[nodiscard]] std::uint64_t bulk_bytes(const Submit& submit);

/// The bytes of a part of a job's poses and their labels.
[[nodiscard]] std::uint64_t bulk_bytes(const PosesPart& part);

/// Frees the memory that a job needs no more when it has ended: its ignored parts, and a grid over
/// `limits::ended_grid_bytes_max`, of which empty bytes are left. Returns whether the job's
/// scenarios can be run no more without what was freed.
bool drop_bulk(Submit& submit);

} // namespace cd
