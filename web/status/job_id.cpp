#include "web/status/job_id.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace cd {

namespace {

constexpr std::size_t digits_min = 4;
constexpr std::string_view prefix = "j-";

/// Returns all sixteen hexadecimal digits of an id: the job's number, mixed by the finalizer of
/// SplitMix64 (Steele, Lea, Flood, 2014), which is bijective.
std::string digits_of(JobId job) {
    std::uint64_t mixed = job.value;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111eb;
    mixed ^= mixed >> 31;
    return fmt::format("{:016x}", mixed);
}

std::size_t common_length(std::string_view left, std::string_view right) {
    const auto [end, other] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
    return static_cast<std::size_t>(end - left.begin());
}

Error ambiguous(std::string_view text, std::span<const JobId> found, std::span<const JobId> jobs) {
    std::string names;
    for (const JobId job : found.first(std::min<std::size_t>(found.size(), 5))) {
        names += (names.empty() ? "" : ", ") + job_id_text(job, jobs);
    }
    return bad_input("more than one job begins with '" + std::string(text) + "': " + names);
}

} // namespace

std::string job_id_text(JobId job, std::span<const JobId> others) {
    const std::string digits = digits_of(job);
    std::size_t needed = digits_min;
    for (const JobId other : others) {
        if (other != job) {
            needed = std::max(needed, common_length(digits, digits_of(other)) + 1);
        }
    }
    return std::string(prefix) + digits.substr(0, needed);
}

Result<JobId> find_job(std::string_view text, std::span<const JobId> jobs) {
    const bool has_prefix = text.starts_with(prefix);
    const auto number = has_prefix ? std::nullopt : number_in<std::uint64_t>(text);
    if (number && std::ranges::find(jobs, JobId{*number}) != jobs.end()) {
        return JobId{*number};
    }
    const std::string_view digits = has_prefix ? text.substr(prefix.size()) : text;
    std::vector<JobId> found;
    for (const JobId job : jobs) {
        if (!digits.empty() && digits_of(job).starts_with(digits)) {
            found.push_back(job);
        }
    }
    if (found.size() > 1) {
        return ambiguous(text, found, jobs);
    }
    if (found.empty()) {
        return Error{ErrorCode::NotFound,
                     "the master has no job '" + std::string(text) + "'; see `cdctl get jobs`"};
    }
    return found.front();
}

std::vector<JobId> ids_of(std::span<const JobStatus> jobs) {
    std::vector<JobId> ids;
    for (const JobStatus& job : jobs) {
        ids.push_back(job.job);
    }
    return ids;
}

Result<JobId>
find_job(std::string_view text, std::span<const JobStatus> jobs, std::string_view owner) {
    if (text != "last") {
        return find_job(text, ids_of(jobs));
    }
    std::optional<JobId> last;
    for (const JobStatus& job : jobs) {
        if (job.turn.owner == owner && (!last || *last < job.job)) {
            last = job.job;
        }
    }
    if (!last) {
        return Error{ErrorCode::NotFound, "the master has no job of '" + std::string(owner) + "'"};
    }
    return *last;
}

} // namespace cd
