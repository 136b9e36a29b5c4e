// A time limit for network operations.
#pragma once

#include "common/core/timing/wire.hpp"
#include "proto/channel/asio.hpp"

#include <chrono>
#include <memory>

namespace cd {

/// While alive, cancels the pending operations of a socket or resolver at the timeout, and again
/// periodically, because a composed operation may be between two steps. Target, deadline and
/// coroutine must run on one thread.
template <class Cancellable>
class Deadline {
  public:
    Deadline(Cancellable& target, std::chrono::steady_clock::duration timeout)
        : state_(std::make_shared<State>(target)) {
        state_->timer.expires_after(timeout);
        watch(state_);
    }

    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;
    ~Deadline() {
        state_->target = nullptr;
        state_->timer.cancel();
    }

    [[nodiscard]] bool expired() const { return state_->expired; }

  private:
    struct State {
        explicit State(Cancellable& what) : target(&what), timer(what.get_executor()) {}

        Cancellable* target;
        asio::steady_timer timer;
        bool expired = false;
    };

    static void watch(const std::shared_ptr<State>& state) {
        state->timer.async_wait([state](const boost::system::error_code&) {
            // A queued handler runs even after the deadline is destroyed.
            if (state->target == nullptr) {
                return;
            }
            state->expired = true;
            state->target->cancel();
            state->timer.expires_after(timing::overdue_check_period);
            watch(state);
        });
    }

    std::shared_ptr<State> state_; ///< Shared with the timer's handler.
};

} // namespace cd
