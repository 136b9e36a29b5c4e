// Decides how long a worker retries while TLS refuses the worker or its master.
#pragma once

#include "common/core/timing/worker.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

namespace cd {

/// After a TLS refusal, a worker that a master has accepted before retries for
/// `timing::refusal_retry_max`: a clock may be wrong, or a bit may have flipped in transit. A
/// worker that was never accepted does not retry.
class RefusalPatience {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Records that a master accepted the worker, and forgets earlier refusals.
    void accepted() {
        was_accepted_ = true;
        since_.reset();
    }
    [[nodiscard]] bool was_accepted() const { return was_accepted_; }

    /// Records a TLS refusal. Returns how long the worker may still retry; zero: the worker ends.
    [[nodiscard]] std::chrono::steady_clock::duration refused(Time now) {
        since_ = since_.value_or(now);
        const std::chrono::steady_clock::duration left =
            timing::refusal_retry_max - (now - *since_);
        return was_accepted_ ? std::max(left, {}) : std::chrono::steady_clock::duration::zero();
    }

  private:
    bool was_accepted_ = false;
    std::optional<Time> since_; ///< Time of the first refusal after the last acceptance.
};

} // namespace cd
