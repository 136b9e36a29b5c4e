// Alarms and quarantined workers, as the journal keeps them across restarts of the master.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "master/journal/result_group.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cd {

struct AlarmRecord {
    std::uint64_t count = 0;             ///< Number of alarms ever raised.
    std::vector<std::string> last;       ///< The last alarms, oldest first.
    std::vector<InstanceId> quarantined; ///< Processes that gave a wrong result, oldest first.

    /// Adds an alarm. Forgets the oldest one beyond `limits::alarms_kept_max`.
    void add(const std::string& text);
    /// Adds a process. Forgets the oldest one beyond `limits::quarantined_kept_max`.
    void quarantine(InstanceId process);

    friend bool operator==(const AlarmRecord&, const AlarmRecord&) = default;
};

[[nodiscard]] Bytes encode_alarms(const AlarmRecord& alarms);
/// Errors: BadFrame for damaged bytes.
[[nodiscard]] Result<AlarmRecord> decode_alarms(std::span<const std::byte> bytes);

} // namespace cd
