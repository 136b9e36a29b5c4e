#include "master/worker_session.hpp"

#include "common/core/check.hpp"
#include "common/core/limits.hpp"
#include "master/mutation.hpp"
#include "proto/codec.hpp"

namespace cd {

WorkerSession::WorkerSession(Coordinator& coordinator,
                             std::shared_ptr<Channel> channel,
                             const Reception& reception)
    : coordinator_(coordinator),
      channel_(std::move(channel)),
      reception_(reception),
      worker_(reception.worker),
      heartbeat_(coordinator.executor()),
      room_(coordinator.executor(), asio::steady_timer::time_point::max()) {}

asio::awaitable<void> WorkerSession::run(Hello hello) {
    const auto self = shared_from_this();
    coordinator_.worker_joined(reception_, hello, channel_);
    spawn(coordinator_.executor(), "heartbeats to a worker", send_heartbeats(self));
    std::string why;
    for (;;) {
        Result<Message> message = co_await channel_->receive(coordinator_.times().lost_after);
        if (!message && message.error().code == ErrorCode::Timeout && channel_->is_open()) {
            continue; // Whether the worker is lost does not hang on whole messages.
        }
        if (!message) {
            why = message.error().detail;
            break;
        }
        if (!coordinator_.worker_heard(worker_, *channel_)) {
            break;
        }
        std::visit([this](auto& content) { on(content); }, message.value());
        // A worker that is faster than the merge is read more slowly.
        while (results_in_hand_ >= limits::results_in_hand_max && !mutated(Mutation::ReadsOn)) {
            coordinator_.worker_unheard(worker_, *channel_);
            boost::system::error_code ignored;
            co_await room_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
            // It is listened to again, and its silence counts from now on.
            (void)coordinator_.worker_heard(worker_, *channel_);
        }
    }
    channel_->close();
    heartbeat_.cancel();
    coordinator_.connection_ended(worker_, *channel_, why);
}

// It begins some time after it was spawned, and the session may have ended by then.
asio::awaitable<void> WorkerSession::send_heartbeats(std::shared_ptr<WorkerSession> self) {
    Heartbeat heartbeat;
    while (self->channel_->is_open()) {
        ++heartbeat.sequence;
        self->channel_->send(heartbeat);
        self->heartbeat_.expires_after(self->coordinator_.times().heartbeat);
        boost::system::error_code ignored;
        co_await self->heartbeat_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

void WorkerSession::on(const Heartbeat& message) {
    coordinator_.heartbeat_came(worker_, message);
}

void WorkerSession::on(const Evicted& message) {
    coordinator_.evicted(worker_, message);
}

void WorkerSession::on(const Holding& message) {
    coordinator_.cuts_held(worker_, message);
}

void WorkerSession::on(const Standing& message) {
    coordinator_.worker_stands(worker_, message);
}

void WorkerSession::on(const Drain& /*message*/) {
    coordinator_.worker_draining(worker_);
}

void WorkerSession::on(const Failure& message) {
    coordinator_.cut_off(worker_, {message.code, "it says: " + message.detail});
}

void WorkerSession::on(Results& message) {
    ++results_in_hand_;
    CD_CHECK(results_in_hand_ <= limits::results_in_hand_max);
    coordinator_.results_came(worker_, std::move(message), [self = shared_from_this()] {
        --self->results_in_hand_;
        self->room_.cancel();
    });
}

void WorkerSession::on(const EndOfTask& message) {
    coordinator_.task_ended(worker_, message.task);
}

void WorkerSession::on(const Recalled& message) {
    coordinator_.task_recalled(worker_, message);
}

template <class Other>
void WorkerSession::on(const Other& message) {
    const std::string name(message_name(message_type(message)));
    coordinator_.cut_off(worker_, {ErrorCode::BadFrame, "a worker does not send '" + name + "'"});
}

void WorkerSession::on(const WantSubtrees& message) {
    coordinator_.blocks_wanted(worker_, message);
}

void WorkerSession::on(const Held& message) {
    coordinator_.blocks_held(worker_, message);
}

void WorkerSession::on(const FetchFailed& message) {
    coordinator_.peer_failed(worker_, message);
}

} // namespace cd
