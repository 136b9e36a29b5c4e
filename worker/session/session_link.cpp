#include "worker/session/session_link.hpp"

#include "common/core/host/log.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/codec/codec.hpp"

#include <utility>

namespace cd {

SessionTimes SessionTimes::of(const Welcome& welcome) {
    const std::chrono::milliseconds heartbeat(welcome.heartbeat_ms);
    SessionTimes times;
    times.heartbeat = std::max(heartbeat, timing::heartbeat_period_min);
    times.silent_after = limits::heartbeats_missed_max * times.heartbeat;
    const std::chrono::milliseconds lost_after(welcome.lost_after_ms);
    times.lost_after = std::max(lost_after, times.silent_after);
    return times;
}

SessionLink::SessionLink(SessionHub& hub,
                         std::shared_ptr<Channel> channel,
                         std::shared_ptr<CarryOver> keep,
                         const SessionTimes& times,
                         Calls calls)
    : hub_(hub),
      channel_(std::move(channel)),
      keep_(std::move(keep)),
      times_(times),
      calls_(std::move(calls)),
      heartbeat_timer_(hub.home()) {}

void SessionLink::begin(std::vector<Sha256> cuts) {
    if (!cuts.empty()) {
        channel_->send(Holding{std::move(cuts)});
    }
    const std::vector<Results> again = keep_->results.again();
    if (!again.empty()) {
        log_info("results sent again: messages={}", again.size());
    }
    for (const Results& results : again) {
        channel_->send(results);
    }
    channel_->send(Inventory{}); // Marks the end of the kept results.
}

// The inventory shows the master which of the master's messages were lost.
void SessionLink::resume(std::shared_ptr<Channel> channel, const Inventory& inventory) {
    channel_ = std::move(channel);
    reason_.clear();
    met_silence_ = false;
    const Message message(inventory);
    if (encode_message(message).size() > payload_bytes_max(message_type(message))) {
        // The end costs only the unfinished tasks: the next session keeps the cache and the
        // results, and reports the cached blocks in one message per tree.
        return end(SessionEnd::Disagreed, "its inventory exceeds the limit of a message");
    }
    for (const auto& [sequence, results] : keep_->results.messages()) {
        channel_->send(results);
    }
    log_info("session resumed: tasks={} results_again={}",
             inventory.tasks.size(),
             keep_->results.messages().size());
    channel_->send(message);
}

asio::awaitable<SessionEnd> SessionLink::serve() {
    const std::shared_ptr<SessionHub> hub = hub_.shared_from_this();
    const std::shared_ptr<Channel> channel = channel_;
    spawn(hub->home(), "heartbeats", send_heartbeats(hub));
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
        if (const Status status = calls_.handle(message.value()); !status) {
            refuse(status.error());
        }
    }
    heartbeat_timer_.cancel();
    // A channel already closed with a flush still sends its last message.
    if (channel->is_open()) {
        channel->close();
    }
    co_return end_;
}

asio::awaitable<void>
SessionLink::send_heartbeats([[maybe_unused]] std::shared_ptr<SessionHub> hub) {
    const std::shared_ptr<Channel> channel = channel_;
    while (channel->is_open()) {
        calls_.send_heartbeat();
        heartbeat_timer_.expires_after(times_.heartbeat);
        boost::system::error_code ignored;
        co_await heartbeat_timer_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

void SessionLink::send_results(Results results) {
    keep_->results.add(results);
    channel_->send(results);
}

bool SessionLink::takes_results() {
    if (!keep_->results.has_room()) {
        return false; // The next acknowledgement settles the session.
    }
    if (channel_->queued_bytes() < limits::write_queue_bytes_max) {
        return true;
    }
    if (!std::exchange(waiting_for_queue_, true)) {
        spawn(hub_.home(), "results queue", settle_when_sent(hub_.shared_from_this()));
    }
    return false;
}

asio::awaitable<void> SessionLink::settle_when_sent(std::shared_ptr<SessionHub> hub) {
    const std::shared_ptr<Channel> channel = channel_;
    co_await channel->wait_until_queued_below(limits::write_queue_bytes_max / 2);
    waiting_for_queue_ = false;
    hub->settle_soon();
}

void SessionLink::refuse(const Error& error) {
    if (has_ended()) {
        return;
    }
    log_error("disagreement with the master: error=\"{}\"", error.detail);
    Failure failure;
    failure.code = error.code;
    failure.detail = error.detail;
    channel_->send(failure);
    end(SessionEnd::Disagreed, error.detail, true);
}

void SessionLink::end(SessionEnd how, std::string reason, bool flush) {
    end_ = how;
    reason_ = std::move(reason);
    channel_->close(flush);
}

} // namespace cd
