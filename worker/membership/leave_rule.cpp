#include "worker/membership/leave_rule.hpp"

#include <utility>

namespace cd {

Leave LeaveRule::observe(const WorkerMoment& moment, Time now) {
    const WorkerMoment before = std::exchange(last_, moment);
    const auto passed = now - std::exchange(last_time_, now);
    // A task may begin and end between two observations; then scenarios were computed.
    const bool has_worked = moment.has_work || before.has_work ||
                            moment.scenarios_computed != before.scenarios_computed;
    if (has_worked) {
        idle_ = {};
    } else if (moment.has_master && before.has_master) {
        idle_ += passed;
    }
    if (moment.has_master || !had_master_) {
        orphaned_ = {};
    } else if (!before.has_master) {
        orphaned_ += passed;
    }
    had_master_ = had_master_ || moment.has_master;
    if (limits_.orphaned && orphaned_ >= *limits_.orphaned) {
        return Leave::Orphaned;
    }
    const bool is_due = limits_.idle && idle_ >= *limits_.idle;
    return is_due && moment.has_master ? Leave::Idle : Leave::Not;
}

} // namespace cd
