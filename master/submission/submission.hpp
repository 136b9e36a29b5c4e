// Validates a client's submission before any of it is stored.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Checks all fields. `stored`: the meshes that the master has. Errors: BadInput, TooLarge and
/// NotFound, naming the field and the allowed values.
[[nodiscard]] Status check_submission(const Submit& submit, std::span<const MeshStatus> stored);

/// Checks that the priority is in its range. Errors: BadInput.
[[nodiscard]] Status check_priority(std::int32_t priority);

[[nodiscard]] std::vector<Sha256> meshes_of(const Submit& submit);

/// Returns the bytes of a submission's potentially large fields: the grid and the ignored parts.
[[nodiscard]] std::uint64_t bulk_bytes(const Submit& submit);

/// Returns the bytes of an uploaded part of a job's poses and labels.
[[nodiscard]] std::uint64_t bulk_bytes(const PosesPart& part);

/// Frees the large fields of an ended job: the ignored parts, and a grid over
/// `limits::ended_grid_bytes_max`, which becomes empty. Returns true if this dropped data without
/// which the job's scenarios cannot run again.
bool drop_bulk(Submit& submit);

} // namespace cd
