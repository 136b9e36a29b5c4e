#include "worker/execution/scenario_clock.hpp"

#include <algorithm>

namespace cd {

std::shared_ptr<ScenarioClock> RunningClocks::add(JobId job) {
    std::erase_if(clocks_, [](const auto& clock) { return clock.expired(); });
    auto clock = std::make_shared<ScenarioClock>(job);
    clocks_.push_back(clock);
    return clock;
}

std::optional<RunningScenario> RunningClocks::longest() const {
    std::optional<RunningScenario> longest;
    const auto now = ScenarioClock::Time::now();
    for (const auto& weak : clocks_) {
        const auto clock = weak.lock();
        const auto since = clock == nullptr ? std::nullopt : clock->since();
        if (!since) {
            continue;
        }
        const double seconds = std::chrono::duration<double>(now - *since).count();
        if (!longest || seconds > longest->seconds) {
            longest = RunningScenario{clock->job(), clock->scenario(), std::max(0.0, seconds)};
        }
    }
    return longest;
}

} // namespace cd
