// Job ids for people: "j-4f2a".
#pragma once

#include "common/core/id.hpp"
#include "common/core/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Returns "j-" and the first hexadecimal digits of a mixed job number: four, or enough to differ
/// from all `others`. Consecutive jobs get dissimilar ids.
[[nodiscard]] std::string job_id_text(JobId job, std::span<const JobId> others = {});

/// Finds a job by its id, by a unique prefix of the id (with or without "j-"), or by its plain
/// number. Errors: NotFound, also for an invalid id; BadInput naming all ids with that prefix.
[[nodiscard]] Result<JobId> find_job(std::string_view text, std::span<const JobId> jobs);

[[nodiscard]] std::vector<JobId> ids_of(std::span<const JobStatus> jobs);

/// Finds a job by its id, or by "last": the newest job of `owner`. Errors: NotFound; BadInput
/// naming all ids that begin with `text`.
[[nodiscard]] Result<JobId>
find_job(std::string_view text, std::span<const JobStatus> jobs, std::string_view owner);

} // namespace cd
