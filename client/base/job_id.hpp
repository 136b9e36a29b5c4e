// How people write the id of a job: "j-4f2a".
#pragma once

#include "common/core/id.hpp"
#include "common/core/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// "j-" and the first hexadecimal digits of a number that stands for the job: four, or as many as
/// tell it from each other job of `others`. Jobs that follow one another look unlike.
[[nodiscard]] std::string job_id_text(JobId job, std::span<const JobId> others = {});

/// The job among `jobs` that is meant by its id, by any beginning of it that no other shares (with
/// or without "j-"), or by its plain number. Errors: NotFound, also when `text` is no id; BadInput
/// naming the ids that begin so.
[[nodiscard]] Result<JobId> find_job(std::string_view text, std::span<const JobId> jobs);

[[nodiscard]] std::vector<JobId> ids_of(std::span<const JobStatus> jobs);

/// Finds a job by its id, or by `last`: the newest job of this owner. Errors: those of `find_job`
/// above.
[[nodiscard]] Result<JobId>
find_job(std::string_view text, std::span<const JobStatus> jobs, std::string_view owner);

} // namespace cd
