// Alarms and quarantined worker processes of the cluster.
#pragma once

#include "master/journal/alarm_record.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace cd {

/// Holds the alarms and the quarantine, which the journal keeps across restarts of the master.
class Alarms {
  public:
    void restore(AlarmRecord record);

    /// Raises an alarm: logs it and adds it to the record.
    void raise(const std::string& text);
    /// Puts the process into quarantine. False if it is there already, or is the master (0).
    bool quarantine(InstanceId process);

    [[nodiscard]] bool is_quarantined(InstanceId process) const {
        return quarantined_.contains(process);
    }
    [[nodiscard]] const std::set<InstanceId>& quarantined() const { return quarantined_; }
    [[nodiscard]] const AlarmRecord& record() const { return record_; }
    /// The record if it has changed since the last call, else empty. The caller must write it to
    /// the journal.
    [[nodiscard]] std::optional<AlarmRecord> take_changed();

  private:
    AlarmRecord record_;
    std::set<InstanceId> quarantined_; ///< `record_.quarantined` as a set.
    bool is_changed_ = false;
};

} // namespace cd
