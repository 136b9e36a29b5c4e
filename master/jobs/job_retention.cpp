#include "master/jobs/job_retention.hpp"

#include "common/core/duration.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <charconv>

namespace cd {

bool JobRetention::is_over(std::uint64_t ended, std::uint64_t wished, std::uint64_t now) const {
    const auto kept = age ? static_cast<std::uint64_t>(age->count()) : wished;
    const std::uint64_t seconds = wished == 0 ? kept : std::min(kept, wished);
    return seconds != 0 && now > ended && now - ended > seconds;
}

Result<JobRetention> parse_retention(const std::string& text) {
    std::size_t count = 0;
    const char* const end = text.data() + text.size();
    const auto [read, error] = std::from_chars(text.data(), end, count);
    if (error == std::errc() && read == end && count >= 1 && count <= limits::jobs_kept_max) {
        return JobRetention{count, std::nullopt};
    }
    const Result<std::chrono::seconds> age = parse_duration(text);
    if (!age || age.value() <= std::chrono::seconds(0)) {
        return Error{ErrorCode::BadInput,
                     "'" + text + "' is neither a number of jobs, 1 to " +
                         std::to_string(limits::jobs_kept_max) + ", nor a time such as 30d"};
    }
    return JobRetention{limits::jobs_kept_max, age.value()};
}

} // namespace cd
