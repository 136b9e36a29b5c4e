// The progress of one call, and whether its caller has stopped it.
#pragma once

#include "common/job/result/merge.hpp"
#include "library/include/cdcluster/cdcluster.hpp"

#include <chrono>
#include <functional>
#include <utility>

namespace cdcluster {

/// Calls a caller's `progress` on the calling thread, at most every 50 milliseconds.
class CallClock {
  public:
    explicit CallClock(std::function<bool(const Progress&)> progress)
        : progress_(std::move(progress)) {}

    void restart() { start_ = told_ = Clock::now(); }
    [[nodiscard]] std::chrono::steady_clock::duration elapsed() const {
        return Clock::now() - start_;
    }

    /// Tells the progress if it is time.
    void tell(const cd::Summary& summary) {
        constexpr auto period = std::chrono::milliseconds(50);
        if (!progress_ || is_stopped_ || Clock::now() - told_ < period) {
            return;
        }
        told_ = Clock::now();
        is_stopped_ = !progress_(
            {summary.merged(), summary.total, std::chrono::duration<double>(elapsed()).count()});
    }
    [[nodiscard]] bool was_stopped() const { return is_stopped_; }
    /// Tells the progress if it is time, and whether the caller stops the call.
    [[nodiscard]] bool is_stopped(const cd::Summary& summary) {
        tell(summary);
        return is_stopped_;
    }

  private:
    using Clock = std::chrono::steady_clock;

    std::function<bool(const Progress&)> progress_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point told_ = start_;
    bool is_stopped_ = false;
};

} // namespace cdcluster
