// How long a worker tries again while TLS refuses it or its master.
#pragma once

#include "common/core/limits/worker.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

namespace cd {

/// A worker that a master accepted before tries again for `limits::refusal_retry_max` after a
/// refusal by TLS: a clock may be wrong, or a bit may have flipped on the way. One that no master
/// has accepted does not.
class RefusalPatience {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// A master accepted the worker: refusals before count no more.
    void accepted() {
        was_accepted_ = true;
        since_.reset();
    }
    [[nodiscard]] bool was_accepted() const { return was_accepted_; }

    /// TLS refused. Returns how long the worker goes on to try; zero: it ends.
    [[nodiscard]] std::chrono::steady_clock::duration refused(Time now) {
        since_ = since_.value_or(now);
        const std::chrono::steady_clock::duration left =
            limits::refusal_retry_max - (now - *since_);
        return was_accepted_ ? std::max(left, {}) : std::chrono::steady_clock::duration::zero();
    }

  private:
    bool was_accepted_ = false;
    std::optional<Time> since_; ///< The first refusal after the last acceptance.
};

} // namespace cd
