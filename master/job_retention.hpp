// How long jobs are kept that have ended.
#pragma once

#include "common/core/limits.hpp"
#include "common/core/result.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace cd {

/// What --keep-jobs says: so many jobs that have ended, or those that ended within a time.
struct JobRetention {
    std::size_t count = limits::jobs_ended_kept_max;
    std::optional<std::chrono::seconds> age = {};

    /// Whether a job is kept no longer that ended `ended` seconds after 1970 and asked to be kept
    /// for `wished` seconds, 0 being no wish. A wish makes the time shorter, never longer.
    [[nodiscard]] bool is_over(std::uint64_t ended, std::uint64_t wished, std::uint64_t now) const;
};

/// A number of jobs ("1000"), or a time ("30d", "12h"). Errors: BadInput saying what it may be.
[[nodiscard]] Result<JobRetention> parse_retention(const std::string& text);

} // namespace cd
