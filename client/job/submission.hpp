// Converts a job to a submission for a master, and a submission to a job.
#pragma once

#include "client/job/prepared_job.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace cd {

/// Describes a body for a master or a manifest. Its unit is the one given in the job, else the one
/// that the mesh file declares, else the job's.
[[nodiscard]] JobBody body_of(const PreparedJob& job, std::size_t body);

/// Returns the mesh file of a body, which has this number in the job.
[[nodiscard]] BodySpec spec_of(const JobBody& body, std::size_t number);

/// Converts a job to a submission. Names are escaped, since they may be file names.
[[nodiscard]] Submit submission_of(const PreparedJob& job);

/// Returns what a scene's job has besides its meshes and poses. `bodies` and `steps`, packed, come
/// from a submission or a results folder of so many scenarios. Errors: as `unpack_steps`.
[[nodiscard]] Result<JobScene> scene_of(std::span<const JobBody> bodies,
                                        std::span<const std::byte> steps,
                                        std::uint64_t scenarios,
                                        const Sha256& head);

/// Converts a submission to a job without output; names stay escaped. Errors: BadFrame if there are
/// other than two bodies and no scene; also for an invalid grid; BadInput for a scene whose job
/// file cannot be read.
[[nodiscard]] Result<JobSpec> spec_of(const Submit& submit);

} // namespace cd
