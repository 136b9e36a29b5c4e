// Calls functions after a delay.
#pragma once

#include "proto/channel/asio.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <set>

namespace cd {

/// All members run on the executor's thread.
class Timers {
  public:
    explicit Timers(asio::any_io_executor executor) : executor_(std::move(executor)) {}
    Timers(const Timers&) = delete;
    Timers& operator=(const Timers&) = delete;
    ~Timers() { close(); }

    /// Calls `function` after `delay`, unless `close` is called before.
    void after(std::chrono::steady_clock::duration delay, std::function<void()> function);
    /// Drops all waiting functions. Later calls of `after` do nothing.
    void close();

  private:
    using Timer = std::shared_ptr<asio::steady_timer>;

    asio::any_io_executor executor_;
    std::shared_ptr<std::set<Timer>> running_ = std::make_shared<std::set<Timer>>();
    bool is_closed_ = false;
};

} // namespace cd
