// Checks what a client submits, before anything is kept of it.
#pragma once

#include "common/core/result.hpp"
#include "proto/client_messages.hpp"

#include <span>
#include <vector>

namespace cd {

/// `stored` are the meshes that the master has. Errors: BadInput, TooLarge and NotFound, naming the
/// field and what it may be.
[[nodiscard]] Status check_submission(const Submit& submit, std::span<const MeshStatus> stored);

[[nodiscard]] std::vector<Sha256> meshes_of(const Submit& submit);

/// What it takes beside its name: of a grid, and of parts that are ignored.
[[nodiscard]] std::uint64_t bulk_bytes(const Submit& submit);

/// What a part of its poses takes.
[[nodiscard]] std::uint64_t bulk_bytes(const PosesPart& part);

/// Of a job that has ended: what nothing needs any more goes, and a large grid, which only explains
/// scenarios. Of that one empty bytes are left. True: something went without which they cannot be
/// run.
bool drop_bulk(Submit& submit);

} // namespace cd
