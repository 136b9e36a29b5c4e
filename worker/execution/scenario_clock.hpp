// Records which scenario each thread runs and when it started.
#pragma once

#include "proto/messages/session_messages.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>

namespace cd {

/// The clock of one function that runs scenarios of one job one by one on a pool thread. The pool
/// thread writes; any thread may read.
class ScenarioClock {
  public:
    using Time = std::chrono::steady_clock;

    explicit ScenarioClock(JobId job) : job_(job) {}

    void begin(std::uint64_t scenario) {
        since_.store(none);
        scenario_.store(scenario);
        since_.store(Time::now().time_since_epoch().count());
    }
    void end() { since_.store(none); }

    [[nodiscard]] JobId job() const { return job_; }
    [[nodiscard]] std::uint64_t scenario() const { return scenario_.load(); }
    /// Start of the running scenario; empty if no scenario runs.
    [[nodiscard]] std::optional<Time::time_point> since() const {
        const Time::rep since = since_.load();
        return since == none ? std::nullopt
                             : std::optional(Time::time_point(Time::duration(since)));
    }

  private:
    static constexpr Time::rep none = -1;

    JobId job_;
    std::atomic<std::uint64_t> scenario_ = 0;
    std::atomic<Time::rep> since_ = none;
};

/// The clocks of all functions that pool threads run or will run. Each function owns its clock.
class RunningClocks {
  public:
    [[nodiscard]] std::shared_ptr<ScenarioClock> add(JobId job);
    /// The scenario that has run for the longest time; empty if no scenario runs.
    [[nodiscard]] std::optional<RunningScenario> longest() const;

  private:
    std::list<std::weak_ptr<const ScenarioClock>> clocks_;
};

} // namespace cd
