// Decides how long the master keeps ended jobs.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace cd {

/// The option --keep-jobs: keeps the last `count` ended jobs, each at most for `age` if that is
/// set.
struct JobRetention {
    std::size_t count = limits::jobs_ended_kept_max;
    std::optional<std::chrono::seconds> age = {};

    /// Returns whether a job's retention is over at `now`. The job ended at `ended` and asked to be
    /// kept for `wished` seconds (0: no wish); a wish only shortens the time. `ended` and `now` are
    /// in seconds since 1970.
    [[nodiscard]] bool is_over(std::uint64_t ended, std::uint64_t wished, std::uint64_t now) const;
};

/// Parses a number of jobs ("1000") or a time ("30d", "12h"). Errors: BadInput with the allowed
/// values.
[[nodiscard]] Result<JobRetention> parse_retention(const std::string& text);

} // namespace cd
