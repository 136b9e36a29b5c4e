// Validates a client's submission before any of it is stored.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <span>
#include <vector>

namespace cd {

/// `stored` are the meshes that the master has. Errors: BadInput, TooLarge and NotFound, naming the
/// field and the allowed values.
[[nodiscard]] Status check_submission(const Submit& submit, std::span<const MeshStatus> stored);

[[nodiscard]] std::vector<Sha256> meshes_of(const Submit& submit);

/// Returns the bytes of the potentially large fields: the grid and the ignored parts.
[[nodiscard]] std::uint64_t bulk_bytes(const Submit& submit);

/// Returns the bytes of a part of a job's poses and labels.
[[nodiscard]] std::uint64_t bulk_bytes(const PosesPart& part);

/// Frees memory that an ended job needs no more: its ignored parts, and a grid over
/// `limits::ended_grid_bytes_max`, which is left empty. Returns whether the job's scenarios can no
/// longer be run as a result.
bool drop_bulk(Submit& submit);

} // namespace cd
