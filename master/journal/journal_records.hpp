// Encodes and decodes a job's rows in the journal: the accepted job, its progress, and its end.
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

/// An accepted job: its id, the client's submission, and the time.
struct JobRecord {
    JobId id;
    Submit submit;
    std::uint64_t began = 0; ///< Time of the acceptance, in seconds since 1970.
};

/// Scenarios recalled or copied at a job's end (docs/job-end.md).
struct HelpAtEnd {
    std::uint64_t recalled = 0;   ///< Scenarios that workers returned before beginning them.
    std::uint64_t copies = 0;     ///< Scenarios sent to a second worker as speculative copies.
    std::uint64_t copies_won = 0; ///< Speculative copies that gave the result first.

    friend bool operator==(const HelpAtEnd&, const HelpAtEnd&) = default;
};

/// Measurements that a job's status shows in addition to its results.
struct JobProgress {
    double seconds = 0; ///< Run time, summed over all runs of the master.
    std::uint64_t answered_by_master = 0;
    JobStatistics statistics;
    double compute_seconds = 0;
    JobTraffic traffic;
    HelpAtEnd help;
    /// Depth of each body's cut; empty before the geometry is prepared.
    std::vector<std::uint32_t> depths;
    std::string map_withdrawn; ///< Reason why the job's map is unusable; empty if it is valid.
};

/// The end of a job.
struct JobEnd {
    JobState state = JobState::Done; ///< Any state but Running.
    std::string failure;             ///< Reason of a failed or cancelled job.
    std::optional<Sha256> digest;    ///< Digest over all results; set if the job is done.
    std::uint64_t ended = 0;         ///< Time of the end, in seconds since 1970.
};

// The journal does not use the protocol's encodings, so that the protocol can change without it.
[[nodiscard]] Bytes encode_job(const JobRecord& job);
[[nodiscard]] Bytes encode_progress(const JobProgress& progress);
[[nodiscard]] Bytes encode_end(const JobEnd& end);

// Inverses of the functions above. Errors: BadFrame for invalid bytes, which are due to damage.
[[nodiscard]] Result<JobRecord> decode_job(std::span<const std::byte> bytes);
[[nodiscard]] Result<JobProgress> decode_progress(std::span<const std::byte> bytes);
[[nodiscard]] Result<JobEnd> decode_end(std::span<const std::byte> bytes);

} // namespace cd
