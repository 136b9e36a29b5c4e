// What the journal keeps of jobs, as bytes that are checked when they come back.
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

/// A job as it was accepted.
struct JobRecord {
    JobId id;
    Submit submit;
    std::uint64_t began = 0; ///< When it was accepted, in seconds since 1970.
};

/// Scenarios that were recalled or copied at a job's end (ARCHITECTURE.md, how a job ends).
struct HelpAtEnd {
    std::uint64_t recalled = 0;   ///< Given back by workers that had not begun them.
    std::uint64_t copies = 0;     ///< Sent to a second worker, beside the first,
    std::uint64_t copies_won = 0; ///< and answered by that one first.

    friend bool operator==(const HelpAtEnd&, const HelpAtEnd&) = default;
};

/// What a status tells of a job beside its results.
struct JobProgress {
    double seconds = 0; ///< That it has run, in all lives of the master.
    std::uint64_t answered_by_master = 0;
    JobStatistics statistics;
    double compute_seconds = 0;
    JobTraffic traffic;
    HelpAtEnd help;
    std::vector<std::uint32_t> depths; ///< By body; empty before its geometry is prepared.
    std::string map_withdrawn;         ///< Why the job's map is not to be used; else empty.
};

/// How a job ended.
struct JobEnd {
    JobState state = JobState::Done;
    std::string failure;
    std::optional<Sha256> digest;
    std::uint64_t ended = 0; ///< When, in seconds since 1970.
};

/// Not the protocol's form of it, which may change from version to version.
[[nodiscard]] Bytes encode_job(const JobRecord& job);
[[nodiscard]] Bytes encode_progress(const JobProgress& progress);
[[nodiscard]] Bytes encode_end(const JobEnd& end);

// The inverses. Errors: BadFrame for bytes that are none, which only damage can make of them.
[[nodiscard]] Result<JobRecord> decode_job(std::span<const std::byte> bytes);
[[nodiscard]] Result<JobProgress> decode_progress(std::span<const std::byte> bytes);
[[nodiscard]] Result<JobEnd> decode_end(std::span<const std::byte> bytes);

} // namespace cd
