#include "master/net/server.hpp"

#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/version.hpp"
#include "master/identity/admission.hpp"
#include "master/identity/certificate_watch.hpp"
#include "master/net/client_session.hpp"
#include "master/net/worker_session.hpp"

#include <fstream>
#include <iterator>

namespace cd {

namespace {

/// Returns the peer's name for the quotas: its certificate's holder, else its host.
std::string name_of(const Access& access, const Channel& channel) {
    return access.holder() ? access.holder()->name : channel.peer_host();
}

} // namespace

Result<std::unique_ptr<Server>> Server::listen(const asio::any_io_executor& executor,
                                               const Endpoint& endpoint,
                                               Coordinator& coordinator,
                                               MasterIdentity* identity,
                                               const ClientLimits& clients) {
    auto listener = coordinator.parts().network.listen(executor, endpoint);
    if (!listener) {
        return listener.error();
    }
    return std::unique_ptr<Server>(
        new Server(std::move(listener.value()), coordinator, identity, clients));
}

Server::Server(std::unique_ptr<ChannelListener> listener,
               Coordinator& coordinator,
               MasterIdentity* identity,
               const ClientLimits& clients)
    : listener_(std::move(listener)),
      coordinator_(coordinator),
      identity_(identity),
      greetings_(clients.greetings),
      clients_(clients),
      quotas_(clients.quotas,
              [&coordinator](JobId job) {
                  const Result<JobStatus> status = coordinator.jobs().status(job);
                  return status && status.value().state == JobState::Running
                             ? std::optional(status.value().summary.total)
                             : std::nullopt;
              }),
      worker_quotas_(clients.workers, [](JobId) { return std::nullopt; }) {}

void Server::start() {
    restore_jobs();
    listener_->start([this](Incoming incoming) { accept(std::move(incoming)); });
}

void Server::close() {
    listener_->close();
    coordinator_.close();
    for (const auto& [connection, channel] : connections_) {
        if (channel != nullptr) {
            channel->close();
        }
    }
}

void Server::refuse_greeting(Channel& channel, const Error& error) {
    refusals_.log(LogLevel::Warning, "greeting refused", channel.peer(), error.detail);
    Failure failure;
    failure.code = ErrorCode::Refused;
    failure.detail = error.detail;
    channel.send(failure);
    channel.close(true);
}

void Server::accept(Incoming incoming) {
    Seats::Seat seat = greetings_.take(incoming.address);
    if (connections_.size() >= limits::connections_max || seat == nullptr) {
        refusals_.log(LogLevel::Warning,
                      "connection refused",
                      incoming.peer,
                      std::to_string(connections_.size()) + " are open, " +
                          std::to_string(greetings_.taken()) + " not yet greeted");
        return;
    }
    const std::uint64_t connection = ++connection_last_;
    connections_.emplace(connection, nullptr);
    spawn(coordinator_.parts().executor,
          "session",
          serve(connection, std::move(incoming), std::move(seat)));
}

asio::awaitable<void> Server::serve(std::uint64_t connection, Incoming incoming, Seats::Seat seat) {
    const std::string peer = incoming.peer;
    std::shared_ptr<const Tls> tls = identity_ == nullptr ? nullptr : identity_->tls()->now;
    const Result<std::shared_ptr<Channel>> channel = co_await incoming.accept(std::move(tls));
    if (channel) {
        connections_[connection] = channel.value();
        co_await converse(channel.value(), seat);
        // A refused peer's channel closes by itself, after it has sent the reason.
        if (channel.value()->is_open()) {
            channel.value()->close();
        }
        co_await channel.value()->wait_until_closed();
    } else {
        refusals_.log(LogLevel::Warning, "connection refused", peer, channel.error().detail);
    }
    connections_.erase(connection);
}

asio::awaitable<void> Server::converse(std::shared_ptr<Channel> channel, Seats::Seat& seat) {
    const Result<Hello> hello = co_await accept_hello(channel);
    if (!hello) {
        refusals_.log(LogLevel::Info, "greeting failed", channel->peer(), hello.error().detail);
        co_return;
    }
    const Access access =
        identity_ == nullptr ? Access() : Access(*identity_, channel->peer_identity());
    Status allowed = access.check(hello.value().role);
    if (hello.value().role == Role::Peer) {
        allowed = Error{ErrorCode::Refused, "this is a master; workers fetch from each other"};
    }
    if (allowed) {
        const auto pause = std::make_shared<asio::steady_timer>(coordinator_.parts().executor);
        if (access.identity() != nullptr) {
            spawn(coordinator_.parts().executor,
                  "certificate",
                  watch_certificate(channel, access, pause));
        }
        co_await welcome_as(channel, hello.value(), access, seat);
        pause->cancel();
        co_return;
    }
    refuse_greeting(*channel, allowed.error());
}

asio::awaitable<void> Server::welcome_as(std::shared_ptr<Channel> channel,
                                         Hello hello,
                                         Access access,
                                         Seats::Seat& seat) {
    Welcome welcome;
    welcome.cluster = coordinator_.cluster();
    welcome.build = version;
    if (hello.role == Role::Worker) {
        const std::string holder = name_of(access, *channel);
        if (const Status allowed = worker_quotas_.connect(holder); !allowed) {
            refuse_greeting(*channel, allowed.error());
            co_return;
        }
        seat.reset();
        const Reception reception = coordinator_.workers().receive(
            hello, access.holder() ? access.holder()->name : std::string());
        welcome.id = reception.worker.value;
        welcome.peer_key = reception.key;
        welcome.epoch = coordinator_.workers().epoch();
        welcome.is_resumed = reception.is_resumed;
        welcome.heartbeat_ms =
            static_cast<std::uint32_t>(coordinator_.parts().options.times.heartbeat.count());
        welcome.lost_after_ms =
            static_cast<std::uint32_t>(coordinator_.parts().options.times.lost_after.count());
        channel->send(welcome);
        const auto session = std::make_shared<WorkerSession>(coordinator_, channel, reception);
        co_await session->run(hello);
        worker_quotas_.disconnect(holder);
    } else if (hello.role == Role::Joiner) {
        channel->send(welcome);
        co_await admit(channel, access);
    } else {
        welcome.id = connection_last_;
        access.set_user(hello.user.empty() ? hello.name : hello.user);
        welcome.owner = access.owner();
        co_await serve_client(channel, welcome, access, seat);
    }
}

std::filesystem::path Server::jobs_path() const {
    return coordinator_.parts().directory / "clients";
}

// Writes the file atomically, but without a sync: if it is lost, quotas are only too generous.
void Server::save_jobs() {
    const std::filesystem::path unfinished = jobs_path().string() + ".new";
    std::ofstream file(unfinished);
    file << quotas_.jobs_text();
    file.close();
    std::error_code error;
    if (file) {
        std::filesystem::rename(unfinished, jobs_path(), error);
    }
    if (!file || error) {
        log_warning("owners of jobs not written: path={}", jobs_path().string());
    }
}

void Server::restore_jobs() {
    std::ifstream file(jobs_path());
    quotas_.restore_jobs(std::string(std::istreambuf_iterator<char>(file), {}));
}

asio::awaitable<void> Server::serve_client(std::shared_ptr<Channel> channel,
                                           Welcome welcome,
                                           Access access,
                                           Seats::Seat& seat) {
    const std::string client = name_of(access, *channel);
    if (const Status allowed = quotas_.connect(client); !allowed) {
        refuse_greeting(*channel, allowed.error());
        co_return;
    }
    seat.reset();
    if (access.holder() && access.holder()->role == CertifiedRole::Metrics) {
        channel->expect(Party::Observer);
    }
    channel->send(welcome);
    ClientQuota quota{&quotas_, client, [this] { save_jobs(); }, clients_.submission_idle_max};
    const auto session =
        std::make_shared<ClientSession>(coordinator_, channel, access, std::move(quota));
    co_await session->run();
    quotas_.disconnect(client);
}

} // namespace cd
