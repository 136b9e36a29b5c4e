// The state that the parts of a session share: its threads, its end, and its link to the master.
#pragma once

#include "proto/codec/message.hpp"
#include "worker/execution/executor.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>

namespace cd {

/// The connection to the master, as the parts of a session see it.
class MasterLink {
  public:
    MasterLink() = default;
    MasterLink(const MasterLink&) = delete;
    MasterLink& operator=(const MasterLink&) = delete;
    virtual ~MasterLink() = default;

    /// Sends a message; does nothing without a connection.
    virtual void send(const Message& message) = 0;
    /// Sends results, and keeps them until the master acknowledges them.
    virtual void send_results(Results results) = 0;
    /// Whether a scenario may begin: the unsent and the unacknowledged results are within their
    /// bounds. If false, the session settles again once the answer may have changed.
    [[nodiscard]] virtual bool takes_results() = 0;
    /// Sends a Failure and ends the session, because master and worker disagree on the state.
    virtual void refuse(const Error& error) = 0;
    [[nodiscard]] virtual bool is_open() const = 0;
    /// Whether the master runs on this host.
    [[nodiscard]] virtual bool is_within_host() const = 0;
};

/// The base of a session. Its parts are members of the class that derives from it, so they live
/// while a pointer to the hub is held. All members run on the executor's home.
class SessionHub : public std::enable_shared_from_this<SessionHub> {
  public:
    explicit SessionHub(Executor& executor) : executor_(executor) {}
    SessionHub(const SessionHub&) = delete;
    SessionHub& operator=(const SessionHub&) = delete;
    virtual ~SessionHub() { over_->store(true); }

    /// Posts one `settle` for all events that arrive together.
    void settle_soon();
    /// Runs `job` on a thread, then its continuation on `home()`; skips both if the session is
    /// over.
    void run_on_thread(std::function<Executor::Continuation()> job);

    /// Time for which results may wait for others before they are sent to the master, as of the
    /// last work unit. Long if the master has many workers.
    [[nodiscard]] std::chrono::milliseconds results_wait() const { return results_wait_; }
    void set_results_wait(std::chrono::milliseconds wait) { results_wait_ = wait; }

    [[nodiscard]] const asio::any_io_executor& home() const { return executor_.home(); }
    [[nodiscard]] unsigned threads() const { return executor_.threads(); }
    /// A flag that threads check: true once the session is over.
    [[nodiscard]] std::shared_ptr<const std::atomic<bool>> over() const { return over_; }

  protected:
    /// Acts on all events since the last call.
    virtual void settle() = 0;
    /// Returns false if the session is over already.
    bool end_threads() { return !over_->exchange(true); }

  private:
    Executor& executor_;
    std::shared_ptr<std::atomic<bool>> over_ = std::make_shared<std::atomic<bool>>(false);
    std::chrono::milliseconds results_wait_{0};
    bool settling_ = false; ///< True: a `settle` is posted and has not run.
};

} // namespace cd
