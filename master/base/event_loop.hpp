// The event loop on the coordinator's thread: tells the time, and calls functions soon or later.
#pragma once

#include "proto/channel/asio.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <set>

namespace cd {

/// Calls functions on one thread, the loop's thread. Unless stated otherwise, members run on it.
class EventLoop {
  public:
    using Time = std::chrono::steady_clock::time_point;
    using Duration = std::chrono::steady_clock::duration;

    EventLoop() = default;
    EventLoop(const EventLoop&) = delete;
    EventLoop& operator=(const EventLoop&) = delete;
    virtual ~EventLoop() = default;

    [[nodiscard]] virtual Time now() const = 0;
    /// Calls `function` soon, but not within this call. Any thread.
    virtual void post(std::function<void()> function) = 0;
    /// Calls `function` after `delay`, unless `close` is called before.
    virtual void after(Duration delay, std::function<void()> function) = 0;
    /// Drops all functions that wait for a delay. Later calls of `after` do nothing.
    virtual void close() = 0;
};

/// An event loop on an Asio executor with one thread, in real time.
class AsioLoop final : public EventLoop {
  public:
    explicit AsioLoop(asio::any_io_executor executor) : executor_(std::move(executor)) {}
    ~AsioLoop() override { AsioLoop::close(); }

    [[nodiscard]] Time now() const override { return std::chrono::steady_clock::now(); }
    void post(std::function<void()> function) override {
        asio::post(executor_, std::move(function));
    }
    void after(Duration delay, std::function<void()> function) override;
    void close() override;

  private:
    using Timer = std::shared_ptr<asio::steady_timer>;

    asio::any_io_executor executor_;
    std::shared_ptr<std::set<Timer>> running_ = std::make_shared<std::set<Timer>>();
    bool is_closed_ = false;
};

} // namespace cd
