// A worker's membership in its cluster, over all of its connections.
#pragma once

#include "worker/session/session.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace cd {

/// How a session, or its connection, ended.
struct Served {
    SessionEnd how = SessionEnd::Lost;
    std::string reason; ///< Of a session that was lost.
};

/// Owns the session, which may be resumed over the next connection, and what outlives a session:
/// results that are not acknowledged, and subtrees. All members run on the executor's home.
class Membership {
  public:
    Membership(Executor& executor, std::uint64_t cache_bytes, const UnkeptBounds& bounds = {});
    Membership(const Membership&) = delete;
    Membership& operator=(const Membership&) = delete;

    /// Greets the master and serves it until the connection or the session ends. `hello`: of this
    /// process; which session is to go on is put in here, as the peers' key is. Errors: of `greet`.
    [[nodiscard]] asio::awaitable<Result<Served>>
    serve(std::shared_ptr<Channel> channel, Hello hello, PeerParts peers);

    /// The session of now or of the next connection drains, and `serve` returns Drained. Of
    /// `timeout` the last part is for the master to take it all: before that, what still runs is
    /// handed back, too. At its end all is dropped and `out_of_time` called. False when there is
    /// nothing to wait for: no connection, and nothing in hand.
    [[nodiscard]] bool drain(std::chrono::milliseconds timeout, std::function<void()> out_of_time);
    /// Whether the master still lacks some results.
    [[nodiscard]] bool has_work() const;
    /// Drops the session, which has a share in the peers' server.
    void end();

    /// What a step of the greeting may take: while a session can go on, its time is short.
    /// A master that has a lot to do for each worker that comes back is silent for longer than its
    /// heartbeats promise; who then came back again would only add to that. So each silence soon
    /// after a connection was made doubles the next one that is borne, and one that lasted ends
    /// that.
    [[nodiscard]] std::chrono::milliseconds patience() const;
    /// The one that goes on or may go on over the next connection. Null: none.
    [[nodiscard]] Session* session() const { return session_.get(); }
    /// Over all sessions.
    [[nodiscard]] std::uint64_t scenarios_computed() const { return keep_->computed->load(); }
    [[nodiscard]] const UnkeptResults& unkept() const { return keep_->results; }

  private:
    void learn_from(bool was_silent, std::chrono::steady_clock::duration lasted);
    asio::awaitable<void> watch_drain(std::chrono::milliseconds to_finish,
                                      std::chrono::milliseconds last,
                                      std::function<void()> out_of_time);

    Executor& executor_;
    std::uint64_t cache_bytes_;
    std::shared_ptr<WorkerKeep> keep_;
    std::shared_ptr<Session> session_; ///< Also without a connection, as long as it may go on.
    std::uint64_t session_id_ = 0;
    std::uint64_t epoch_ = 0;
    SessionTimes times_;
    std::chrono::milliseconds silence_borne_{0};
    bool is_connected_ = false; ///< And has been welcomed.
    bool is_draining_ = false;
    asio::steady_timer drain_timer_;
};

} // namespace cd
