// Gives the dispatcher the time, and performs its actions in order.
#pragma once

#include "master/dispatch/dispatcher.hpp"

#include <deque>
#include <functional>
#include <utility>

namespace cd {

/// Use: `driver.act(driver->worker_lost(worker))`.
class DispatchDriver {
  public:
    /// `now` returns seconds since a fixed point in time. `perform` may cause further actions.
    DispatchDriver(std::function<double()> now,
                   std::function<void(const Action&)> perform,
                   const DispatcherOptions& options = {})
        : now_(std::move(now)), perform_(std::move(perform)), dispatcher_(options) {}

    /// Sets the dispatcher's time to now, and returns the dispatcher, for one event.
    Dispatcher* operator->() {
        dispatcher_.time_is(now_());
        return &dispatcher_;
    }
    [[nodiscard]] const DispatchView& view() const { return dispatcher_; }
    /// Performs the actions, and then the actions that these cause.
    void act(Actions actions);
    /// True if no action is being performed or waits.
    [[nodiscard]] bool is_idle() const { return !is_acting_ && actions_.empty(); }

  private:
    std::function<double()> now_;
    std::function<void(const Action&)> perform_;
    Dispatcher dispatcher_;
    std::deque<Action> actions_;
    bool is_acting_ = false;
};

} // namespace cd
