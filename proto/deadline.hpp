// Ends a wait for the network when its time is up.
#pragma once

#include "proto/asio.hpp"

#include <chrono>
#include <memory>

namespace cd {

/// While alive, cancels the pending operations of a socket or resolver once the time is up. Both
/// and their coroutine share one thread.
template <class Cancellable>
class Deadline {
  public:
    Deadline(Cancellable& target, std::chrono::steady_clock::duration timeout)
        : state_(std::make_shared<State>()), timer_(target.get_executor(), timeout) {
        state_->target = &target;
        timer_.async_wait([state = state_](const boost::system::error_code&) {
            // An expiry already queued is delivered even after the timer is gone.
            if (state->target != nullptr) {
                state->expired = true;
                state->target->cancel();
            }
        });
    }

    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;
    ~Deadline() { state_->target = nullptr; }

    [[nodiscard]] bool expired() const { return state_->expired; }

  private:
    struct State {
        Cancellable* target = nullptr;
        bool expired = false;
    };

    std::shared_ptr<State> state_;
    asio::steady_timer timer_;
};

} // namespace cd
