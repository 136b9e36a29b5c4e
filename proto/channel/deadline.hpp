// Ends a wait for the network when its time is up.
#pragma once

#include "common/core/limits/wire.hpp"
#include "proto/channel/asio.hpp"

#include <chrono>
#include <memory>

namespace cd {

/// While alive, cancels the pending operations of a socket or resolver once the time is up, and
/// soon after whatever is begun then: what is composed of many may be between two of them. Both and
/// their coroutine share one thread.
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
            // An expiry already queued is delivered even after the owner is gone.
            if (state->target == nullptr) {
                return;
            }
            state->expired = true;
            state->target->cancel();
            state->timer.expires_after(limits::overdue_check_period);
            watch(state);
        });
    }

    std::shared_ptr<State> state_; ///< Shared with what waits for the timer.
};

} // namespace cd
