#include "master/net/worker_session.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"
#include "proto/codec/codec.hpp"

#include <utility>

namespace cd {

namespace {

/// RAII: counts one result message in the worker's intake, until `leave` or destruction.
class PlaceInHand {
  public:
    explicit PlaceInHand(std::shared_ptr<WorkerIntake> intake) : intake_(std::move(intake)) {
        ++intake_->messages;
    }
    PlaceInHand(const PlaceInHand&) = delete;
    PlaceInHand& operator=(const PlaceInHand&) = delete;
    ~PlaceInHand() { leave(); }

    void leave() {
        if (const auto intake = std::exchange(intake_, nullptr)) {
            --intake->messages;
            intake->has_room();
        }
    }

  private:
    std::shared_ptr<WorkerIntake> intake_; ///< Null after `leave`.
};

} // namespace

WorkerSession::WorkerSession(Coordinator& coordinator,
                             std::shared_ptr<Channel> channel,
                             const Reception& reception)
    : coordinator_(coordinator),
      channel_(std::move(channel)),
      reception_(reception),
      worker_(reception.worker),
      heartbeat_(coordinator.parts().executor),
      room_(coordinator.parts().executor) {}

asio::awaitable<void> WorkerSession::run(Hello hello) {
    const auto self = shared_from_this();
    coordinator_.workers().join(reception_, hello, channel_);
    spawn(coordinator_.parts().executor, "heartbeats to a worker", send_heartbeats(self));
    intake_ = coordinator_.workers().intake_of(worker_);
    intake_->has_room = [weak = weak_from_this()] {
        if (const auto session = weak.lock()) {
            session->room_.cancel();
        }
    };
    std::string why;
    for (;;) {
        co_await wait_for_room();
        Result<Message> message =
            co_await channel_->receive(coordinator_.parts().options.times.lost_after);
        if (!message && message.error().code == ErrorCode::Timeout && channel_->is_open()) {
            continue; // A large message may arrive slowly; `WorkerDirectory` detects silence.
        }
        if (!message) {
            why = message.error().detail;
            break;
        }
        if (!coordinator_.workers().heard(worker_, *channel_)) {
            break;
        }
        std::visit([this](auto& content) { on(content); }, message.value());
    }
    if (channel_->is_open()) { // False for a channel that still sends its last message.
        channel_->close();
    }
    heartbeat_.cancel();
    coordinator_.workers().connection_ended(worker_, *channel_, why);
}

asio::awaitable<void> WorkerSession::wait_for_room() {
    while (intake_->messages >= limits::results_in_hand_max && channel_->is_open() &&
           !mutated(Mutation::ReadsOn)) {
        coordinator_.workers().unheard(worker_, *channel_);
        // Wakes up periodically, because the connection may end during the wait.
        room_.expires_after(coordinator_.parts().options.times.heartbeat);
        boost::system::error_code ignored;
        co_await room_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        // Reading resumes, so silence counts from now on.
        (void)coordinator_.workers().heard(worker_, *channel_);
    }
}

// Static with a shared pointer, because the session may end before the spawned coroutine starts.
asio::awaitable<void> WorkerSession::send_heartbeats(std::shared_ptr<WorkerSession> self) {
    Heartbeat heartbeat;
    while (self->channel_->is_open()) {
        ++heartbeat.sequence;
        self->channel_->send(heartbeat);
        self->heartbeat_.expires_after(self->coordinator_.parts().options.times.heartbeat);
        boost::system::error_code ignored;
        co_await self->heartbeat_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

void WorkerSession::on(const Heartbeat& message) {
    coordinator_.workers().heartbeat_came(worker_, message);
}

void WorkerSession::on(const Evicted& message) {
    coordinator_.worker_desk().came(worker_, message);
}

void WorkerSession::on(const Holding& message) {
    coordinator_.worker_desk().came(worker_, message);
}

void WorkerSession::on(const Inventory& message) {
    coordinator_.worker_desk().came(worker_, message);
}

void WorkerSession::on(const Drain& /*message*/) {
    coordinator_.worker_desk().draining(worker_);
    channel_->send(Drain{}); // Arrives after all messages queued for the worker.
}

void WorkerSession::on(const Failure& message) {
    coordinator_.workers().cut_off(worker_, {message.code, "it says: " + message.detail});
}

void WorkerSession::on(Results& message) {
    const auto place = std::make_shared<PlaceInHand>(intake_);
    CD_CHECK(intake_->messages <= limits::results_in_hand_max);
    coordinator_.worker_desk().came(worker_, std::move(message), [place] { place->leave(); });
}

void WorkerSession::on(const EndOfTask& message) {
    coordinator_.worker_desk().came(worker_, message);
}

void WorkerSession::on(const Recalled& message) {
    coordinator_.worker_desk().came(worker_, message);
}

template <class Other>
void WorkerSession::on(const Other& message) {
    const std::string name(message_name(message_type(message)));
    coordinator_.workers().cut_off(worker_,
                                   {ErrorCode::BadFrame, "a worker does not send '" + name + "'"});
}

void WorkerSession::on(const WantSubtrees& message) {
    coordinator_.worker_desk().came(worker_, message);
}

void WorkerSession::on(const Held& message) {
    coordinator_.worker_desk().came(worker_, message);
}

void WorkerSession::on(const FetchFailed& message) {
    coordinator_.worker_desk().came(worker_, message);
}

} // namespace cd
