#include "master/server.hpp"

#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/core/version.hpp"
#include "master/client_session.hpp"
#include "master/worker_session.hpp"

namespace cd {

namespace {

std::string peer_name(const asio::ip::tcp::socket& socket) {
    boost::system::error_code ignored;
    const auto end = socket.remote_endpoint(ignored);
    return end.address().to_string() + ":" + std::to_string(end.port());
}

} // namespace

Result<std::unique_ptr<Server>> Server::listen(const asio::any_io_executor& executor,
                                               const Endpoint& endpoint,
                                               Coordinator& coordinator,
                                               std::shared_ptr<const TlsSlot> tls) {
    Result<std::unique_ptr<Listener>> listener = Listener::open(executor, endpoint);
    if (!listener) {
        return listener.error();
    }
    return std::unique_ptr<Server>(
        new Server(std::move(listener.value()), coordinator, std::move(tls)));
}

Server::Server(std::unique_ptr<Listener> listener,
               Coordinator& coordinator,
               std::shared_ptr<const TlsSlot> tls)
    : listener_(std::move(listener)), coordinator_(coordinator), tls_(std::move(tls)) {}

void Server::start() {
    listener_->start([this](asio::ip::tcp::socket socket) { accept(std::move(socket)); });
}

void Server::close() {
    listener_->close();
    for (const auto& [connection, channel] : connections_) {
        if (channel != nullptr) {
            channel->close();
        }
    }
}

void Server::accept(asio::ip::tcp::socket socket) {
    if (connections_.size() >= limits::connections_max) {
        spdlog::warn("connection refused: reason=\"{} are open\"", connections_.size());
        return;
    }
    const std::uint64_t connection = ++connection_last_;
    connections_.emplace(connection, nullptr);
    spawn(coordinator_.executor(), "session", serve(connection, std::move(socket)));
}

asio::awaitable<void> Server::serve(std::uint64_t connection, asio::ip::tcp::socket socket) {
    const std::string peer = peer_name(socket);
    const Result<std::shared_ptr<Channel>> channel =
        co_await accept_channel(std::move(socket), tls_->now);
    if (channel) {
        connections_[connection] = channel.value();
        co_await converse(channel.value());
    } else {
        spdlog::warn("connection refused: peer={} reason=\"{}\"", peer, channel.error().detail);
    }
    connections_.erase(connection);
}

asio::awaitable<void> Server::converse(std::shared_ptr<Channel> channel) {
    const Result<Hello> hello = co_await accept_hello(channel);
    if (!hello) {
        spdlog::info(
            "greeting failed: peer={} error=\"{}\"", channel->peer(), hello.error().detail);
        co_return;
    }
    Welcome welcome;
    welcome.cluster = coordinator_.cluster();
    welcome.version = negotiate(hello.value()).value();
    welcome.build = version;
    if (hello.value().role == Role::Peer) {
        Failure failure;
        failure.detail = "this is a master; workers fetch from each other";
        channel->send(failure);
        channel->close(true);
    } else if (hello.value().role == Role::Worker) {
        const WorkerId worker = coordinator_.new_worker_id();
        welcome.id = worker.value;
        welcome.peer_key = random_secret();
        channel->send(welcome);
        const auto session = std::make_shared<WorkerSession>(coordinator_, channel, worker);
        co_await session->run(hello.value(), welcome.peer_key);
    } else {
        welcome.id = connection_last_;
        channel->send(welcome);
        co_await std::make_shared<ClientSession>(coordinator_, channel)->run();
    }
}

} // namespace cd
