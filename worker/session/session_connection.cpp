// A session's connections: the messages at the start of each, heartbeats, and the end.
#include "common/core/host/log.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "proto/codec/codec.hpp"
#include "worker/session/session.hpp"

#include <algorithm>
#include <utility>

namespace cd {

SessionTimes SessionTimes::of(const Welcome& welcome) {
    const std::chrono::milliseconds heartbeat(welcome.heartbeat_ms);
    SessionTimes times;
    times.heartbeat = std::max(heartbeat, limits::heartbeat_period_min);
    times.silent_after = limits::heartbeats_missed_max * times.heartbeat;
    const std::chrono::milliseconds lost_after(welcome.lost_after_ms);
    times.lost_after = std::max(lost_after, times.silent_after);
    return times;
}

asio::awaitable<SessionEnd> Session::run() {
    take_up();
    serve_peers();
    co_return co_await serve();
}

asio::awaitable<SessionEnd> Session::resume(std::shared_ptr<Channel> channel) {
    channel_ = std::move(channel);
    reason_.clear();
    met_silence_ = false;
    stand();
    settle_soon();
    co_return co_await serve();
}

asio::awaitable<SessionEnd> Session::serve() {
    const std::shared_ptr<Session> self = shared_from_this();
    const std::shared_ptr<Channel> channel = channel_;
    spawn(executor_.home(), "heartbeats", send_heartbeats(shared_from_this()));
    std::uint64_t bytes = 0;
    while (channel->is_open()) {
        Result<Message> message = co_await channel->receive(times_.silent_after);
        // A large message may take longer than the timeout; the connection is alive if bytes came.
        const std::uint64_t bytes_before = std::exchange(bytes, channel->traffic().bytes_received);
        if (!message && message.error().code == ErrorCode::Timeout && channel->is_open() &&
            bytes != bytes_before) {
            continue;
        }
        if (!message) {
            if (reason_.empty()) {
                reason_ = message.error().detail;
                met_silence_ = message.error().code == ErrorCode::Timeout;
            }
            break;
        }
        if (const Status status = handle(message.value()); !status) {
            refuse(status.error());
        }
    }
    heartbeat_timer_.cancel();
    // A channel already closed with a flush still sends its last message.
    if (channel->is_open()) {
        channel->close();
    }
    if (end_ != SessionEnd::Lost) {
        leave();
    }
    co_return end_;
}

/// Announces the blocks, and sends the results, kept from an earlier session.
void Session::take_up() {
    if (auto cuts = cache_.parked(); !cuts.empty()) {
        channel_->send(Holding{std::move(cuts)});
    }
    const std::vector<Results> again = keep_->results.again();
    if (!again.empty()) {
        log_info("results sent again: messages={}", again.size());
    }
    for (const Results& results : again) {
        channel_->send(results);
    }
    channel_->send(Standing{}); // Marks the end of the kept results.
}

/// Resyncs a resumed session: sends unacknowledged results again, then the inventory, from which
/// the master sees which of its messages were lost.
void Session::stand() {
    Standing standing;
    for (const TreeId tree : cache_.trees()) {
        standing.trees.push_back({tree, cache_.held(tree)});
    }
    for (const auto& [id, job] : jobs_) {
        standing.jobs.push_back(id);
    }
    for (const auto& [id, task] : tasks_) {
        standing.tasks.push_back(task.given_back());
    }
    const std::uint16_t type = message_type(Message(standing));
    if (encode_message(Message(standing)).size() > payload_bytes_max(type)) {
        reason_ = "it holds more than can be said at once";
        end_ = SessionEnd::Disagreed; // A new session reports tree by tree.
        return channel_->close();
    }
    for (const auto& [sequence, results] : keep_->results.messages()) {
        channel_->send(results);
    }
    log_info("session goes on: tasks={} unanswered={} results_again={}",
             tasks_.size(),
             unanswered(),
             keep_->results.messages().size());
    channel_->send(standing);
    held_.clear();
    (void)cache_.take_evicted();
    send_wants(fetcher_.awaited());
    if (stopping_) {
        channel_->send(Drain{});
    }
}

/// Ends the session. Later continuations from the threads change nothing.
void Session::leave() {
    if (abandoned_->exchange(true)) {
        return;
    }
    if (peers_.server != nullptr) {
        peers_.server->stop_serving();
    }
    flush_timer_.cancel();
    flush_all();
    cache_.park();
    keep_->cache = std::exchange(cache_, SubtreeCache(0));
}

asio::awaitable<void> Session::send_heartbeats(std::shared_ptr<Session> self) {
    const std::shared_ptr<Channel> channel = self->channel_;
    while (channel->is_open()) {
        self->send_heartbeat();
        self->heartbeat_timer_.expires_after(self->times_.heartbeat);
        boost::system::error_code ignored;
        co_await self->heartbeat_timer_.async_wait(
            asio::redirect_error(asio::use_awaitable, ignored));
    }
}

void Session::send_heartbeat() {
    CacheTraffic traffic{traffic_.total(), 0};
    traffic.blocks.evictions = cache_.evictions(); // Includes trees that no job uses.
    traffic.uploaded_bytes = peers_.server == nullptr ? 0 : peers_.server->uploaded_bytes();
    channel_->send(Heartbeat{++heartbeats_, cache_.bytes(), unanswered(), traffic, longest()});
    if (std::chrono::steady_clock::now() - began_ > limits::parked_trees_kept) {
        cache_.drop_parked();
    }
}

std::optional<RunningScenario> Session::longest() const {
    std::optional<RunningScenario> longest;
    const auto now = ScenarioClock::Time::now();
    for (const auto& weak : clocks_) {
        const auto clock = weak.lock();
        const auto since = clock == nullptr ? std::nullopt : clock->since();
        if (!since) {
            continue;
        }
        const double seconds = std::chrono::duration<double>(now - *since).count();
        if (!longest || seconds > longest->seconds) {
            longest = RunningScenario{clock->job(), clock->scenario(), std::max(0.0, seconds)};
        }
    }
    return longest;
}

std::uint64_t Session::unanswered() const {
    std::uint64_t unanswered = 0;
    for (const auto& [id, task] : tasks_) {
        unanswered += task.unanswered();
    }
    return unanswered;
}

} // namespace cd
