// Decides when a worker leaves by itself: after a time without work, or without a master.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace cd {

/// Why a worker leaves without a signal.
enum class Leave {
    Not,      ///< It stays.
    Idle,     ///< It had a master and no work.
    Orphaned, ///< It had no master.
};

/// Time limits, at least a second each, after which a worker leaves. Without them it stays.
struct LeaveLimits {
    std::optional<std::chrono::seconds> idle;     ///< Without work.
    std::optional<std::chrono::seconds> orphaned; ///< Without a master.
};

/// The state of a worker at one moment.
struct WorkerMoment {
    bool has_master = false;
    bool has_work = false;                ///< Tasks, or results that no master has acknowledged.
    std::uint64_t scenarios_computed = 0; ///< Since the start of the process.
};

/// Measures both times from observations of the worker. Without a master the idle time stands
/// still, since a master that restarts may have work; work sets it to zero. The orphan time begins
/// when a master is lost: before the first master, --connect-for applies.
class LeaveRule {
  public:
    using Time = std::chrono::steady_clock::time_point;

    explicit LeaveRule(const LeaveLimits& limits) : limits_(limits) {}

    [[nodiscard]] bool is_off() const { return !limits_.idle && !limits_.orphaned; }
    /// Adds the time since the last observation, and tells whether the worker leaves now.
    [[nodiscard]] Leave observe(const WorkerMoment& moment, Time now);

  private:
    LeaveLimits limits_;
    WorkerMoment last_;
    Time last_time_{};
    bool had_master_ = false;
    std::chrono::steady_clock::duration idle_{};
    std::chrono::steady_clock::duration orphaned_{};
};

} // namespace cd
