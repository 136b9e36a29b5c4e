// What somebody has to look at, and who is trusted no more: what outlives the master of it.
#pragma once

#include "common/core/bytes.hpp"
#include "common/core/result.hpp"
#include "master/result_group.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cd {

struct AlarmRecord {
    std::uint64_t count = 0;                ///< Of all alarms that there ever were.
    std::vector<std::string> last;          ///< Of them, oldest first.
    std::vector<WorkerProcess> quarantined; ///< A result of theirs was wrong. Oldest first.

    /// The oldest of too many is forgotten.
    void add(const std::string& text);
    void quarantine(WorkerProcess process);

    friend bool operator==(const AlarmRecord&, const AlarmRecord&) = default;
};

[[nodiscard]] Bytes encode_alarms(const AlarmRecord& alarms);
/// Errors: BadFrame for bytes that are none, which only damage can make of them.
[[nodiscard]] Result<AlarmRecord> decode_alarms(std::span<const std::byte> bytes);

} // namespace cd
