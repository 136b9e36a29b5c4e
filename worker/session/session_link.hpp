// A session's connection to its master; when it breaks, another connection may replace it.
#pragma once

#include "common/core/limits/wire.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/channel.hpp"
#include "worker/session/carry_over.hpp"
#include "worker/session/session_hub.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// The way in which a session, or its connection, ended.
enum class SessionEnd {
    Lost,       ///< The connection broke; another one may resume the session.
    Disagreed,  ///< Master and worker disagree on the state; a new session follows.
    Drained,    ///< All work is answered or returned.
    Terminated, ///< The master sent Terminate.
};

/// Heartbeat timing, as set by the master.
struct SessionTimes {
    std::chrono::milliseconds heartbeat = timing::heartbeat_period;
    /// Silence after which the worker considers its connection broken.
    std::chrono::milliseconds silent_after =
        limits::heartbeats_missed_max * std::chrono::milliseconds(timing::heartbeat_period);
    /// Silence after which the master reassigns the worker's tasks. Not below `silent_after`.
    std::chrono::milliseconds lost_after = timing::peer_lost_after;

    [[nodiscard]] static SessionTimes of(const Welcome& welcome);
};

/// Receives messages, sends heartbeats, notices silence, and keeps results until the master
/// acknowledges them, over one or more connections.
class SessionLink : public MasterLink {
  public:
    struct Calls {
        /// Handles a message of the master. An error ends the session.
        std::function<Status(Message&)> handle;
        std::function<void()> send_heartbeat;
    };

    SessionLink(SessionHub& hub,
                std::shared_ptr<Channel> channel,
                std::shared_ptr<CarryOver> keep,
                const SessionTimes& times,
                Calls calls);

    /// Begins a session: sends `cuts`, whose blocks are cached, and results of earlier sessions.
    void begin(std::vector<Sha256> cuts);
    /// Continues the session over another connection: sends unacknowledged results again, then the
    /// inventory. Ends the session if the inventory exceeds the limit of a message.
    void resume(std::shared_ptr<Channel> channel, const Inventory& inventory);
    /// Handles messages until the connection ends. Returns why the session ended; Lost if another
    /// connection may resume it.
    [[nodiscard]] asio::awaitable<SessionEnd> serve();

    void send(const Message& message) override { channel_->send(message); }
    void send_results(Results results) override;
    [[nodiscard]] bool takes_results() override;
    void refuse(const Error& error) override;
    [[nodiscard]] bool is_open() const override { return channel_->is_open(); }
    [[nodiscard]] bool is_within_host() const override { return channel_->is_within_host(); }

    /// Ends the session and closes the connection. With `flush`, sends queued messages first.
    void end(SessionEnd how, std::string reason = {}, bool flush = false);
    void results_kept(std::span<const std::uint64_t> sequences) { keep_->results.kept(sequences); }
    [[nodiscard]] bool has_unkept_results() const { return !keep_->results.empty(); }

    /// Replaces the silence timeout of `SessionTimes`, from the next connection on.
    void bear_silence_for(std::chrono::milliseconds time) { times_.silent_after = time; }
    /// Whether the last connection ended by the silence timeout.
    [[nodiscard]] bool met_silence() const { return met_silence_; }
    [[nodiscard]] bool has_ended() const { return end_ != SessionEnd::Lost; }
    /// Why the last connection or the session was lost, for logs.
    [[nodiscard]] const std::string& reason() const { return reason_; }

  private:
    // Coroutines keep the hub alive, because they may run after the session has ended.
    asio::awaitable<void> send_heartbeats(std::shared_ptr<SessionHub> hub);
    asio::awaitable<void> settle_when_sent(std::shared_ptr<SessionHub> hub);

    SessionHub& hub_;
    std::shared_ptr<Channel> channel_;
    std::shared_ptr<CarryOver> keep_;
    SessionTimes times_;
    Calls calls_;
    SessionEnd end_ = SessionEnd::Lost; ///< Lost until the session ends.
    std::string reason_;
    bool met_silence_ = false;
    bool waiting_for_queue_ = false; ///< True: `settle_when_sent` is running.
    asio::steady_timer heartbeat_timer_;
};

} // namespace cd
