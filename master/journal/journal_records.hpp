// Encodes what the journal keeps of a job, and validates it when reading.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/job/statistics.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/traffic.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// A job as accepted.
struct JobRecord {
    JobId id;
    Submit submit;
    std::uint64_t began = 0; ///< When it was accepted, in seconds since 1970.
};

/// Scenarios recalled or copied at a job's end (docs/job-end.md).
struct HelpAtEnd {
    std::uint64_t recalled = 0;   ///< Returned by workers that had not begun them.
    std::uint64_t copies = 0;     ///< Sent to a second worker as speculative copies.
    std::uint64_t copies_won = 0; ///< Speculative copies that answered first.

    friend bool operator==(const HelpAtEnd&, const HelpAtEnd&) = default;
};

/// What a job's status reports beside its results.
struct JobProgress {
    double seconds = 0; ///< Run time in all incarnations of the master.
    std::uint64_t answered_by_master = 0;
    JobStatistics statistics;
    double compute_seconds = 0;
    JobTraffic traffic;
    HelpAtEnd help;
    /// Depth of each body's cut; empty before the geometry is prepared.
    std::vector<std::uint32_t> depths;
    std::string map_withdrawn; ///< Why the job's map is unusable; empty if it is valid.
};

/// How a job ended.
struct JobEnd {
    JobState state = JobState::Done;
    std::string failure;
    std::optional<Sha256> digest;
    std::uint64_t ended = 0; ///< Seconds since 1970.
};

/// Differs from the protocol's encoding, which may change between versions.
[[nodiscard]] Bytes encode_job(const JobRecord& job);
[[nodiscard]] Bytes encode_progress(const JobProgress& progress);
[[nodiscard]] Bytes encode_end(const JobEnd& end);

// Inverses of the functions above. Errors: BadFrame for invalid bytes, which only damage can cause.
[[nodiscard]] Result<JobRecord> decode_job(std::span<const std::byte> bytes);
[[nodiscard]] Result<JobProgress> decode_progress(std::span<const std::byte> bytes);
[[nodiscard]] Result<JobEnd> decode_end(std::span<const std::byte> bytes);

} // namespace cd
