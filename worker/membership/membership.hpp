// A worker's membership in its cluster, across connections and sessions.
#pragma once

#include "worker/session/session.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace cd {

/// The way in which a session, or its connection, ended.
struct Served {
    SessionEnd how = SessionEnd::Lost;
    std::string reason; ///< Why the session was lost; for logs.
};

/// Owns the session, which the next connection may resume, and the state that outlives a session:
/// unacknowledged results and subtrees. All members run on the executor's home.
class Membership {
  public:
    Membership(Executor& executor, std::uint64_t cache_bytes, const UnkeptBounds& bounds = {});
    Membership(const Membership&) = delete;
    Membership& operator=(const Membership&) = delete;

    /// Greets the master and serves it until the connection or the session ends. Fills in the
    /// session of `hello` and the key of `peers`. Errors: those of `greet`.
    [[nodiscard]] asio::awaitable<Result<Served>>
    serve(std::shared_ptr<Channel> channel, Hello hello, PeerParts peers);

    /// Drains the session, or the next session if none is connected; then `serve` returns Drained.
    /// Shortly before `timeout` the worker returns the running scenarios too, so that the master
    /// has time to acknowledge. At `timeout` the worker drops everything and calls `out_of_time`.
    /// Returns false if there is nothing to drain: no connection, no task and no unacknowledged
    /// result.
    [[nodiscard]] bool drain(std::chrono::milliseconds timeout, std::function<void()> out_of_time);
    /// Whether `drain` was called.
    [[nodiscard]] bool is_draining() const { return is_draining_; }
    /// Whether a master has accepted the worker on a connection that has not ended.
    [[nodiscard]] bool is_connected() const { return is_connected_; }
    /// Whether tasks or unacknowledged results remain.
    [[nodiscard]] bool has_work() const;
    /// Logs for each job the results that no master has acknowledged. Call it after `end`, which
    /// adds the results of tasks that had not ended.
    void log_unkept() const;
    /// Ends the session, so that other workers get no more blocks from this one.
    void end();

    /// Timeout of a greeting step; shorter while a session can resume. A master busy with
    /// reconnecting workers may be silent for longer than its heartbeats promise, and further
    /// reconnects would add load. Therefore each silence soon after a connect doubles the silence
    /// timeout; a connection that lasts resets the timeout.
    [[nodiscard]] std::chrono::milliseconds patience() const;
    /// The session that runs or may resume; null if there is no session.
    [[nodiscard]] Session* session() const { return session_.get(); }
    /// Scenarios computed in all sessions.
    [[nodiscard]] std::uint64_t scenarios_computed() const { return keep_->computed->load(); }
    [[nodiscard]] const UnkeptResults& unkept() const { return keep_->results; }

  private:
    void learn_from(bool was_silent, std::chrono::steady_clock::duration lasted);
    asio::awaitable<void> watch_drain(std::chrono::milliseconds to_finish,
                                      std::chrono::milliseconds last,
                                      std::function<void()> out_of_time);

    Executor& executor_;
    std::shared_ptr<CarryOver> keep_;
    std::shared_ptr<Session> session_; ///< Kept without a connection while it may resume.
    std::uint64_t session_id_ = 0;
    std::uint64_t epoch_ = 0;
    SessionTimes times_;
    std::chrono::milliseconds silence_borne_{0}; ///< The silence timeout.
    bool is_connected_ = false; ///< True from a Welcome to the end of its connection.
    bool is_draining_ = false;
    asio::steady_timer drain_timer_;
};

} // namespace cd
