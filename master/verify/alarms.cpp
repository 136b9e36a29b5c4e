#include "master/verify/alarms.hpp"

#include "common/core/host/log.hpp"

namespace cd {

void Alarms::restore(AlarmRecord record) {
    record_ = std::move(record);
    quarantined_ = {record_.quarantined.begin(), record_.quarantined.end()};
}

void Alarms::raise(const std::string& text) {
    log_critical("ALARM: {}", text);
    record_.add(text);
    is_changed_ = true;
}

bool Alarms::quarantine(InstanceId process) {
    if (process == 0 || is_quarantined(process)) {
        return false;
    }
    record_.quarantine(process);
    quarantined_ = {record_.quarantined.begin(), record_.quarantined.end()};
    is_changed_ = true;
    return true;
}

std::optional<AlarmRecord> Alarms::take_changed() {
    return std::exchange(is_changed_, false) ? std::optional(record_) : std::nullopt;
}

} // namespace cd
